"""A spinning elastic square: angular momentum, energy, shape."""

import math

import bodies
import methods
import stock
from catalogue import Chance, Figure, case, series
from histories import closest, drift, largest
from running import columns, snapshots

TITLE = "Spinning square"
SIDE, DENSITY, OMEGA = 1.0, 1100.0, 50.0
INERTIA = DENSITY * OMEGA * SIDE**4 / 6    # 9166.7 kg m^2/s

ABOUT = r"""
A square of rubber, side a = 1 m, :math:`\rho` = 1100 kg/m\ :sup:`3`, E = 17 MPa, :math:`\nu` = 0.45, plane strain,
begins to spin at once with :math:`\omega` = 50 rad/s, free of forces (a test of the SPHinXsys library, there with 20
x 20 particles). Centrifugal forces stretch it by some percent, and it vibrates.

Exact for ever: no momentum, :math:`L_z = \rho\, \omega\, a^4/6` = 9166.7 kg m\ :sup:`2`/s per metre, and kinetic plus
elastic energy. Particles in the middle of n x n cells have :math:`L_z (1 - 1/n^2)`: the moment of inertia of a cell
about its own middle is missing. What artificial viscosity and hourglass damping turn into heat is lost; it is given
per turn. Most of it belongs to the vibration: kinetic energy as a mean over the last half turn, against that over the
first, tells whether the rotation lives. The distance of the two closest particles tells whether the body is still
one.

Stresses are compared elsewhere: *disc* has the exact ones of a body that spins, the test *verification.Rotation* and
*examples/elastic* those of a stress that turns with its body.
"""

FIGURES = [
    Figure("Lz", "drift of the angular momentum", "{:.0e}"),
    Figure("exact", "angular momentum at the end against 9166.7", "{:+.1e}", order=True),
    Figure("momentum", "momentum, over m omega a", "{:.0e}"),
    Figure("total", "drift of the total energy", "{:.0e}"),
    Figure("lost", "energy lost in a turn", "{:.1e}", order=True),
    Figure("kinetic", "kinetic energy, last half turn against first", "{:+.1e}"),
    Figure("closest", "closest pair, in spacings", "{:.3f}"),
]
TARGETS = {"Lz": 1e-6, "momentum": 1e-12, "total": 1e-9, "lost": 1e-3, "kinetic": 0.01}
TURNS = 2


def cases(level):
    found = [case("square", method, n, weight=cost(method) * (n / 20) ** 3, turns=TURNS)
             for method in methods.METHODS if not cannot(method) for n in sizes(method, level)]
    for each in found:
        each.may_fail = FAILS.get(each.method.key, "") if each.n >= 20 else ""
    return found


FAILS = {"E-none": "particles in tension pair up, and nothing damps them",
         "E-safe": Chance("particles in tension pair up, and too little damps them")}


def sizes(method, level):
    if level == "test":
        return (10,)
    return (10, 20, 40) if method.frame == "lagrangian" else (5, 10, 20)    # the others cost three times as much


def cost(method):
    return 3.5 if method.stock else 2.5 if method.frame == "eulerian" else 1.0


def cannot(method):
    return stock.solid_body(method)


# ---- figures ------------------------------------------------------------------------------------------------

def measure(case):
    data = columns(case.csv)
    L, total, kinetic = data["Lz"], data["total_J"], data["kinetic_J"]
    p = largest(map(math.hypot, data["px"], data["py"]))
    got = {"Lz": drift(L), "exact": L[-1] / INERTIA - 1,
           "momentum": p / (DENSITY * SIDE**3 * OMEGA), "total": largest(abs(e - total[0]) for e in total) / kinetic[0],
           "kinetic": mean(data, TURNS - 0.5, TURNS) / mean(data, 0.0, 0.5) - 1,
           "closest": closest(snapshots(case.dump)[-1][1], SIDE / case.n)}
    if "viscous_J" in data:
        got["lost"] = (data["viscous_J"][-1] + data["hourglass_J"][-1]) / kinetic[0] / data["turns"][-1]
    return got


def mean(data, begin, end):
    """Of the kinetic energy between these turns."""
    inside = [e for e, turn in zip(data["kinetic_J"], data["turns"]) if begin <= turn <= end]
    return sum(inside) / len(inside)


# ---- judging ------------------------------------------------------------------------------------------------

CENTRAL = ("none", "monaghan", "limited", "balsara", "safe", "front")    # viscosities along the line of the pair


def gates(case):
    method, cell = case.method, 1.0 / case.n**2
    if method.stock:
        return {"momentum": 1e-12}
    found = {"momentum": 1e-12, "total": 1e-12, "lost": 1e-2, "kinetic": 0.01}
    if method.frame == "lagrangian":
        central = method.kind.startswith(CENTRAL)
        found.update({"Lz": 1e-12 if central else 1e-4, "exact": cell + 1e-4})
    return found


def misses(case):
    if case.method.gradient == "plain":
        return {"lost": PLAIN, "kinetic": PLAIN}
    if case.name == "E-front-20":
        return {"kinetic": TENSION}
    if case.name == "E-safe-20":
        return {"lost": Chance(TENSION), "kinetic": Chance(TENSION)}
    pairs_up = case.method.key in ("E-correct", "E-monaghan05") and case.n >= 20
    return {"lost": TENSION, "kinetic": TENSION} if pairs_up else {}


TENSION = "centrifugal tension makes particles pair up; what they gain in speed becomes heat"


PLAIN = "plain gradients see strain in a rotation, and the stress of that strain stops the square"


def common(results):
    """All methods that came to their end with the finest n that all were run with."""
    tried = {}
    for each in results:
        tried.setdefault(each.case.series, set()).add(each.case.n)
    n = max(set.intersection(*tried.values()))
    return [r for r in results if not r.failed and r.case.n == n]


def draw(results, file):
    import pictures
    figure, (left, right, *bodies_of) = pictures.axes(4, width=3.1)
    for each in common(results):
        data, method = columns(each.case.csv), each.case.method
        if "viscous_J" in data:
            heat = [(a + b) / data["kinetic_J"][0] for a, b in zip(data["viscous_J"], data["hourglass_J"])]
            right.semilogy(data["turns"], [max(h, 1e-8) for h in heat], **pictures.look(method))
        left.plot(data["turns"], [e / data["kinetic_J"][0] for e in data["kinetic_J"]], label=pictures.label(method),
                  **pictures.look(method))
    left.set(xlabel="turns", ylabel="kinetic energy, over the first", title=f"n = {common(results)[0].case.n}")
    right.set(xlabel="turns", ylabel="heat, over the same")
    for axes, key in zip(bodies_of, (methods.DEFAULT, "E-correct")):
        body(figure, axes, next(r.case for r in common(results) if r.case.method.key == key))
    pictures.legend(figure, left)
    pictures.save(figure, file.parent, file.stem)


def body(figure, axes, case):
    import drawing
    from matplotlib.colors import Normalize
    shot = snapshots(case.dump)[-1][1]
    pressure = [p / 1e6 for p in shot["p"]]
    drawing.particles(axes, shot, 0.9 * SIDE / case.n, pressure, Normalize(-0.5, 0.5), "RdBu", unit=1.0)
    axes.set(xlim=(-0.8, 0.8), ylim=(-0.8, 0.8), title=f"pressure (MPa), {case.method.frame},\n{case.method.title}, {TURNS} turns")
    bodies.colour_bar(figure, axes)


def judge(results):
    got = {r.case.method.key: r.figures for r in common(results)}
    finest = series(results)[methods.DEFAULT]
    first = got[methods.DEFAULT]
    central = max(r.figures["Lz"] for r in common(results)
                  if r.case.method.frame == "lagrangian" and r.case.method.kind.startswith(CENTRAL))
    plain = [got[key]["kinetic"] for key in got if key.startswith("P-")]
    return (f"With n = {common(results)[0].case.n} the Lagrangian frame keeps angular momentum to {central:.0e} with central "
            f"viscosities and to {first['Lz']:.0e} with *correct*, whose forces are not central; *correct* loses "
            f"{100 * first['lost']:.2f} % of the energy in a turn ({100 * finest[-1].figures['lost']:.2f} % with n = "
            f"{finest[-1].case.n}), and that is vibration. In the Eulerian frame particles in tension "
            f"pair up, the sooner the finer the lattice: with corrected gradients kinetic energy changes by up to "
            f"{100 * max(abs(got[k]['kinetic']) for k in got if k.startswith('E-')):.0f} %. Plain gradients "
            f"lose {-100 * max(plain):.0f} to {-100 * min(plain):.0f} % of it in {TURNS} turns.")
