"""Takes the figures of the beam from what the runs and the finite elements wrote. Needs nothing but Python.

Lengths in mm, times in ms, energies in units of the initial kinetic energy KE0."""

import math
import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from cases import LATTICES
from histories import largest
from running import at, columns, exceeded, markdown, number, seconds, snapshots

OUTPUT = HERE / "output"
LENGTH, DEPTH = 304.8, 6.6
KE0 = 20481.0                   # J per metre of width
AXIS_TIMES = (0.5, 1, 2, 3, 5, 10, 15.8, 23.5)
KE_TIMES = (0.3, 1, 3, 5, 10)

# what `run` insists on for the gated cases, by lattice: distance of the tip from the finite elements' (mm)
GATES = {"tip 3": {1: 6.0, 2: 4.0, 4: 4.0}, "tip 15.8": {1: 12.0, 2: 6.0, 4: 6.0}, "ke 3": 0.04, "energy": 1e-10}


def reference(kind="parkes_mie_gruneisen"):
    """The finite elements: history with the columns of the runs."""
    data = columns(HERE / "reference" / f"{kind}_history.csv")
    return {"t_ms": [t * 1e3 for t in data["t_s"]], "tip_x_mm": [LENGTH + u for u in data["tip_ux_mm"]],
            "tip_y_mm": data["tip_uy_mm"], "ke": [ke / data["KE_J_per_m"][0] for ke in data["KE_J_per_m"]]}


def reference_axis(t_ms, kind="parkes_mie_gruneisen"):
    """The finite elements' axis nearest to a time: x, y."""
    data = columns(HERE / "reference" / f"{kind}_axis.csv")
    nearest = min(set(data["t_s"]), key=lambda t: abs(t * 1e3 - t_ms))
    if abs(nearest * 1e3 - t_ms) > 0.01 * t_ms:
        return [], []
    points = [(x, y) for t, x, y in zip(data["t_s"], data["x_mm"], data["y_mm"]) if t == nearest]
    return [p[0] for p in points], [p[1] for p in points]


def axis(shots):
    """The row of particles on the axis in every snapshot: (time in ms, x, y), x and y in mm."""
    first = shots[0][1]
    middle = sorted((k for k, y in enumerate(first["y"]) if abs(y) < 1e-9), key=lambda k: first["x"][k])
    return [(time * 1e3, [shot["x"][k] * 1e3 for k in middle], [shot["y"][k] * 1e3 for k in middle])
            for time, shot in shots]


def largest_gap(line):
    """Largest distance of two successive particles of the axis, over the first one between them."""
    _, x, y = line
    return max(math.hypot(x[k] - x[k - 1], y[k] - y[k - 1]) for k in range(1, len(x))) * (len(x) - 1) / LENGTH


def has_run(case):
    return (OUTPUT / f"{case.name}.csv").exists() and (OUTPUT / f"{case.name}.dump").exists()


def tip(data, t_ms):
    """Position of the tip, nan where the run ended before."""
    if data["t_ms"][-1] < t_ms - 0.05:
        return math.nan, math.nan
    return tuple(at(t_ms, data["t_ms"], data[key]) for key in ("tip_x_mm", "tip_y_mm"))


def distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


def figures(case):
    """All figures of one run."""
    data, fe = columns(OUTPUT / f"{case.name}.csv"), reference()
    lines = axis(snapshots(OUTPUT / f"{case.name}.dump"))
    tips = {t: tip(data, t) for t in (3.0, 15.8)}
    return {
        "tip": tips, "off": {t: distance(tips[t], tip(fe, t)) for t in tips},
        "ke": {t: at(t, data["t_ms"], data["ke"]) if data["t_ms"][-1] > t - 0.05 else math.nan for t in KE_TIMES},
        "energy": largest(map(abs, data["energy_error"])),
        "viscous": data["viscous"][-1], "returned": data["returned"][-1],
        "gap": max(largest_gap(line) for line in lines), "end": data["t_ms"][-1],
        "cpu": seconds(OUTPUT / f"{case.name}.log"),
    }


def missed(case, got):
    """The gates that a run misses, in words."""
    fe = reference()
    gates = [("tip at 3 ms, mm from the finite elements", got["off"][3.0], GATES["tip 3"][case.refine]),
             ("KE/KE0 at 3 ms over that of the finite elements, minus 1",
              got["ke"][3] / at(3.0, fe["t_ms"], fe["ke"]) - 1, GATES["ke 3"])]
    if case.tend > 15.8:
        gates.append(("tip at 15.8 ms, mm from the finite elements", got["off"][15.8], GATES["tip 15.8"][case.refine]))
    return exceeded(case, [*gates, ("energy error", got["energy"], GATES["energy"])])


# ---- the table ----------------------------------------------------------------------------------------------

HEAD = ("frame", "particles", "h", "viscosity", "KE 0.3", "KE 1", "KE 3", "KE 5", "KE 10", "tip at 3 ms", "off",
        "tip at 15.8 ms", "off", "viscous heat", "returned", "energy error", "largest gap", "CPU s")


def point(p):
    return "-" if math.isnan(p[0]) else f"({p[0]:.1f}, {p[1]:.1f})"


def reference_rows():
    rows = []
    for kind, title in (("parkes_mie_gruneisen", "C = 3600"), ("parkes", "C = 4797")):
        fe = reference(kind)
        rows.append(["finite elements", "", "", title] + [f"{at(t, fe['t_ms'], fe['ke']):.3f}" for t in KE_TIMES] +
                    [point(tip(fe, 3.0)), "", point(tip(fe, 15.8)), "", "", "", "", "", ""])
    return rows


def row(case, got):
    ended = "" if got["end"] > case.tend - 0.1 else f", ended at {got['end']:.2f} ms"
    title = case.title + (f", C = {case.variables['C']}" if "C" in case.variables else "")
    return ([case.frame, LATTICES[case.refine], str(case.h), title + ended] +
            [number(got["ke"][t], ".3f") for t in KE_TIMES] +
            [point(got["tip"][3.0]), number(got["off"][3.0], ".1f"), point(got["tip"][15.8]), number(got["off"][15.8], ".1f"),
             f"{got['viscous']:.3f}", f"{got['returned']:.3f}", f"{got['energy']:.0e}", f"{got['gap']:.2f}", f"{got['cpu']:.0f}"])


def table(cases):
    return markdown(HEAD, reference_rows() + [row(case, figures(case)) for case in cases if has_run(case)], left=4)
