"""Draws the pictures of this example from the runs in output/; what has not been run is left out.

python3 plot.py [folder]     folder: where the pictures go, default output"""

import sys

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import PowerNorm

sys.dont_write_bytecode = True
import measure
from cases import BY_NAME, LATTICES, VISCOSITIES, name_of
from drawing import COLORS, STRAIN, plt, save    # beside running.py; measure has put that folder on the path
from measure import OUTPUT


def ran(names):
    return [name for name in names if name in BY_NAME and measure.has_run(BY_NAME[name])]


def lines_of(name):
    return measure.axis(measure.snapshots(OUTPUT / f"{name}.dump"))[1:]


def axes_picture(folder, picture, names, title=None):
    """Figure 9: the neutral axis at several times over the finite elements', one panel a run."""
    names = ran(names)
    if not names:
        return
    figure, grid = plt.subplots(1, len(names), squeeze=False, sharey=True, layout="constrained",
                                figsize=(4.1 * len(names) + 0.4, 4.3))
    for axes, name in zip(grid[0], names):
        case = BY_NAME[name]
        for t, color in zip(measure.AXIS_TIMES, plt.get_cmap("viridis")(np.linspace(0, 0.92, len(measure.AXIS_TIMES)))):
            axes.plot(*measure.reference_axis(t), color="0.55", lw=3.2, alpha=0.55, zorder=2)
            for moment, x, y in lines_of(name):
                if abs(moment - t) < 0.02 * t:
                    axes.plot(x, y, color=color, lw=1.2, zorder=3, label=f"{t:g} ms")
        axes.set(aspect="equal", xlim=(-8, 312), ylim=(-240, 15), xlabel="x (mm)",
                 title=f"{case.frame}, {LATTICES[case.refine]}, h = {case.h}, {case.title}")
        axes.grid(color="0.93")
    grid[0, 0].set_ylabel("y (mm)")
    grid[0, 0].plot([], [], color="0.55", lw=3.2, alpha=0.55, label="finite elements")
    grid[0, 0].legend(fontsize=8, loc="lower right")
    if title:
        figure.suptitle(title, fontsize=11)
    save(figure, folder, picture)


def kinetic_energy(folder, picture, names, title, label):
    """Figure 10: kinetic energy, to 25 ms and enlarged."""
    names = ran(names)
    if not names:
        return
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 3.8), layout="constrained")
    for name, color in zip(names, COLORS):
        data = measure.columns(OUTPUT / f"{name}.csv")
        for axes in (left, right):
            axes.plot(data["t_ms"], data["ke"], color=color, lw=1.3, label=label(BY_NAME[name]))
    for kind, style, text in (("parkes_mie_gruneisen", "--", "finite elements, C = 3600"),
                              ("parkes", ":", "finite elements, C = 4797")):
        fe = measure.reference(kind)
        for axes in (left, right):
            axes.plot(fe["t_ms"], fe["ke"], color="black", ls=style, lw=1.3, label=text)
    left.set(xlim=(0, 5), ylim=(0, 1), xlabel="time (ms)", ylabel="kinetic energy / KE0")
    right.set(xlim=(2, 25), ylim=(0, 0.25), xlabel="time (ms)")
    right.legend(fontsize=8)
    for axes in (left, right):
        axes.grid(color="0.9")
    figure.suptitle(title, fontsize=11)
    save(figure, folder, picture)


def shape(folder, picture, names, t):
    """All particles at one time, coloured by plastic strain."""
    names = ran(names)
    if not names:
        return
    norm = PowerNorm(0.5, 0.0, 0.6)
    figure, grid = plt.subplots(1, len(names), squeeze=False, layout="constrained", figsize=(4.6 * len(names) + 0.8, 4.0))
    for axes, name in zip(grid[0], names):
        case = BY_NAME[name]
        shots = measure.snapshots(OUTPUT / f"{name}.dump")
        moment, shot = min(shots, key=lambda s: abs(s[0] * 1e3 - t))
        axes.scatter(np.array(shot["x"]) * 1e3, np.array(shot["y"]) * 1e3, c=shot["epl"], s=5.0 / case.refine ** 2,
                     cmap=STRAIN, norm=norm, lw=0)
        axes.plot(*measure.reference_axis(moment * 1e3), color="black", lw=0.9)
        axes.set(aspect="equal", xlabel="x (mm)", title=f"{case.frame}, {LATTICES[case.refine]}, {case.title}, {moment * 1e3:.1f} ms")
    grid[0, 0].set_ylabel("y (mm)")
    figure.colorbar(ScalarMappable(norm=norm, cmap=STRAIN), ax=grid, extend="max", shrink=0.85, label="plastic strain")
    save(figure, folder, picture)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else OUTPUT
    viscosities = list(VISCOSITIES)
    axes_picture(folder, "fig9", [name_of("correct", h=0.8), name_of("correct", refine=2, h=0.8)] if
                 ran([name_of("correct", h=0.8)]) else [name_of("correct", suffix="-3ms")])
    axes_picture(folder, "fig9-viscosity", [name_of(key, h=0.8) for key in viscosities])
    axes_picture(folder, "fig9-h", [name_of("correct", h=h) for h in (0.8, 1.0, 1.3)])
    axes_picture(folder, "fig9-eulerian", [name_of(key, "eulerian", h=1.3) for key in viscosities])
    def by_viscosity(case):
        return case.title
    kinetic_energy(folder, "fig10", [name_of(key, h=0.8) for key in viscosities], "lagrangian, 201 x 5, h = 0.8 spacings", by_viscosity)
    kinetic_energy(folder, "fig10-eulerian", [name_of(key, "eulerian", h=1.3) for key in viscosities],
                   "eulerian, 201 x 5, h = 1.3 spacings", by_viscosity)
    kinetic_energy(folder, "fig10-h", [name_of("correct", h=h) for h in (0.8, 1.0, 1.3)] + [name_of("correct", refine=2, h=0.8)],
                   "lagrangian, correct", lambda case: f"{LATTICES[case.refine]}, h = {case.h} spacings")
    shape(folder, "shape", [name_of("correct", h=0.8), name_of("correct", "eulerian", h=1.3)], 2.0)


if __name__ == "__main__":
    main()
