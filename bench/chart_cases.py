"""The scenes of the work-precision diagram, as data: which runs, and which errors are read from them.

Inputs and measurements are those of the examples and of the verification catalogue; here is only what is run and what
counts as an error."""

import importlib
import math
import pathlib
import sys
from dataclasses import dataclass, replace

ROOT = pathlib.Path(__file__).resolve().parents[1]
OUTPUT = ROOT / "build" / "chart"
sys.path.insert(0, str(ROOT / "unittest" / "verification"))

import catalogue    # puts examples/ on the path
import methods
from running import at, columns, snapshots


@dataclass
class Run:
    chart: str
    method: methods.Method
    n: float                # resolution, as the axis title of the chart says
    level: int              # runs of level 0 are done before those of level 1, and so on
    here: pathlib.Path      # folder of the input
    case: object            # what the example's or the scene's measure() takes


@dataclass
class Chart:
    key: str
    title: str
    resolution: str         # what n is
    about: str              # rst
    errors: dict            # {name: text of the axis}
    main: str               # the one in the summary
    runs: list
    measure: object         # function of a Run: {error: number}


OURS = [m for m in methods.METHODS if not m.stock]
DEFAULT = methods.BY_KEY[methods.DEFAULT]
FEW = (methods.DEFAULT, "L-none", "L-monaghan05", "E-correct")    # at the finest resolution of the dear scenes


def example(name, *modules):
    """Modules of an example, whose names are the same in all of them; its output is ours, not examples/<name>/output."""
    folder = ROOT / "examples" / name
    sys.path.insert(0, str(folder))
    for each in ("cases", "measure"):
        sys.modules.pop(each, None)
    cases, measure = importlib.import_module("cases"), importlib.import_module("measure")
    sys.path.remove(str(folder))
    measure.OUTPUT = OUTPUT / name
    return cases, measure


def with_gradient(variables):
    """For inputs that take the gradient among the options."""
    plain = variables.get("gradient") == "plain"
    return {**{k: v for k, v in variables.items() if k != "gradient"}, **({"options": "gradient plain"} if plain else {})}


# ---- Taylor rod ----------------------------------------------------------------------------------------------

rod_cases, rod_measure = example("taylor")
REFINES = (0.5, 1, 2)
STOCK_ROD = [replace(methods.BY_KEY["ulsph"], key=f"ulsph-{q1}", title=f"smd/ulsph, Q1 = {q1}", package="ulsph",
                     variables={"viscosity": q1}) for q1 in (1.0, 0.3)]    # both styles are in in.taylor.ulsph
STOCK_ROD.append(replace(methods.BY_KEY["tlsph"], package="ulsph",
                         variables={"style": "tlsph", "viscosity": 0.06, "support": 2.0}))
HALF = replace(DEFAULT, key="L-correct-half", title="correct, half a rod", variables={**DEFAULT.variables, "part": "half"})
MIXED = [replace(methods.BY_KEY[key], key=f"{key}-mixed", title="correct, precision mixed",
                 variables={**methods.BY_KEY[key].variables, "options": "precision mixed"}) for key in (methods.DEFAULT, "E-correct")]
MIRRORED = replace(DEFAULT, key="L-correct-symmetry", title="correct, symmetry wall", variables={**DEFAULT.variables, "wall": "symmetry"})


def rod(method, refine):
    wall = "symmetry" if method.stock else method.variables.get("wall", "contact")
    support = method.variables.get("support", 3.0)    # stock: step as in the input, a tenth of range over wave speed
    stepped = {"step": f"{2e-8 / refine * support / 3.0:.3g}"} if method.stock else {"cfl": "auto"}
    case = rod_cases.Case(f"{method.key}-{refine:g}", method.title, "chart", "chart", wall, method.variables.get("h", 1.5),
                          {**method.variables, **stepped, "refine": refine}, method.script("taylor"), method.frame or "eulerian", refine)
    level = REFINES.index(refine) + (refine == 2 and method.frame != "lagrangian")
    return Run("taylor", method, 20 * refine, level, ROOT / "examples" / "taylor", case)


def rod_runs():
    for refine in REFINES:
        for method in OURS + [HALF, MIRRORED] + MIXED + STOCK_ROD:
            if refine < 2 or method.key in FEW + ("ulsph-1.0", "tlsph", "L-correct-half", "L-correct-symmetry", "L-limited05", "L-correct-mixed"):
                yield rod(method, refine)


def to_line(point, line):
    """Distance of a point from a polyline with nan between its pieces."""
    best = math.inf
    for (x0, y0), (x1, y1) in zip(line, line[1:]):
        if not math.isnan(x0 + x1):
            length = (x1 - x0) ** 2 + (y1 - y0) ** 2
            s = 0.0 if length == 0 else min(1.0, max(0.0, ((point[0] - x0) * (x1 - x0) + (point[1] - y0) * (y1 - y0)) / length))
            best = min(best, math.hypot(point[0] - x0 - s * (x1 - x0), point[1] - y0 - s * (y1 - y0)))
    return best


def on_sides(first):
    """Particles on the sides and on the free end of the rod; those on the wall are kept there by the wall."""
    right, top = max(first["x"]), max(first["y"])
    return [k for k, (x, y) in enumerate(zip(first["x"], first["y"])) if y > 1e-6 and (abs(x) > right - 1e-6 or y > top - 1e-6)]


def rod_errors(run):
    data, fe = columns(rod_measure.OUTPUT / f"{run.case.name}.csv"), rod_measure.reference(run.case.wall)
    if data["t_us"][-1] < 49.0:
        return {}
    shots = snapshots(rod_measure.OUTPUT / f"{run.case.name}.dump")
    line = list(zip(*rod_measure.outline(run.case.wall)))
    away = [to_line((1e3 * shots[-1][1]["x"][k], 1e3 * shots[-1][1]["y"][k]), line) for k in on_sides(shots[0][1])]
    history = [at(t, data["t_us"], data["ke"]) - at(t, fe["t_us"], fe["ke"]) for t in range(1, 50)]
    return {"length": abs(data["length_mm"][-1] / at(50, fe["t_us"], fe["length_mm"]) - 1),
            "foot": abs(data["foot_mm"][-1] / at(50, fe["t_us"], fe["foot_mm"]) - 1),
            "ke": math.sqrt(sum(d * d for d in history) / len(history)),
            "outline": math.sqrt(sum(d * d for d in away) / len(away)) / rod_measure.WIDTH}


# ---- Parkes beam ---------------------------------------------------------------------------------------------

beam_cases, beam_measure = example("parkes")
BEAMS = (0.5, 1, 2)


def beam(method, refine):
    h = 0.8 if method.frame == "lagrangian" else method.variables["h"]
    variables = {**with_gradient(method.variables), "h": h, "refine": refine, "tend": "3e-3", "every": round(100 * refine)}
    case = beam_cases.Case(f"{method.key}-{refine:g}", method.title, method.frame, refine, h, 3.0, variables)
    return Run("parkes", method, 200 * refine, BEAMS.index(refine) + (refine == 1 and method.frame == "eulerian") + (refine == 2),
               ROOT / "examples" / "parkes", case)


def beam_runs():
    for refine in BEAMS:
        for method in OURS:
            if refine < 1 or (refine == 1 and (method.frame == "lagrangian" or method.key == "E-correct")) or method.key == DEFAULT.key:
                yield beam(method, refine)


def beam_errors(run):
    data, fe = columns(beam_measure.OUTPUT / f"{run.case.name}.csv"), beam_measure.reference()
    if data["t_ms"][-1] < 2.95:
        return {}
    history = [at(t, data["t_ms"], data["ke"]) - at(t, fe["t_ms"], fe["ke"]) for t in (0.05 * k for k in range(1, 60))]
    return {"tip": beam_measure.distance(beam_measure.tip(data, 3.0), beam_measure.tip(fe, 3.0)) / beam_measure.LENGTH,
            "ke": math.sqrt(sum(d * d for d in history) / len(history))}


# ---- scenes of the verification catalogue ---------------------------------------------------------------------

plate_scene, piston_scene = catalogue.load("plate"), catalogue.load("piston")


def of_scene(name, method, n, level, case):
    case.output = OUTPUT / name
    return Run(name, method, n, level, catalogue.SCENES / name, case)


def plate_runs():
    for level, n in enumerate((5, 10, 14)):
        for method in methods.METHODS:
            everything = n == 5 or (n == 10 and method.frame == "lagrangian") or method.key in (methods.DEFAULT, "L-none")
            dear = n > 5 or method.frame != "lagrangian"
            if not plate_scene.cannot(method) and everything:
                yield of_scene("plate", method, n, level + dear, plate_scene.plate(method, n))
    for level, n in enumerate((5, 10, 14)):
        run = of_scene("plate", DEFAULT, n, level + (n > 5), plate_scene.plate(DEFAULT, n, "channel"))
        run.method = replace(DEFAULT, key="L-correct-channel", title="correct, in the channel")
        yield run


def plate_errors(run):
    found = plate_scene.measure(run.case)
    return {name: abs(found[name]) for name in ("period", "lost") if name in found}


def piston_runs():
    for level, n in enumerate((50, 100, 200)):
        for method in OURS:
            yield of_scene("piston", method, n, level, catalogue.case("piston", method, n))
    for method in OURS:
        if method.frame == "lagrangian":
            yield of_scene("piston", method, 400, 2, catalogue.case("piston", method, 400))


def piston_errors(run):
    found = piston_scene.measure(run.case)
    return {name: abs(found[name]) for name in ("l1", "plateau", "overshoot")}


# ---- the list ------------------------------------------------------------------------------------------------

CHARTS = [
    Chart("taylor", "Taylor rod", "spacings across the rod", r"""
The iron rod of *examples/taylor* at 200 m/s, until 50 us, against converged finite elements with the same wall: the *contact* wall,
and for the stock styles, which have no wall for solids and meet their own mirror image, the *symmetry* plane. That image is half of what it
computes: with a wall of its own it would cost half as much. Outline: root mean square distance of the particles on the sides and on the
free end from the outline of the finite elements, over the width of the rod. The finite elements carry some bulk viscosity; without it
their limit is shorter by 0.07 % and has a foot wider by 0.3 %: smaller errors than these mean nothing. Steps as recommended: *auto* of :doc:`fix_sph_solid_dt`, Courant numbers of 1.2 to 1.3 in the
Lagrangian frame and 0.5 in the Eulerian one, a tenth of the range of the kernel over the wave speed for the stock styles.
""", {"length": "length, relative", "foot": "foot, relative", "ke": "history of KE/KE0, rms", "outline": "outline, rms over width"}, "outline",
          list(rod_runs()), rod_errors),
    Chart("plate", "Oscillating plate", "spacings through the depth", r"""
The elastic plate of *examples/elastic* against the period of two-dimensional elasticity, 0.2552 s with its end face held (all styles) and
0.2625 s in a channel. Nothing is lost in truth: the energy that a run loses in a period is an error too.
""", {"period": "period, relative", "lost": "energy lost in a period"}, "period", list(plate_runs()), plate_errors),
    Chart("piston", "Elastic-plastic piston", "cells along the bar", r"""
The copper bar of the verification scene *piston* after 150 us against the exact two waves: integral of the difference of the stress over that of
the exact stress, mean stress of the plateau, and overshoot of the stress. The stock styles have no wall of their own and
no Mie-Grueneisen solid with strength.
""", {"l1": "stress, L1", "plateau": "stress of the plateau", "overshoot": "overshoot of the stress"}, "l1", list(piston_runs()), piston_errors),
    Chart("parkes", "Parkes beam", "spacings along the beam", r"""
The steel cantilever of *examples/parkes* until 3 ms against finite elements: distance of the tip, over the length of the beam, and
history of the kinetic energy. Runs in the Eulerian frame that lose their tip block before have no point.
""", {"tip": "tip at 3 ms over length", "ke": "history of KE/KE0, rms"}, "tip", list(beam_runs()), beam_errors),
]
BY_KEY = {chart.key: chart for chart in CHARTS}
