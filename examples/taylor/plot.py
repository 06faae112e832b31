"""Draws the pictures of this example from the runs in output/; what has not been run is left out.

python3 plot.py [folder]     folder: where the pictures go, default output"""

import functools
import sys

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import PowerNorm

sys.dont_write_bytecode = True
import cases
import measure
from cases import BY_NAME, SMOOTHING, SMOOTHING_LAGRANGIAN, VISCOSITIES, WALLS
from drawing import COLORS, STRAIN, discs, plt, save    # beside running.py; measure has put that folder on the path
from measure import OUTPUT

GRADIENT, H, WALL = "corrected", 1.5, "contact"    # of the Eulerian pictures, which follow the article's figures
NORM = PowerNorm(0.6, 0.0, 2.5)                    # colours of the plastic strain


def name_of(key, gradient=GRADIENT, h=H, wall=WALL):
    return f"{wall}-h{h}-{gradient}-{key}"


@functools.lru_cache
def final(name):
    """Positions and plastic strain of the particles at the end of a run."""
    _, shot = measure.snapshots(OUTPUT / f"{name}.dump")[-1]
    return tuple(np.array(shot[key]) for key in ("x", "y", "epl"))


def dot_of(name, dot):
    """The diameter of a particle in a picture, which is smaller on a finer lattice."""
    return dot / BY_NAME[name].refine


def rod(axes, name, reference=None, dot=0.35, size=(-12.0, 12.0, -0.7, 22.6), numbers=True):
    """The particles at the end of a run, coloured by plastic strain, with the finite elements' outline."""
    x, y, epl = final(name)
    keep = y > -1e-5    # the stock style's run holds the mirror image too
    discs(axes, x[keep] * 1e3, y[keep] * 1e3, dot_of(name, dot), epl[keep], NORM, STRAIN, zorder=3)
    if reference:
        axes.plot(*measure.outline(reference), color="black", lw=1.8, zorder=4)
    axes.axhline(0.0, color="0.45", lw=1.0, zorder=1)
    axes.axhspan(size[2], 0.0, color="0.88", zorder=0, lw=0)
    axes.set(xlim=size[:2], ylim=size[2:])
    axes.tick_params(labelleft=numbers)
    return axes


def strain_bar(figure, axes, **more):
    bar = figure.colorbar(ScalarMappable(norm=NORM, cmap=STRAIN), ax=axes, extend="max",
                          ticks=(0, 0.1, 0.25, 0.5, 1, 1.5, 2, 2.5), **more)
    bar.set_label("plastic strain")
    return bar


def shapes(folder, picture, panels, reference=None, foot=False, width=2.9, title=None):
    """Rods beside each other: panels are (name, title); with the foot enlarged below."""
    if not all(measure.has_run(BY_NAME[name]) for name, _ in panels):
        return
    count = len(panels)
    ratios = (3.4, 1) if foot else (1,)
    figure, grid = plt.subplots(len(ratios), count, squeeze=False, layout="constrained",
                                figsize=(max(width * count + 0.8, 4.0), 4.6 if foot else 3.5),
                                gridspec_kw={"height_ratios": ratios})
    for k, (name, text) in enumerate(panels):
        wall = reference[k] if isinstance(reference, (list, tuple)) else reference
        axes = rod(grid[0, k], name, wall, numbers=k == 0)
        axes.set_title(text)
        if foot:
            rod(grid[1, k], name, wall, dot=0.36, size=(-0.3, 11.3, -0.25, 3.2), numbers=k == 0)
        grid[-1, k].set_xlabel("x (mm)")
    grid[0, 0].set_ylabel("y (mm)")
    strain_bar(figure, grid, shrink=0.85)
    if title:
        figure.suptitle(title, fontsize=11)
    save(figure, folder, picture)


def energy_curves(folder, picture, names, title):
    names = [(name, text) for name, text in names if measure.has_run(BY_NAME[name])]
    if len(names) < 2:
        return
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for (name, text), color in zip(names, COLORS):
        data = measure.columns(OUTPUT / f"{name}.csv")
        axes.plot(data["t_us"], data["ke"], color=color, lw=1.5, label=text)
    fe = measure.reference(WALL)
    axes.plot(fe["t_us"], fe["ke"], "k--", lw=1.3, label="finite elements")
    axes.set(xlim=(0, 50), ylim=(0, 1), xlabel="time (us)", ylabel="kinetic energy / KE0", title=title)
    axes.grid(color="0.9")
    axes.legend()
    save(figure, folder, picture)


def history(folder, picture, runs, solid):
    """Kinetic energy, length and foot of the corrected runs (wall, h, name) against the finite elements, both walls."""
    runs = [run for run in runs if measure.has_run(BY_NAME[run[2]])]
    if not runs:
        return
    figure, grid = plt.subplots(2, 3, figsize=(10.2, 5.0), sharex=True, layout="constrained",
                                gridspec_kw={"height_ratios": (2, 1)})
    what = (("ke", "kinetic energy / KE0"), ("length_mm", "length (mm)"), ("foot_mm", "foot width (mm)"))
    for wall, color in zip(WALLS, ("#4477aa", "#cc5511")):
        fe = measure.reference(wall)
        for column, (key, _) in enumerate(what):
            grid[0, column].plot(fe["t_us"], fe[key], color=color, lw=4, alpha=0.3, label=f"{wall}: finite elements")
            for _, h, name in (run for run in runs if run[0] == wall):
                data = measure.columns(OUTPUT / f"{name}.csv")
                style = dict(color=color, lw=1.3, ls="-" if h == solid else (0, (4, 2)), label=f"{wall}: h = {h} spacings")
                grid[0, column].plot(data["t_us"], data[key], **style)
                difference = np.array(data[key]) - np.interp(data["t_us"], fe["t_us"], fe[key])
                grid[1, column].plot(data["t_us"], difference, **style)
    for column, (_, text) in enumerate(what):
        grid[0, column].set_ylabel(text)
        grid[1, column].set(xlabel="time (us)", xlim=(0, 50))
        grid[1, column].axhline(0, color="0.4", lw=0.8)
        for axes in grid[:, column]:
            axes.grid(color="0.9")
    grid[1, 0].set(ylabel="minus finite elements", ylim=(-0.03, 0.03))
    grid[0, 0].set_ylim(0, 1)
    grid[0, 0].legend(fontsize=8)
    save(figure, folder, picture)


def refinement(folder):
    """Length and foot against the spacing of the particles, with the finite elements as a line."""
    found = measure.refinement([case for case in BY_NAME.values() if measure.has_run(case)])
    if not found:
        return
    figure, (*grid, words) = plt.subplots(1, 4, figsize=(12.5, 3.6), layout="constrained",
                                          gridspec_kw={"width_ratios": (1, 1, 1, 0.75)})
    fe = measure.reference(WALL)
    what = (("length", "length_mm", "length (mm)"), ("foot", "foot_mm", "foot width (mm)"), (None, "ke", "KE/KE0 at 30 us"))
    for axes, (key, column, text) in zip(grid, what):
        axes.axhline(measure.at(50 if key else 30, fe["t_us"], fe[column]), color="black", lw=1.2, label="finite elements")
        if key in measure.NO_BULK:
            axes.axhline(measure.NO_BULK[key], color="black", lw=1.2, ls=":", label="the same without bulk viscosity")
        for frame, viscosity, got in found:
            style = dict(color="#cc5511" if frame == "eulerian" else "#4477aa", marker="o" if viscosity == "correct" else "s",
                         ls="-" if viscosity == "correct" else (0, (4, 2)), label=f"{frame}, {VISCOSITIES[viscosity][0]}")
            axes.plot([measure.SPACING / n for n in got], [figures[key] if key else figures["ke"][2] for figures in got.values()],
                      **style)
        axes.set(xlim=(0, 0.42), xlabel="spacing (mm)", title=text)
        axes.grid(color="0.9")
    words.legend(*grid[0].get_legend_handles_labels(), fontsize=9, loc="center left")
    words.axis("off")
    save(figure, folder, "refinement")


def speeds(folder):
    """Where the Lagrangian frame ends: length and foot against time for several speeds, and the last moment of each."""
    runs = [case for case in BY_NAME.values() if case.name == f"speed-{case.speed:g}" and measure.has_run(case)]
    if len(runs) < 2:
        return
    figure, grid = plt.subplots(1, 2, figsize=(9.6, 3.9), layout="constrained")
    for case, color in zip(runs, plt.get_cmap("viridis")(np.linspace(0.0, 0.9, len(runs)))):
        data, ended = measure.columns(OUTPUT / f"{case.name}.csv"), measure.why(case)
        for axes, values in zip(grid, (np.array(data["foot_mm"]) / measure.WIDTH, np.array(data["length_mm"]))):
            axes.plot(data["t_us"], values, color=color, lw=1.5, label=f"{case.speed:g} m/s")
            if ended:
                axes.plot(data["t_us"][-1], values[-1], "X", color="#cc3311", ms=8, mec="white", zorder=5)
    grid[0].plot([], [], "X", color="#cc3311", ms=8, mec="white", label="the frame ends")
    grid[0].set(ylabel="foot width / width of the rod")
    grid[1].set(ylabel="length (mm)", ylim=(0, None))
    for axes in grid:
        axes.set(xlim=(0, max(case.tend for case in runs)), xlabel="time (us)")
        axes.grid(color="0.9")
    grid[0].legend(fontsize=8)
    save(figure, folder, "speeds")


def default_frame(folder):
    """The pictures of the Lagrangian frame, and of both frames beside each other."""
    def run(key, wall="contact", h=1.0, frame="lagrangian", refine=1):
        return cases.name_of(key, wall, h, frame, refine)

    titles = {key: text for key, (text, _) in VISCOSITIES.items()}
    how = "frame lagrangian, h = 1 spacing, contact wall, 50 us; line: finite elements"
    shapes(folder, "taylor", [(run("0.5"), "viscosity (0.5, 0.5)"), (run("1.0"), "viscosity (1, 1)"),
                              (run("correct"), "corrected viscosity")], WALL, foot=True)
    shapes(folder, "lagrangian", [(run(key), titles[key]) for key in ("none", "0.5", "limited", "correct")], WALL, foot=True,
           title=how)
    shapes(folder, "lagrangian-walls", [(run("correct", wall), f"correct, wall {wall}") for wall in WALLS], WALLS, foot=True,
           title="frame lagrangian, h = 1 spacing, 50 us; line: finite elements", width=3.6)
    history(folder, "lagrangian-history", [(wall, h, run("correct", wall, h)) for wall in WALLS for h in SMOOTHING_LAGRANGIAN], 1.0)
    for refine, picture in ((1, "frames"), (2, "frames-fine")):
        shapes(folder, picture, [(run("correct", WALL, cases.H[frame], frame, refine),
                                  f"frame {frame}, {cases.LATTICES[refine]}") for frame in ("lagrangian", "eulerian")],
               WALL, foot=True, title="correct, contact wall, 50 us; line: finite elements", width=3.6)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else OUTPUT
    how = f"frame eulerian, gradient {GRADIENT}, h = {H} spacings, {WALL} wall, 50 us"
    titles = {key: text for key, (text, _) in VISCOSITIES.items()}
    viscous = [(name_of(key), titles[key]) for key in ("0.2", "0.5", "1.0", "2.5")]
    shapes(folder, "fig3", [(name_of("none"), "no viscosity")], width=4.2)
    shapes(folder, "fig4", viscous, foot=True, title=how)
    energy_curves(folder, "fig5", [(name_of("none"), titles["none"])] + viscous + [(name_of("correct"), "correct")], how)
    for picture, gradient in (("fig6", "corrected"), ("fig6-plain", "plain")):
        shapes(folder, picture, [(name_of(key, gradient), titles[key]) for key in ("0.5", "1.0", "correct")], WALL,
               foot=True, title=how.replace(GRADIENT, gradient) + "; line: finite elements")
    shapes(folder, "walls", [(name_of("correct", "corrected", H, wall), f"correct, wall {wall}") for wall in WALLS],
           WALLS, foot=True, title="frame eulerian, gradient corrected, h = 1.5 spacings, 50 us; line: finite elements", width=3.6)
    shapes(folder, "ulsph", [("ulsph-1.0", "smd/ulsph, Q1 = 1"), ("ulsph-0.3", "smd/ulsph, Q1 = 0.3"),
                             (name_of("correct", "corrected", H, "symmetry"), "sph/solid, correct")], "symmetry", foot=True,
           title="mirror plane, 50 us; line: finite elements")
    history(folder, "history", [(wall, h, name_of("correct", "corrected", h, wall)) for wall in WALLS for h in SMOOTHING], H)
    default_frame(folder)
    refinement(folder)
    speeds(folder)


if __name__ == "__main__":
    main()
