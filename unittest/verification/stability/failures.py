#!/usr/bin/env python3
"""The known failures of each method, as tests: a method has to fail in the documented way, with numbers bounded on both sides.

failures.py <name>      one of them (names: failures.py --list). LMP=<program>. Needs nothing but Python.

Where a bound on the good side of a failure is crossed the method has become better: mend doc/limits.rst and the bound."""

import math
import os
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "examples"))

import charts
import growth
import judge
import running
from histories import largest

PROGRAM = os.environ.get("LMP") or str(charts.ROOT / "build/lmp")
FOLDER = tempfile.TemporaryDirectory(prefix="sphsolid-failure-")
complaints = []


def outcome(run):
    """(history, message of an error or nothing, closest pair in spacings) of a run."""
    run.output = pathlib.Path(FOLDER.name)
    run.variables["out"] = run.output
    _, result, _ = running.simulate(charts.HERE, os.path.abspath(PROGRAM), run, quiet=True)
    message = running.last_error(judge.files(run)[2]) if result.returncode else ""
    data = judge.data_of(run)
    end = judge.SCENES[run.scene](run, data) if data else {}
    return data, message, end


def between(what, value, low, high):
    good = low < value < high
    print(f"{what}: {value:.6g}, expected between {low:g} and {high:g}{'' if good else ': FAILED'}")
    if not good:
        complaints.append(what)


def says(what, message, words):
    good = words in message
    print(f"{what}: \"{message}\", expected \"{words}\"{'' if good else ': FAILED'}")
    if not good:
        complaints.append(what)


def runs_on(what, message):
    print(f"{what}: {'stops: ' + message + ': FAILED' if message else 'runs to its end'}")
    if message:
        complaints.append(what)


def rod(form, viscosity, **more):
    """The rod of examples/taylor; 11 x 34 particles unless refine says otherwise."""
    return outcome(charts.rod("failure", form, viscosity, "rod", form, viscosity, **more))


# ---- Eulerian frame ---------------------------------------------------------------------------------------------

def no_viscosity_clumps():
    """Without viscosity particles of the foot come close, and fall on each other with plain gradients; length and energy hold
    nevertheless."""
    length, _ = judge.finite_elements()
    for form, least, most in (("eulerian", 0.0, 0.15), ("plain", 0.0, 0.05)):
        data, message, end = rod(form, "none")
        runs_on(form, message)
        between(f"{form}: closest pair", end["closest"], least, most)
        between(f"{form}: length against finite elements", data["length_mm"][-1] / length - 1, -0.06, 0.01)
        between(f"{form}: energy error", largest(map(abs, data["energy_error"])), -1.0, 1e-10)
    _, _, end = rod("eulerian", "correct")
    between("with viscosity correct: closest pair", end["closest"], 0.17, 0.3)


def plain_foot():
    """Plain gradients widen the foot of a rod without viscosity, voids open in it."""
    _, foot = judge.finite_elements()
    data, _, _ = rod("plain", "none")
    between("foot against finite elements", data["foot_mm"][-1] / foot - 1, 0.05, 0.30)
    data, _, _ = rod("eulerian", "none")
    between("the same, gradient corrected", data["foot_mm"][-1] / foot - 1, 0.0, 0.05)


def grow(viscosity="none", mode=1, options="", tension=0.02, h=1.3):
    data, message, end = outcome(charts.grow("failure", viscosity, str(mode), tension, h, mode, viscosity=viscosity,
                                             options=options))
    runs_on(f"{viscosity}, mode {mode}", message)
    return growth.fitted(data), end["exact"], data


def tension_grows_at_the_exact_rate():
    """A lattice in tension goes to pieces at the rate of the linear theory."""
    for viscosity in ("none", "monaghan 0.5 0.5", "correct", "correct weights safe", "limited 0.5 0.5", "balsara 1 1", "front"):
        found, exact, _ = grow(viscosity)
        between(f"{viscosity}: growth rate over the exact one", found / exact, 0.99, 1.01)


def artificial_stress_lets_columns_slide():
    """Artificial stress stops columns that approach each other, but those that slide along each other go on, and faster."""
    found, exact, data = grow(mode=2, options="tensile artificial 0.3 4")
    between("columns along y: growth rate over the exact one", found / exact, 0.98, 1.02)
    without, _, _ = grow(mode=2)
    between("and over that without artificial stress", found / without, 1.3, 2.0)


def strip_tears():
    """A pulled strip loses its uniform stress at a few percent, whatever the viscosity; the Lagrangian one does not."""
    for viscosity, low, high in (("none", 0.008, 0.025), ("monaghan 1 1", 0.012, 0.06), ("correct", 0.012, 0.035)):
        _, message, end = outcome(charts.strip("failure", "strip", viscosity, "100", "eulerian", viscosity))
        runs_on(viscosity, message)
        between(f"{viscosity}: elongation from which the stress is not uniform", end["number"], low, high)
        between(f"{viscosity}: closest pair", end["closest"], 0.0, judge.PAIRED)
    _, _, end = outcome(charts.strip("failure", "strip", "lagrangian", "100", "lagrangian", "correct"))
    between("frame lagrangian: closest pair", end["closest"], 0.9, 1.0)


def foot_tears_when_refined():
    """Finer lattices take the foot of the Eulerian rod away from the finite elements, not to them."""
    _, foot = judge.finite_elements()
    coarse, _, _ = rod("eulerian", "correct")
    fine, _, _ = rod("eulerian", "correct", refine=1, steps=30000)
    between("11 x 34: foot minus finite elements (mm)", coarse["foot_mm"][-1] - foot, -0.8, 0.0)
    between("21 x 67: foot minus finite elements (mm)", fine["foot_mm"][-1] - foot, 0.2, 0.9)


def disc(viscosity, load, across=12, turns=0.1):
    """Closest pair of a disc that turns under a radial body force."""
    run = charts.Run("failure", "disc", viscosity, str(across), "turning", charts.HERE, "in.turning",
                     {"frame": "eulerian", "h": 1.5, "viscosity": viscosity, "load": load, "across": across, "turns": turns,
                      "cfl": 0.3})
    _, message, end = outcome(run)
    runs_on(f"{viscosity}, {across} columns", message)
    return end["closest"]


def disc_clumps_when_refined():
    """A turning disc under radial tension holds with 12 columns, which is too few for the instability, and clumps with 40."""
    between("12 columns: closest pair", disc("none", "1000e6"), 0.95, 1.01)
    between("40 columns: closest pair", disc("none", "1000e6", across=40), 0.0, 0.2)


def balsara_does_not_see_clumping():
    """Divergence and curl of columns that move against each other are zero, and with them the switch: the instability grows as
    without viscosity, and a disc that turns under compression clumps where the same coefficients without the switch hold it."""
    without, _, _ = grow("none")
    for viscosity, low, high in (("balsara 1 1", 0.99, 1.001), ("monaghan 1 1", 0.1, 0.5)):
        found, _, _ = grow(viscosity)
        between(f"{viscosity}: growth rate over that without viscosity", found / without, low, high)
    for viscosity, low, high in (("none", 0.0, 0.5), ("balsara 1 1", 0.0, 0.5), ("monaghan 1 1", 0.9, 1.01)):
        between(f"{viscosity}: closest pair of the disc", disc(viscosity, "-1000e6", turns=0.5), low, high)


def safe_weights_keep_less_apart():
    """What weights safe leaves out is missed where particles come close: with a1 = 0.25 those of the Eulerian foot come closer
    than with conservative weights. The width of the foot is right to 2 % with both."""
    closest = {}
    for weights in ("safe", "conservative"):
        _, message, end = rod("eulerian", f"correct weights {weights} alpha 0.25 1")
        runs_on(weights, message)
        closest[weights] = end["closest"]
        between(f"{weights}: foot against finite elements", end["number"], -0.02, 0.02)
    between("closest pair of conservative", closest["conservative"], judge.CLOSEST, 0.3)
    between("the same of safe over it", closest["safe"] / closest["conservative"], 0.3, 0.95)


# ---- Lagrangian frame -------------------------------------------------------------------------------------------

def rod_400():
    """At 400 m/s, without viscosity, the deformation is more than the Lagrangian frame can follow, and it says so. (With
    "correct" it is chance.)"""
    data, message, _ = rod("lagrangian", "none", refine=1, speed="400.0", tend="80e-6", steps=60000)
    says("ends", message, "the deformation is beyond what this frame can follow")
    says("and says what to do", message, "Use frame eulerian")
    between("time of the end (us)", data["t_us"][-1], 35.0, 50.0)


def jittered_strip():
    """Particles displaced by a quarter of a spacing: stress is spread from the start, and the strip ends with partners on
    top of each other long before a strip on a lattice would."""
    def strip(jitter):
        return outcome(charts.strip("failure", "strip", "jitter", str(jitter), "lagrangian", "correct", jitter=jitter,
                                    stretch=0.5, rows=10, cfl=0.6, every=50, steps=100000))

    data, message, _ = strip(0.25)
    says("ends", message, "the deformation is beyond what this frame can follow")
    between("elongation at the end", data["elongation"][-1], 0.30, 0.48)
    early = min(range(len(data["elongation"])), key=lambda k: abs(data["elongation"][k] - 0.02))
    between("least to largest stress over the mean at 2 %",
            (data["sxx_max_Pa"][early] - data["sxx_min_Pa"][early]) / data["sxx_Pa"][early], 1.0, 6.0)
    data, message, _ = strip(0.0)
    runs_on("on a lattice", message)


# ---- both -------------------------------------------------------------------------------------------------------

def time_step_too_long():
    """cfl 1.5 (Lagrangian frame) and 1.2 (Eulerian) still work, with 2.5 a run stops with a message, and no number in its history
    is not finite."""
    for form, works in (("lagrangian", 1.5), ("eulerian", 1.2)):
        _, message, end = rod(form, "correct", cfl=works)
        runs_on(f"{form}, cfl {works}", message)
        between(f"{form}, cfl {works}: foot against finite elements", end["number"], -0.04, 0.02)
        data, message, _ = rod(form, "correct", cfl=2.5)
        says(f"{form}, cfl 2.5: ends", message, "is not physical in step")
        says("and says why", message, "a time step that is too long")
        bad = sum(not math.isfinite(x) for xs in data.values() for x in xs)
        between(f"{form}, cfl 2.5: numbers that are not finite", bad, -1, 1)


def torn_rod_wants_small_steps():
    """Eulerian frame, h = 1.3: the foot tears, and a step that a whole rod bears ends the run; that of cfl auto does not."""
    torn = {"refine": 1, "h": 1.3, "steps": 100000}
    _, message, _ = rod("eulerian", "monaghan 0.2 0.2", cfl=1.0, **torn)
    says("cfl 1.0", message, "is not physical in step")
    _, message, end = rod("eulerian", "monaghan 0.2 0.2", cfl=0.3, **torn)
    runs_on("cfl 0.3", message)
    between("foot over that of finite elements, minus 1", end["number"], 0.0, 0.1)


def printed_heating():
    """The energy equation as printed makes energy: about as much as the uncorrected viscosity would turn into heat."""
    for form in ("eulerian", "lagrangian"):
        data, _, _ = rod(form, "correct heating printed")
        between(f"{form}: growth of the total energy over the first", largest(data["energy_error"]), 0.20, 0.50)
        data, _, _ = rod(form, "correct")
        between(f"{form}: the same, compatible", largest(map(abs, data["energy_error"])), -1, 1e-10)


def shepard_leaks():
    """Weights after the printed equation give momentum away; the conservative ones keep it."""
    data, _, _ = rod("eulerian", "correct weights shepard", jitter=0.1)
    between("shepard: momentum along the wall over m V", largest(map(abs, data["slip"])), 5e-4, 1e-2)
    data, _, _ = rod("eulerian", "correct", jitter=0.1)
    between("conservative: the same", largest(map(abs, data["slip"])), -1, 1e-12)


TESTS = {test.__name__: test for test in (
    no_viscosity_clumps, plain_foot, tension_grows_at_the_exact_rate, artificial_stress_lets_columns_slide, strip_tears,
    foot_tears_when_refined, disc_clumps_when_refined, balsara_does_not_see_clumping, safe_weights_keep_less_apart, rod_400,
    jittered_strip, time_step_too_long, torn_rod_wants_small_steps, printed_heating, shepard_leaks)}


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(TESTS))
        return
    if len(sys.argv) != 2 or sys.argv[1] not in TESTS:
        sys.exit("usage: failures.py <name> | --list")
    TESTS[sys.argv[1]]()
    if complaints:
        sys.exit(f"{len(complaints)} figures are not what is documented")


if __name__ == "__main__":
    main()
