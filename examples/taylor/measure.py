"""Reads what the runs and the finite elements wrote, and takes the figures from it. Needs nothing but Python.

Lengths in mm, times in us, energies in units of the initial kinetic energy KE0."""

import math
import pathlib
import re
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from cases import H, LATTICES, STUDIES, VISCOSITIES, WALLS, name_of
from histories import closest, largest
from running import at, columns, exceeded, markdown, number, seconds, snapshots

OUTPUT = HERE / "output"
WIDTH = 7.6
SPACING = math.sqrt(7.6 / 20 * 25.4 / 66)
TIMES = (10, 20, 30, 40)
NO_BULK = {"length": 20.571, "foot": 19.191}    # contact wall, 40 x 132 finite elements without their bulk viscosity

# what `run` insists on for the gated cases: length and foot as (finite elements, mm; allowed part of it)
GATES = {
    "eulerian": {"length": (None, 0.01), "ke": 0.02, "energy": 2e-4, "slip": 1e-12, "asymmetry": 1e-9},
    "lagrangian contact": {"length": (20.585, 0.0025), "foot": (19.13, 0.006), "ke": 0.003, "energy": 1e-10, "slip": 1e-13},
    "lagrangian symmetry": {"length": (20.61, 0.004), "foot": (17.88, 0.008), "energy": 1e-10, "slip": 1e-13},
    "lagrangian 2x": {"length": (20.585, 0.001), "foot": (19.13, 0.004), "energy": 1e-10, "slip": 1e-13},
}


def reference(wall):
    """The finite elements: history as {column: values}, named as in the runs."""
    data = columns(HERE / "reference" / f"taylor_{wall}_history.csv")
    return {"t_us": [t * 1e6 for t in data["t_s"]], "length_mm": data["L_axis_mm"], "foot_mm": data["foot_width_mm"],
            "ke": [ke / data["KE_J_per_m"][0] for ke in data["KE_J_per_m"]]}


def outline(wall, time_us=50):
    """The finite elements' outline nearest to a time: x (along the wall), y; nan between the pieces."""
    data = columns(HERE / "reference" / f"taylor_{wall}_outline.csv")
    nearest = min(set(data["t_s"]), key=lambda t: abs(t * 1e6 - time_us))
    points = [(y, x) for t, x, y in zip(data["t_s"], data["x_mm"], data["y_mm"]) if t == nearest]
    return [p[0] for p in points], [p[1] for p in points]


def asymmetry(first, shot):
    """Largest difference between a particle and its mirror image in the axis, over the width of the rod."""
    key = {(round(x * 1e8), round(y * 1e8)): k for k, (x, y) in enumerate(zip(first["x"], first["y"]))}
    mirrored = [key[(round(-x * 1e8), round(y * 1e8))] for x, y in zip(first["x"], first["y"])]
    return largest(abs(off) for k, j in enumerate(mirrored)
                   for off in (shot["x"][k] + shot["x"][j], shot["y"][k] - shot["y"][j])) * 1e3 / WIDTH


def has_run(case):
    return (OUTPUT / f"{case.name}.csv").exists() and (OUTPUT / f"{case.name}.dump").exists()


def figures(case):
    """All figures of one run."""
    data = columns(OUTPUT / f"{case.name}.csv")
    shots = snapshots(OUTPUT / f"{case.name}.dump")
    nan = [math.nan]
    return {
        "length": data["length_mm"][-1], "foot": data["foot_mm"][-1],
        "ke": [at(t, data["t_us"], data["ke"]) for t in TIMES], "ke_end": data["ke"][-1],
        "energy": largest(map(abs, data["energy_error"])), "slip": largest(map(abs, data["slip"])),
        "viscous": data.get("viscous", nan)[-1], "returned": data.get("returned", nan)[-1],
        "wall": data.get("wall", nan)[-1], "closest": closest(shots[-1][1], SPACING / case.refine * 1e-3),
        "asymmetry": [asymmetry(shots[0][1], shot) for _, shot in shots[1:]],
        "end": data["t_us"][-1], "cpu": seconds(OUTPUT / f"{case.name}.log"),
    }


def missed(case, got):
    """The gates that a run misses, in words: those that it should meet, and those it is known to miss."""
    fe, gates = reference(case.wall), GATES[case.gates]
    figures = {}    # name: (text, value, limit)
    if "ke" in gates:
        for t, ke in zip(TIMES, got["ke"]):
            figures[f"ke {t}"] = (f"KE/KE0 at {t} us minus finite elements", ke - at(t, fe["t_us"], fe["ke"]),
                                  gates["ke"])
    for name in ("length", "foot"):
        if name in gates:
            target, limit = gates[name]
            target = target or at(50, fe["t_us"], fe[f"{name}_mm"])
            figures[name] = (f"{name} {got[name]:.3f} mm over {target:.3f} mm of the finite elements, minus 1:",
                             got[name] / target - 1, limit)
    figures["energy"] = ("energy error", got["energy"], gates["energy"])
    figures["slip"] = ("momentum along the wall", got["slip"], gates["slip"])
    if "asymmetry" in gates:
        figures["asymmetry"] = ("asymmetry at 10 us", got["asymmetry"][0], gates["asymmetry"])
    return (exceeded(case, [gate for name, gate in figures.items() if name not in case.known]),
            exceeded(case, [gate for name, gate in figures.items() if name in case.known]))


# ---- the tables ---------------------------------------------------------------------------------------------

HEAD = ("viscosity", "h", "wall", "length", "foot", "KE 10", "KE 20", "KE 30", "KE 40", "viscous heat", "returned",
        "wall work", "energy error", "closest", "CPU s")


def rows(cases):
    """The table as {block: rows}; the finite elements head every block."""
    blocks = {}
    for case in cases:
        digits = 3 if case.frame == "lagrangian" else 2
        if case.block not in blocks:
            blocks[case.block] = []
            for wall in sorted({c.wall for c in cases if c.block == case.block}):
                fe = reference(wall)
                blocks[case.block].append(
                    ["finite elements", "", wall] +
                    [f"{at(50, fe['t_us'], fe[k]):.{digits}f}" for k in ("length_mm", "foot_mm")] +
                    [f"{at(t, fe['t_us'], fe['ke']):.3f}" for t in TIMES] + [""] * 6)
        got = figures(case)
        blocks[case.block].append(
            [case.title, str(case.h), case.wall, f"{got['length']:.{digits}f}", f"{got['foot']:.{digits}f}"] +
            [f"{ke:.3f}" for ke in got["ke"]] +
            [number(got[k], ".3f") for k in ("viscous", "returned", "wall")] +
            [f"{got['energy']:.0e}", f"{got['closest']:.2f}", f"{got['cpu']:.1f}"])
    return blocks


def refinement(cases, keys=("correct", "0.5"), wall="contact"):
    """[(frame, viscosity, {refine: figures})] of what has been run at the smoothing lengths of the study."""
    by_name, found = {case.name: case for case in cases}, []
    for frame in ("lagrangian", "eulerian"):
        for key in keys:
            names = {n: name_of(key, wall, H[frame], frame, n) for n in LATTICES}
            got = {n: figures(by_name[name]) for n, name in names.items() if name in by_name}
            got = {n: one for n, one in got.items() if one["end"] > 49.5}    # a line every ten steps
            if len(got) > 1:
                found.append((frame, key, got))
    return found


REFINE_HEAD = ("wall", "frame", "h", "viscosity", "particles", "length", "change", "foot", "change", "KE 10", "KE 20", "KE 30",
               "KE 40", "viscous heat", "closest", "CPU s")


def refinement_rows(cases):
    table = []
    for wall in WALLS:
        for frame, key, lattices in refinement(cases, ("correct", "limited", "none", "0.5", "1.0"), wall):
            before = None
            for n, got in lattices.items():
                table.append([wall, frame, str(H[frame]), VISCOSITIES[key][0], LATTICES[n]] + sum(
                    ([f"{got[what]:.3f}", f"{got[what] - before[what]:+.3f}" if before else ""] for what in ("length", "foot")), []) +
                    [f"{ke:.3f}" for ke in got["ke"]] + [f"{got['viscous']:.3f}", f"{got['closest']:.2f}", f"{got['cpu']:.0f}"])
                before = got
        fe = reference(wall)
        if table and table[-1][0] == wall:
            table.append([wall, "finite elements", "", "", ""] + sum(([f"{at(50, fe['t_us'], fe[k]):.3f}", ""]
                                                                     for k in ("length_mm", "foot_mm")), []) +
                         [f"{at(t, fe['t_us'], fe['ke']):.3f}" for t in TIMES] + [""] * 3)
    return table


SPEED_HEAD = ("speed (m/s)", "frame", "viscosity", "wall", "ends at (us)", "length", "foot", "over 7.6 mm", "KE", "closest", "energy error", "CPU s", "why it ended")
WHY = (("turned over", "a particle has turned over"), ("squeezed flat", "a particle is squeezed flat"),
       ("lies on a partner", "a particle lies on a partner"), ("has been lost", "a particle has left the box"), ("is not physical", "a state is not physical"))


def why(case):
    """What stopped a run, in a few words; nothing if it came to its end."""
    log = (OUTPUT / f"{case.name}.log").read_text()
    errors = re.findall(r"ERROR.*", log)
    if not errors:
        return ""
    return next((text for word, text in WHY if word in errors[-1]), errors[-1])


def speed_rows(cases):
    table = []
    for case in sorted(cases, key=lambda case: case.speed):
        if case.part == "speed":
            got = figures(case)
            table.append([f"{case.speed:g}", case.frame, case.title, case.wall, f"{got['end']:.1f}", f"{got['length']:.2f}", f"{got['foot']:.2f}",
                          f"{got['foot'] / WIDTH:.2f}", f"{got['ke_end']:.3f}", f"{got['closest']:.2f}", f"{got['energy']:.0e}",
                          f"{got['cpu']:.0f}" if got["cpu"] else "-", why(case) or "time is up"])
    return table


STEP_HEAD = ("frame", "viscosity", "cfl", "ends at (us)", "length", "foot", "KE 10", "KE 20", "KE 30", "KE 40",
             "viscous heat", "energy error", "steps", "CPU s")


def steps(log):
    return sum(int(n) for n in re.findall(r"for (\d+) steps with", pathlib.Path(log).read_text()))


def step_rows(cases):
    table = []
    for case in cases:
        if case.part == "step":
            got = figures(case)
            table.append([case.frame, case.title, f"{case.cfl:g}", f"{got['end']:.1f}", f"{got['length']:.3f}", f"{got['foot']:.3f}"] +
                         [number(ke if t <= got["end"] else math.nan, ".4f") for t, ke in zip(TIMES, got["ke"])] +
                         [f"{got['viscous']:.4f}", f"{got['energy']:.0e}", str(steps(OUTPUT / f"{case.name}.log") or "-"),
                          f"{got['cpu']:.1f}" if got["cpu"] else "-"])
    return table


def write_tables(cases):
    """All tables of what has been run: output/table.md; the text."""
    blocks = rows([case for case in cases if case.part not in STUDIES])
    parts = [(block, HEAD, table, 3) for block, table in blocks.items()]
    parts += [("finer lattices", REFINE_HEAD, refinement_rows(cases), 5), ("speeds", SPEED_HEAD, speed_rows(cases), 4),
              ("time steps", STEP_HEAD, step_rows(cases), 2)]
    text = "\n".join(f"**{block}**\n\n{markdown(head, table, left)}" for block, head, table, left in parts if table)
    (OUTPUT / "table.md").write_text(text)
    return text
