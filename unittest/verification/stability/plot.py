"""Draws the charts from their CSV files: plot.py <folder> [chart ...]"""

import csv
import pathlib
import sys

import numpy as np
from matplotlib.patches import Patch

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[2] / "examples")]

import charts
import growth
from drawing import plt, save

LEGEND = {    # verdict: colour, words; the same in every chart
    "survived": ("#66bb88", "survives"),
    "off": ("#e8d774", "runs on, result far off"),
    "clumped": ("#ee9a4d", "particles lie on each other"),
    "torn": ("#cc6677", "particles lose all neighbours"),
    "energy": ("#aa66aa", "energy not conserved"),
    "distorted": ("#6699cc", "stops: deformation beyond the frame"),
    "unphysical": ("#333333", "stops: state not physical"),
    "left": ("#888888", "stops: fragments left the box"),
    "slow": ("#bbbbbb", "time step becomes too small"),
    "stopped": ("#aa7755", "stops for another reason"),
    "refused": ("#ffffff", "not offered"),
}
DARK = ("unphysical",)


def read(folder, chart):
    with open(folder / f"{chart}.csv") as file:
        return list(csv.DictReader(file))


def unique(lines, key):
    return list(dict.fromkeys(line[key] for line in lines))


def words_in(line, percent):
    """Number of a cell: in per cent, or nothing where there is none."""
    if line["verdict"] in ("distorted", "unphysical", "left", "slow", "stopped"):
        return f"{100 * float(line['reached']):.0f}" if line["reached"] else ""
    if line["number"] in ("", "nan"):
        return ""
    text = format(100 * float(line["number"]), percent)
    return text if float(text) else text.lstrip("+-")


def cells(axes, lines, title, xlabel="", ylabel="", percent="+.0f", upwards=False):
    """One panel: a coloured cell a run."""
    rows, columns = unique(lines, "row"), unique(lines, "column")
    if upwards:
        rows = rows[::-1]
    for line in lines:
        x, y = columns.index(line["column"]), rows.index(line["row"])
        colour, _ = LEGEND[line["verdict"]]
        axes.add_patch(plt.Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=colour, edgecolor="white", lw=1.2))
        if line["verdict"] == "refused":
            axes.add_patch(plt.Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor="none", edgecolor="0.75", lw=0, hatch="////"))
        axes.text(x, y, words_in(line, percent), ha="center", va="center", fontsize=6.5,
                  color="white" if line["verdict"] in DARK else "0.15")
    axes.set(xlim=(-0.5, len(columns) - 0.5), ylim=(len(rows) - 0.5, -0.5), xticks=range(len(columns)), yticks=range(len(rows)),
             title=title, xlabel=xlabel, ylabel=ylabel)
    axes.set_xticklabels(columns)
    axes.set_yticklabels(rows)
    axes.tick_params(length=0, labelsize=8)
    for side in axes.spines.values():
        side.set_visible(False)


def legend(figure, lines, below):
    seen = set(line["verdict"] for line in lines)
    handles = [Patch(facecolor=colour, edgecolor="0.6", hatch="////" if key == "refused" else None, label=words)
               for key, (colour, words) in LEGEND.items() if key in seen]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.01), ncol=4, fontsize=8.5, title=below,
                  title_fontsize=8.5)


def panels(folder, chart, lines, shape, size, titles, below, xlabel, ylabel="", **more):
    figure, grid = plt.subplots(*shape, figsize=size, layout="constrained", squeeze=False)
    names = unique(lines, "panel")
    for axes, name in zip(grid.flat, names):
        cells(axes, [line for line in lines if line["panel"] == name], titles(name), xlabel, ylabel, **more)
    for axes in list(grid.flat)[len(names):]:
        axes.axis("off")
    legend(figure, lines, below)
    save(figure, folder, chart)


def form_title(name):
    return charts.FORMS[name].title


STOPS = "where a run stops: the time it has reached, % of the whole"


def coefficients(folder, lines):
    order = [f"{form} {key}" for key in charts.PAIRS for form in charts.FORMS]
    lines = sorted(lines, key=lambda line: order.index(line["panel"]))

    def title(name):
        form, key = name.split(maxsplit=1)
        return f"{key}: {form_title(form)}"

    panels(folder, "coefficients", lines, (len(charts.PAIRS), len(charts.FORMS)), (11, 22), title,
           f"number: foot against finite elements, %; {STOPS}", "a1", "a2", upwards=True)


def smoothing(folder, lines):
    panels(folder, "smoothing", lines, (3, 1), (7.2, 10.4), form_title,
           f"number: foot against finite elements, %; {STOPS}", "h in spacings")


def courant(folder, lines):
    panels(folder, "courant", lines, (3, 1), (7.2, 10.4), form_title,
           f"number: foot against finite elements, %; {STOPS}", "cfl of fix sph/solid/dt")


def speed(folder, lines):
    panels(folder, "speed", lines, (3, 1), (7.2, 10.4), form_title,
           f"number: length after 80 us over the first, %; {STOPS}", "impact speed (m/s)", percent=".0f")


def tension(folder, lines):
    titles = {"eulerian, artificial": "frame eulerian, gradient corrected, tensile artificial 0.3 4"}
    panels(folder, "tension", lines, (2, 2), (10, 7.2), lambda name: titles.get(name) or form_title(name),
           f"number: elongation from which the stress is not uniform, % (of 10 %); {STOPS}", "elongation per second (1/s)", percent=".1f")


def jitter(folder, lines):
    titles = {"rod": "rod at 200 m/s", "strip": "strip, pulled by 10 %", "square": "free square, a quarter of a turn"}
    what = {"lagrangian": "lagrangian", "eulerian": "eulerian", "plain": "eulerian, gradient plain"}
    order = [f"{scene} {form}" for scene in titles for form in charts.FORMS]
    lines = sorted(lines, key=lambda line: order.index(line["panel"]))
    panels(folder, "jitter", lines, (3, 3), (11, 10.8), lambda name: f"{titles[name.split()[0]]}: {what[name.split()[1]]}",
           f"number, %: foot against finite elements (rod), elongation from which the stress is not uniform (strip), change of "
           f"the kinetic energy (square)\n{STOPS}", "random displacement in spacings", percent=".1f")


def turning(folder, lines):
    panels(folder, "turning", lines, (3, 1), (7.2, 10.4), form_title,
           f"number: stress in the middle against the exact one, %; {STOPS}", "stress in the middle by the load (MPa)")


# ---- growth rates: lines are the formula, dots the runs -----------------------------------------------------------

COLORS = ("#4477aa", "#ee6677", "#228833", "#aa8800", "#aa3377")


SEEN = {    # viscosities in the growth chart: colour, size, face; rings around those with which they coincide by the formula
    "none": (COLORS[0], 5, None), "balsara 1": (COLORS[0], 10, "none"), "monaghan 0.2": (COLORS[1], 5, None),
    "monaghan 0.5": (COLORS[2], 5, None), "limited 0.5": (COLORS[2], 9, "none"), "correct": (COLORS[4], 13, "none"),
    "weights safe": (COLORS[4], 17, "none"), "monaghan 1": (COLORS[3], 5, None), "front": (COLORS[3], 10, "none"),
}


def dots(axes, lines, color, label, size=5, face=None):
    x, y = ([float(line[key]) for line in lines] for key in ("column", "number"))
    axes.plot(x, y, "o", color=color, ms=size, mfc=face or color, label=label)


def curve(axes, xs, rate, color, **style):
    axes.plot(xs, [rate(x) for x in xs], "-", color=color, lw=1.2, **style)


def growth_rates(folder, lines):
    figure, grid = plt.subplots(2, 2, figsize=(10, 7.4), layout="constrained")
    part = lambda panel, row=None: [l for l in lines if l["panel"] == panel and row in (None, l["row"])]
    xs, hs = np.geomspace(5e-4, 5e-2, 60), np.linspace(1.0, 2.0, 81)

    for h, color in zip(unique(part("tension"), "row"), COLORS):
        dots(grid[0, 0], part("tension", h), color, f"h = {h}")
        curve(grid[0, 0], xs, lambda T: growth.rate(T, float(h)), color)
    grid[0, 0].set(xscale="log", yscale="log", xlabel="tension / (rho0 c0^2)", title="columns against each other, no viscosity")

    for key, (color, size, face) in SEEN.items():
        dots(grid[0, 1], part("viscosity", key), color, key, size=size, face=face)
        curve(grid[0, 1], np.linspace(1.15, 1.45, 40),
              lambda h: growth.rate(0.02, h, viscosity=charts.METHODS[key]), color)
    grid[0, 1].set(xlabel="h in spacings", title="with viscosity, tension 0.02", ylim=(0, 0.4))

    for axes, panel, eps, title in ((grid[1, 0], "smoothing", 0.0, "three modes, tension 0.02, no viscosity"),
                                    (grid[1, 1], "artificial", 0.3, "the same with tensile artificial 0.3 4")):
        for mode, color in zip(growth.MODES, COLORS):
            row = f"corrected {mode}" if panel == "smoothing" else str(mode)
            curve(axes, hs, lambda h: growth.rate(0.02, h, mode, eps=eps), color)
            dots(axes, part(panel, row), color, f"started: {growth.MODES[mode][0]}",
                 size=13 - 3 * mode)
        axes.set(xlabel="h in spacings", title=title, ylim=(-0.01, None))
    top = max(axes.get_ylim()[1] for axes in grid[1])
    for axes in grid.flat:
        axes.set_ylabel("growth rate (c0/dx)")
        axes.grid(color="0.92")
        axes.legend(fontsize=8, ncols=3 if axes is grid[0, 1] else 1)
    for axes in grid[1]:
        axes.set_ylim(-0.01, top)
    figure.suptitle("Tensile instability, frame eulerian: runs (dots) and formula (lines)", fontsize=11)
    save(figure, folder, "growth")


DRAW = {"coefficients": coefficients, "smoothing": smoothing, "courant": courant, "speed": speed, "tension": tension,
        "growth": growth_rates, "jitter": jitter, "turning": turning}


def main():
    folder = pathlib.Path(sys.argv[1])
    for chart, draw in DRAW.items():
        if chart in (sys.argv[2:] or DRAW) and (folder / f"{chart}.csv").exists():
            draw(folder, read(folder, chart))


if __name__ == "__main__":
    main()
