"""Pictures and page of the work-precision diagram, from the kept data."""

import csv
import datetime
import json

import chart_cases
import machine
import pictures
from matplotlib.ticker import NullFormatter
from chart_cases import ROOT
from drawing import plt, save

DATA = ROOT / "doc" / "chart"
PAGE = ROOT / "doc" / "chart.rst"


def kept(chart):
    file = DATA / f"{chart.key}.csv"
    if not file.exists():
        return []
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def series(chart, rows):
    """[(method, its rows that came to their end, coarse to fine)], in the order of the runs."""
    order = {run.method.key: run.method for run in chart.runs}
    found = [(method, sorted((r for r in rows if r["method"] == key and not r["failed"]), key=lambda r: float(r["n"])))
             for key, method in order.items()]
    return [(method, group) for method, group in found if group]


def describe(lmp):
    """What it was measured on, kept beside the data."""
    text = {"date": datetime.date.today().isoformat(), **machine.describe(lmp)}
    (DATA / "machine.json").write_text(json.dumps(text, indent=1) + "\n")


# ---- pictures ------------------------------------------------------------------------------------------------

SPECIAL = {"L-correct-half": dict(color="C2", linestyle="-", marker="^"),
           "L-correct-mixed": dict(color="C1", linestyle="-", marker="v"), "E-correct-mixed": dict(color="C1", linestyle="--", marker="v"),
           "L-correct-symmetry": dict(color="C3", linestyle="-", marker="D"), "L-correct-channel": dict(color="C3", linestyle="-", marker="D"),
           "ulsph-1.0": dict(color="C4", linestyle="-."), "ulsph-0.3": dict(color="C1", linestyle="-."), "tlsph": dict(color="C5", linestyle="-.")}


MARKS = {"L": "o", "E": "^", "P": "x"}    # Lagrangian frame, Eulerian, Eulerian with plain gradients; squares: stock


def look(method):
    style = {**pictures.look(method), "marker": MARKS.get(method.key.split("-")[0], "s"), "markersize": 4, "linewidth": 1.1,
             **SPECIAL.get(method.key, {})}
    return {**style, "linewidth": 2.4, "zorder": 5} if method.key == "L-correct" else style


def lines(axes, chart, rows, error):
    for method, group in series(chart, rows):
        points = [(float(r["cpu_s"]), float(r[error])) for r in group if r[error] and float(r[error]) > 0]
        if points:
            axes.loglog(*zip(*points), label=pictures.label(method), **look(method))
    axes.set(xlabel="CPU time (s)", ylabel=chart.errors[error])
    axes.grid(True, which="major", lw=0.4, color="0.85")
    for axis in (axes.xaxis, axes.yaxis):    # numbers at powers of ten, and between them only where there is one or none
        low, high = axis.get_view_interval()
        if high / low > 15:
            axis.set_minor_formatter(NullFormatter())


def picture(chart, rows):
    figure, grid = pictures.axes(len(chart.errors), width=3.3)
    for axes, error in zip(grid, chart.errors):
        lines(axes, chart, rows, error)
    pictures.legend(figure, grid[0])
    save(figure, DATA, chart.key)


def summary(charts):
    """One panel a scene in two columns, for the README."""
    shown = [(chart, kept(chart)) for chart in charts if kept(chart)]
    rows = [shown[k:k + 2] for k in range(0, len(shown), 2)]
    places = [[chart.key for chart, _ in row] + ["."] * (2 - len(row)) + ["legend"] for row in rows]
    figure = plt.figure(figsize=(10.0, 3.2 * len(rows)), layout="constrained")
    panels = figure.subplot_mosaic(places, gridspec_kw={"width_ratios": [3.6, 3.6, 2.2]}, empty_sentinel=".")
    handles = {}
    for chart, data in shown:
        axes = panels[chart.key]
        lines(axes, chart, data, chart.main)
        axes.set_title(chart.title)
        found, names = axes.get_legend_handles_labels()
        handles.update({name: handle for name, handle in zip(names, found) if name not in handles})
    panels["legend"].axis("off")
    panels["legend"].legend(handles.values(), handles.keys(), loc="center left", fontsize=8, borderaxespad=0)
    save(figure, DATA, "summary")


# ---- page ----------------------------------------------------------------------------------------------------

def table(chart, rows):
    heads = ["method", chart.resolution, "CPU s", *chart.errors.values()]
    text = [".. list-table::", "   :header-rows: 1", "", *(f"   {'* -' if k == 0 else '  -'} {h}" for k, h in enumerate(heads))]
    titles = {run.method.key: pictures.label(run.method) for run in chart.runs}
    for r in rows:
        cells = [titles.get(r["method"], r["method"]), r["n"], r["cpu_s"]]
        cells += [r[name] or "-" for name in chart.errors] if not r["failed"] else [f"*{reason(r['failed'])}*"] + [""] * (len(chart.errors) - 1)
        text += [f"   {'* -' if k == 0 else '  -'} {cell}".rstrip() for k, cell in enumerate(cells)]
    return "\n".join(text)


def reason(failed):
    words = failed.replace("*", "").replace("ERROR: ", "").split(" (")[0]
    return words[:90].strip()


def find(rows, key, n):
    return next((r for r in rows if r["method"] == key and float(r["n"]) == n and not r["failed"]), None)


def rod_sentence(rows):
    """The figure asked for: 20 times faster than smd/ulsph at 21 x 67, with a tenth of its error."""
    ours = {"the contact wall": find(rows, "L-correct", 20), "the contact wall and half of the rod": find(rows, "L-correct-half", 20),
            "the symmetry wall": find(rows, "L-correct-symmetry", 20)}
    found = []
    for key in ("ulsph-1.0", "ulsph-0.3", "tlsph"):
        stock = find(rows, key, 20)
        for wall, mine in ours.items():
            if stock and mine:
                errors = ", ".join(f"{name} {float(mine[name]) / float(stock[name]):.3f}" for name in chart_cases.BY_KEY["taylor"].errors)
                found.append(f"* *{key}* takes {float(stock['cpu_s']) / float(mine['cpu_s']):.1f} times the CPU time of *correct* with "
                             f"{wall}, half of it for its mirror image; errors of *correct* over those of *{key}*: {errors}.")
    return "At 21 x 67 particles (aim: 20 times faster, a tenth of the error):\n\n" + "\n".join(found) if found else ""


def cheapest(chart, rows):
    """For each error of the default's at its middle resolution: which methods get below it, and for how much time."""
    group = dict((m.key, g) for m, g in series(chart, rows)).get("L-correct", [])
    if not group:
        return ""
    base = group[len(group) // 2]
    found = []
    for method, other in series(chart, rows):
        within = [r for r in other if r[chart.main] and float(r[chart.main]) <= 1.001 * float(base[chart.main])]
        if within:
            best = min(within, key=lambda r: float(r["cpu_s"]))
            found.append((float(best["cpu_s"]), f"*{pictures.label(method)}* ({float(best['cpu_s']) / float(base['cpu_s']):.2g}, n = {best['n']})"))
    names = ", ".join(text for _, text in sorted(found))
    return (f"The error of *correct* in the Lagrangian frame at n = {base['n']}, {float(base[chart.main]):.2g} ({chart.errors[chart.main]}), is "
            f"reached by: {names}; in brackets the CPU time over that of *correct* there, and the resolution.")


HEAD = """Speed against accuracy
======================

.. This page is written by "./sphsolid chart" (bench/chart.py).

What a user pays for an error: each point is a run, its CPU time to the right, its error upwards; the points of a line differ in
resolution only. The lower left is where one wants to be. Inputs, references and measurements are those of the examples
and of the verification scenes.

CPU time is the user time that the operating system booked for the loops of LAMMPS, not elapsed time. Other
processes ran on the same machine, so a time is uncertain by a quarter; runs that are compared were made close together in
time, and those shorter than a second three times (the median counts). All runs on one processor.

.. image:: chart/summary.png
   :width: 100%
   :alt: error against CPU time for four scenes
"""


def write(charts):
    described = json.loads((DATA / "machine.json").read_text()) if (DATA / "machine.json").exists() else {}
    text = [HEAD, *(f"| {what}: {words}" for what, words in described.items()), ""]
    for chart in charts:
        rows = kept(chart)
        if not rows:
            continue
        picture(chart, rows)
        text += [chart.title, "-" * len(chart.title), chart.about, f".. image:: chart/{chart.key}.png", "   :width: 100%",
                 f"   :alt: errors of the scene {chart.title} against CPU time", "", rod_sentence(rows) if chart.key == "taylor" else "", "",
                 cheapest(chart, rows), "", table(chart, rows), "", f"Data: :download:`chart/{chart.key}.csv`", ""]
    summary(charts)
    PAGE.write_text("\n".join(text))
