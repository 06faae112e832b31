"""Draws the pictures of this example from the runs in output/; what has not been run is left out.

python3 plot.py [folder]     folder: where the pictures go, default output"""

import sys

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import PowerNorm

sys.dont_write_bytecode = True
import measure
from cases import BY_NAME, CASES
from drawing import STRAIN, discs, plt, save    # beside running.py; measure has put that folder on the path
from measure import OUTPUT

NORM = PowerNorm(0.6, 0.0, 3.0)    # colours of the plastic strain


def bars(folder, picture, names):
    """The layer of particles through the axis, and the foot from below."""
    cases = [BY_NAME[name] for name in names if name in BY_NAME and measure.has_run(BY_NAME[name])]
    if not cases:
        return
    figure, grid = plt.subplots(2, len(cases), squeeze=False, layout="constrained", figsize=(3.2 * len(cases) + 0.8, 7.4),
                                gridspec_kw={"height_ratios": (1.55, 1)})
    for column, case in zip(grid.T, cases):
        shots = measure.snapshots(OUTPUT / f"{case.name}.dump")
        first, shot = ({name: np.array(values) for name, values in s.items()} for s in (shots[0][1], shots[-1][1]))
        dot = 0.92 * measure.RADIUS / case.radius
        layer = np.abs(first["y"]) < 1e-9
        x, z, epl = shot["x"][layer] * 1e3, shot["z"][layer] * 1e3, shot["epl"][layer]
        if case.quarter:
            x, z, epl = np.append(x, -x), np.append(z, z), np.append(epl, epl)
        discs(column[0], x, z, dot, epl, NORM, STRAIN, zorder=3)
        fe = measure.REFERENCE[case.wall]
        for side in (-1, 1):
            column[0].plot([side * fe["foot"]] * 2, [-0.6, 0.9], color="black", lw=1.6, zorder=4)
        column[0].plot([-3.2, 3.2], [fe["length"]] * 2, color="black", lw=1.6, zorder=4)
        column[0].axhspan(-1, -0.12, color="0.85", lw=0, zorder=1)
        column[0].set(xlim=(-8.6, 8.6), ylim=(-0.8, 23.2), ylabel="z (mm)",
                      title=f"{case.frame}, {case.radius} in R, h = {case.h}\n{case.title}, {case.wall}" + (", quarter" if case.quarter else ""))

        base = first["z"] < 1e-9
        x, y, epl = shot["x"][base] * 1e3, shot["y"][base] * 1e3, shot["epl"][base]
        if case.quarter:
            x, y, epl = np.concatenate((x, -x, -x, x)), np.concatenate((y, y, -y, -y)), np.tile(epl, 4)
        discs(column[1], x, y, dot, epl, NORM, STRAIN, zorder=3)
        column[1].add_patch(plt.Circle((0, 0), fe["foot"], fill=False, color="black", lw=1.2, zorder=4))
        column[1].set(xlim=(-8.6, 8.6), ylim=(-8.6, 8.6), xlabel="x (mm)", ylabel="y (mm)")
    figure.colorbar(ScalarMappable(norm=NORM, cmap=STRAIN), ax=grid, extend="max", shrink=0.7, label="plastic strain")
    save(figure, folder, picture)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else OUTPUT
    names = ["lagrangian-r9-h1.0-symmetry-correct", "lagrangian-r9-h1.0-contact-correct", "eulerian-r9-h1.3-symmetry-correct"]
    bars(folder, "copper", names)
    bars(folder, "copper-quick", ["lagrangian-r6-h1.0-symmetry-correct", "lagrangian-r6-h1.0-symmetry-correct-quarter"])
    bars(folder, "copper-resolution", [case.name for case in CASES if case.title == "correct" and case.wall == "symmetry" and
                                       case.frame == "lagrangian" and case.h == 1.0])


if __name__ == "__main__":
    main()
