"""Reads the dumps of the runs and takes the figures from them. Needs nothing but Python."""

import math
import pathlib
import sys
from dataclasses import dataclass, field

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from histories import largest
from running import exceeded, markdown

OUTPUT = HERE / "output"
STRETCH, QUARTER = 100, 2000            # steps of in.prestress
LIMIT = 1e-3    # error of a stress component over the stress, of the gated run, for all particles


@dataclass
class Case:
    name: str                   # of the files in output/
    title: str                  # in the table and the picture
    script: str
    variables: dict = field(default_factory=dict)
    gated: bool = False         # its stress must turn with the square
    may_fail: bool = False
    weight: float = 1.0         # expected run time, relative


CASES = [
    Case("sph-solid", "sph/solid", "in.prestress", gated=True),
    Case("sph-solid-plain", "sph/solid, gradient plain", "in.prestress", {"gradient": "plain"}),
    Case("ulsph", "stock smd/ulsph, its gradient correction", "in.prestress.ulsph"),
    Case("ulsph-plain", "stock smd/ulsph, plain", "in.prestress.ulsph", {"correction": "*NO_GRADIENT_CORRECTION"}),
]
BY_NAME = {case.name: case for case in CASES}


def has_run(case):
    return (OUTPUT / f"{case.name}.dump").exists()


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
    return largest(abs(a - b) / size for i in ids
                   for a, b in zip(shear(now[i]), turned(shear(first[i]), sense * degrees)))


def figures(case):
    return {"error": error(case.name, 45, False)}


def missed(case, got):
    """The gates that a run misses, in words."""
    return exceeded(case, [("error of the stress at 45 degrees, over the stress", got["error"], LIMIT)])


HEAD = ("", "(sxx - syy)/2 at 45", "sxy at 45", "(sxx - syy)/2 at 90", "sxy at 90", "error at 45, inner", "all",
        "turned the other way: error at 45, inner")


def table(cases):
    rows = [["exact", "0", "1", "-1", "0", "0", "0", "2"]]
    for case in cases:
        if has_run(case):
            angles, values = history(case.name)
            at45, at90 = (values[min(range(len(angles)), key=lambda k: abs(angles[k] - a))] for a in (45, 90))
            rows.append([case.title] + [f"{round(v, 4) + 0.0:.4f}" for v in at45 + at90] +
                        [f"{error(case.name, 45, inner, sense):.1e}"
                         for inner, sense in ((True, 1.0), (False, 1.0), (True, -1.0))])
    return markdown(HEAD, rows)
