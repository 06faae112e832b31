"""Reads the dumps of the runs and takes the figures from them. Needs nothing but Python."""

import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
OUTPUT = HERE / "output"
STRETCH, QUARTER = 100, 2000            # steps of in.prestress
CASES = {                                   # name: (script, variables, title)
    "sph-solid": ("in.prestress", {}, "sph/solid"),
    "sph-solid-plain": ("in.prestress", {"gradient": "plain"}, "sph/solid, gradient plain"),
    "ulsph": ("in.prestress.ulsph", {}, "stock smd/ulsph, its gradient correction"),
    "ulsph-plain": ("in.prestress.ulsph", {"correction": "*NO_GRADIENT_CORRECTION"}, "stock smd/ulsph, plain"),
}
LIMIT = 1e-3    # error of a stress component over the stress, of "sph-solid", for all particles


def snapshots(name):
    """[(angle in degrees, {id: (x, y, sxx, syy, sxy)})], from the end of the stretch on."""
    shots = []
    with open(OUTPUT / f"{name}.dump") as file:
        for line in file:
            if line.startswith("ITEM: TIMESTEP"):
                step = int(next(file))
            elif line.startswith("ITEM: NUMBER"):
                count = int(next(file))
            elif line.startswith("ITEM: ATOMS"):
                rows = [next(file).split() for _ in range(count)]
                shots.append((step, {int(row[0]): tuple(map(float, row[1:6])) for row in rows}))
    return [((step - STRETCH) * 90.0 / QUARTER, atoms) for step, atoms in shots if step >= STRETCH]


def shear(atom):
    """Without the pressure: ((sxx - syy)/2, sxy). A turn by t turns this vector by 2 t."""
    return 0.5 * (atom[2] - atom[3]), atom[4]


def turned(vector, degrees):
    c, s = math.cos(math.radians(2 * degrees)), math.sin(math.radians(2 * degrees))
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]


def history(name):
    """Angles; ((sxx - syy)/2, sxy) of a particle in the middle; both over its stress after the stretch."""
    shots = snapshots(name)
    middle = min(shots[0][1], key=lambda i: math.hypot(shots[0][1][i][0], shots[0][1][i][1]))
    first = math.hypot(*shear(shots[0][1][middle]))
    return [a for a, _ in shots], [tuple(s / first for s in shear(atoms[middle])) for _, atoms in shots]


def error(name, degrees, inner, sense=1.0):
    """Largest error of a component at an angle, over the stress of the middle after the stretch.
    inner: without the three rows at each face. sense: 1 turned with the body, -1 against it."""
    shots = snapshots(name)
    first, now = shots[0][1], next(atoms for angle, atoms in shots if abs(angle - degrees) < 1e-6)
    ids = [i for i in first if not inner or max(map(abs, first[i][:2])) < 6.9e-3]
    middle = min(first, key=lambda i: math.hypot(first[i][0], first[i][1]))
    size = math.hypot(*shear(first[middle]))
    worst = 0.0
    for i in ids:
        want = turned(shear(first[i]), sense * degrees)
        worst = max(worst, *(abs(a - b) / size for a, b in zip(shear(now[i]), want)))
    return worst


HEAD = ("", "(sxx - syy)/2 at 45", "sxy at 45", "(sxx - syy)/2 at 90", "sxy at 90", "error at 45, inner", "all",
        "turned the other way: error at 45, inner")


def table(names):
    lines = ["| " + " | ".join(HEAD) + " |", "|---|" + "--:|" * (len(HEAD) - 1), "| exact | 0 | 1 | -1 | 0 | 0 | 0 | 2 |"]
    for name in names:
        angles, values = history(name)
        at45, at90 = (values[min(range(len(angles)), key=lambda k: abs(angles[k] - a))] for a in (45, 90))
        lines.append(f"| {CASES[name][2]} | " + " | ".join(f"{round(v, 4) + 0.0:.4f}" for v in at45 + at90) +
                     f" | {error(name, 45, True):.1e} | {error(name, 45, False):.1e} | "
                     f"{error(name, 45, True, -1.0):.1e} |")
    return "\n".join(lines) + "\n"
