"""Two rubber rings meet and must part whole."""

import math

import bodies
import methods
import stock
from catalogue import Chance, Figure, case, series
from histories import close_pairs, closest, drift, largest
from running import columns, snapshots

TITLE = "Colliding rubber rings"
WALL, SPEED = 10e-3, 0.059 * 852.0    # m, m/s

ABOUT = r"""
Two rings, radii 30 and 40 mm, centres 100 mm apart, meet with :math:`\pm 0.059\, c_0` (plane strain; :math:`\rho` =
1010 kg/m\ :sup:`3`, :math:`c_0` = 852 m/s, :math:`\mu = 0.22\, \rho c_0^2`, no yielding; constants of the test
RubberCylinders of the Spheral code). They flatten, and the tension on the inner side of their bends tears particles
apart for no physical reason (J. W. Swegle, D. L. Hicks, S. W. Attaway, J. Comput. Phys. 116, 123 (1995)); the
artificial stress of J. P. Gray, J. J. Monaghan and R. P. Swift (Comput. Methods Appl. Mech. Engrg. 190, 6641 (2001))
was made for this scene.

There is no exact solution. Exact are momentum (none) and total energy. The rings must part again, and be whole:
*broken* is the share of particles that do not hang together with the rest of their ring (distances below 1.6
spacings), *joined* the number of pairs of different rings that are that close at the end, 2 ms after the start.
Closest approach of the two centres of mass and rebound speed (over the first) are compared across resolutions; n
particles are the wall of a ring.

In the Lagrangian frame bodies do not feel each other, so that it cannot run this. All rows have *tensile artificial
0.3 4* but those called *bare*.
"""

FIGURES = [
    Figure("broken", "broken", "{:.3f}"),
    Figure("joined", "joined", "{:.0f}"),
    Figure("nearest", "closest approach (mm)", "{:.1f}"),
    Figure("rebound", "rebound speed", "{:+.3f}"),
    Figure("heat", "viscous heat, over the first kinetic energy", "{:.3f}"),
    Figure("pair", "closest pair, in spacings", "{:.2f}"),
    Figure("momentum", "momentum", "{:.0e}"),
    Figure("total", "drift of the total energy", "{:.0e}"),
]
TARGETS = {"broken": 1e-9, "joined": 0.5, "heat": 1.0, "momentum": 1e-12, "total": 1e-9}
HEADLINE = "E-correct"
STRESS = "artificial 0.3 4"


def cases(level):
    found = []
    for method in methods.METHODS:
        if cannot(method):
            continue
        for n in sizes(method, level):
            found += both(method, n) if not method.stock else [case("rings", method, n, weight=cost(method, n))]
    for each in found:
        each.may_fail = FAILS.get(each.method.key, "") if each.n > 4 or each.method.key == "E-none" else ""
    return found


FAILS = {"E-none": Chance("particles in tension pair up, and nothing damps them"),
         "E-safe": Chance("particles in tension pair up, and too little damps them"),
         "ulsph": "the rings are torn apart, and particles leave the box"}

ASTRAY = Chance("particles that pair up leave a ring or reach the other one")


def sizes(method, level):
    if level == "test":
        return (4,) if method.key in ("E-correct", "E-monaghan1", "E-front") else ()
    return (4, 6, 8) if method.key in ("E-correct", "E-monaghan1", "E-front") else (4, 6)


def both(method, n):
    """With artificial stress, and without; the latter on one lattice only, since it breaks."""
    found = [case("rings", method, n, weight=cost(method, n), tensile=STRESS)]
    if n == 4 and method.gradient == "corrected":
        found.append(case("rings", method, n, weight=cost(method, n), suffix="-bare", tensile="none"))
    return found


def cost(method, n):
    return (4.0 if method.stock else 1.6) * (n / 4) ** 3


def cannot(method):
    if method.frame == "lagrangian":
        return "in the Lagrangian frame bodies do not feel each other"
    return stock.solid_body(method)


# ---- figures ------------------------------------------------------------------------------------------------

def measure(case):
    data, last = columns(case.csv), snapshots(case.dump)[-1][1]
    spacing, total = WALL / case.n, data["total_J"]
    half = len(last["x"]) // 2    # the rings come one after the other
    whole = [bodies.pieces({k: last[k][part] for k in ("x", "y")}, 1.6 * spacing)[0] / half
             for part in (slice(0, half), slice(half, None))]
    found = {"broken": 1 - min(whole), "nearest": min(data["apart_mm"]), "rebound": data["rate"][-1] / -data["rate"][0],
             "joined": sum((i < half) != (j < half) for i, j, _ in close_pairs(last["x"], last["y"], 1.6 * spacing)),
             "pair": closest(last, spacing), "total": drift(total),
             "momentum": largest(map(math.hypot, data["px"], data["py"])) / (total[0] / SPEED)}
    if "viscous_J" in data:
        found["heat"] = data["viscous_J"][-1] / total[0]
    return found


# ---- judging ------------------------------------------------------------------------------------------------

def gates(case):
    exact = {"momentum": 1e-12, "total": 1e-2 if case.method.stock else 1e-12}
    return {**exact, "broken": 1e-9, "joined": 0.5, **({} if case.method.stock else {"heat": 1.0})}


def misses(case):
    torn = "without artificial stress particles in tension pair up, and the rings tear"
    if case.variables.get("tensile") == "none":
        return {"broken": torn, "joined": ASTRAY if case.method.key == "E-safe" else torn}
    pumped = "particles pair up all the same; artificial stress drives them, and what it drives becomes heat"
    if case.method.key == "E-correct" and case.n >= 8:
        return {"heat": pumped, "joined": ASTRAY}
    if case.method.key == "E-safe":
        return {"broken": ASTRAY, "joined": ASTRAY, **({"heat": pumped} if case.n >= 6 else {})}
    return {}


def draw(results, file):
    import drawing
    import pictures
    from matplotlib.colors import Normalize
    figure, grid = pictures.plt.subplots(2, 4, figsize=(11, 4.4), layout="constrained", sharex=True, sharey=True)
    for row, name in zip(grid, ("E-correct-4", "E-correct-bare-4")):
        shown = next(r.case for r in results if r.case.name == name)
        shots = snapshots(shown.dump)
        for axes, k in zip(row, (1, 3, 5, 8)):
            moment, shot = shots[min(k, len(shots) - 1)]
            values = [v / 1e6 for v in shot["vonmises"]]
            drawing.particles(axes, shot, 0.95e3 * WALL / shown.n, values, Normalize(0, 80))
            axes.set(xlim=(-95, 95), ylim=(-75, 75), title=f"{moment * 1e3:.2f} ms")
        row[0].set_ylabel("bare" if "bare" in name else "artificial stress")
    figure.colorbar(grid[0, 0].collections[0], ax=grid, shrink=0.7, label="von Mises stress (MPa)")
    pictures.save(figure, file.parent, file.stem)


def judge(results):
    runs = series(results)
    stressed = {name: group for name, group in runs.items() if group[0].case.variables.get("tensile") == STRESS}
    tried = {r.case.series for r in results if r.case.variables.get("tensile") == STRESS}    # E-none does not end
    whole = [name for name, group in stressed.items()
             if all(r.figures["broken"] < 1e-9 and not r.figures["joined"] for r in group)]
    bare = [group[-1].figures["broken"] for name, group in runs.items() if name.endswith("-bare")]
    first = runs[HEADLINE]
    return (f"With artificial stress {len(whole)} of {len(tried)} methods part whole on every lattice; without it the rings lose "
            f"{100 * min(bare):.0f} to {100 * max(bare):.0f} % of their particles. With *correct* closest approach is " +
            ", ".join(f"{r.figures['nearest']:.1f} mm (n = {r.case.n})" for r in first) + ", rebound speed " +
            ", ".join(f"{r.figures['rebound']:.2f}" for r in first) + ", viscous heat " +
            ", ".join(f"{r.figures['heat']:.2f}" for r in first) + " of the kinetic energy: where it is more than a third, "
            f"particles have paired up (closest pair {min(r.figures['pair'] for r in first):.2f} spacings) and artificial stress "
            f"drives them, so that finer is worse. *monaghan 1 1*: " +
            ", ".join(f"{r.figures['heat']:.2f}" for r in runs["E-monaghan1"]) + ", rebound speed " +
            ", ".join(f"{r.figures['rebound']:.2f}" for r in runs["E-monaghan1"]) + ".")
