"""The pages of doc/verification: one per scene, and an index of what is aimed at and what comes out.

All numbers come from the kept figures; nothing is written by hand but what scene.py says about the problem."""

import math

import catalogue
import methods
from catalogue import ROOT, load, order, optional, series
from running import say

PAGES = ROOT / "doc" / "verification"


def data(name):
    return PAGES / "data" / f"{name}.csv"


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text.rstrip() + "\n")
    say(path.relative_to(ROOT))


def heading(text, line):
    return f"{text}\n{line * len(text)}\n\n"


def table(head, rows):
    """An rst table; cells are strings."""
    line = lambda row: "   " + ", ".join('"' + cell.replace('"', '""') + '"' for cell in row) + "\n"
    return ".. csv-table::\n   :header-rows: 1\n\n" + "".join(line(row) for row in [head, *rows]) + "\n"


# ---- one scene ----------------------------------------------------------------------------------------------

def page(name, scene, results):
    draw(name, scene, results)
    text = [heading(scene.TITLE, "="), scene.ABOUT.strip(), "\n\n"]
    text += [heading("Judgement", "-"), scene.judge(results), "\n\n"] if any(not r.failed for r in results) else []
    if (PAGES / f"{name}.png").exists():
        text += [f".. image:: {name}.png\n\n"]
    text += [heading("At the finest resolution", "-"), finest_table(scene, results), failures(scene, results)]
    for figure in scene.FIGURES:
        if figure.order:
            text += [heading(f"{figure.text}: convergence", "-"), order_table(scene, results, figure)]
    text += [f"Input: ``unittest/verification/scenes/{name}``.  All figures: :download:`{name}.csv <data/{name}.csv>`.\n"]
    write(PAGES / f"{name}.rst", "".join(text))


def draw(name, scene, results):
    """The picture, if the output of the runs is still there; otherwise it stays as it is."""
    if any(r.case.csv.exists() or r.case.dump.exists() for r in results if not r.failed):
        scene.draw(results, PAGES / f"{name}.png")


def shown(value, figure, limit):
    """A number, in bold where it misses its target."""
    if value is None or not math.isfinite(value):
        return "-"
    text = figure.format.format(value)
    return f"**{text}**" if limit is not None and not abs(value) <= limit else text


def grouped(results):
    """{group: [(title of the row, series)]} in the order of the methods."""
    rank = {method.key: k for k, method in enumerate(methods.METHODS)}
    found = {}
    for name, group in sorted(series(results).items(), key=lambda item: rank.get(item[1][0].case.method.key, 99)):
        method = group[0].case.method
        found.setdefault(method.group, []).append((method.title + name[len(method.key):].replace("-", ", ", 1), group))
    return found


def finest_table(scene, results):
    targets = getattr(scene, "TARGETS", {})
    head = ["method", "n", *(f.text for f in scene.FIGURES)]
    rows = [["*target*", "", *(f.format.format(targets[f.name]).replace("+", "") if f.name in targets else ""
                               for f in scene.FIGURES)]] if targets else []
    for group, entries in grouped(results).items():
        rows.append([f"*{group}*"] + [""] * (len(head) - 1))
        rows += [[title, str(runs[-1].case.n),
                  *(shown(runs[-1].figures.get(f.name), f, targets.get(f.name)) for f in scene.FIGURES)]
                 for title, runs in entries]
    return table(head, rows) + ("Bold: misses the target.\n\n" if targets else "")


def failures(scene, results):
    lines = [f"* {r.case.method.title} ({r.case.method.group}), n = {r.case.n}: {r.case.may_fail or 'stopped'} "
             f"(``{r.failed.strip()}``)\n" for r in results if r.failed]
    for method in methods.METHODS:
        reason = optional(scene, "cannot", "", method)
        if reason:
            lines.append(f"* {method.title}: {reason}\n")
    return "Not in the table:\n\n" + "".join(lines) + "\n" if lines else ""


def order_table(scene, results, figure):
    sizes = sorted({r.case.n for r in results})
    least = getattr(scene, "ORDERS", {}).get(figure.name)
    rows = []
    for group, entries in grouped(results).items():
        rows.append([f"*{group}*"] + [""] * (len(sizes) + 1))
        for title, runs in entries:
            at = {r.case.n: r.figures.get(figure.name) for r in runs}
            rate = order(runs, figure.name)
            mark = "**" if least is not None and not rate >= least else ""
            rows.append([title, *(shown(at.get(n), figure, None) for n in sizes),
                         f"{mark}{rate:.2f}{mark}" if math.isfinite(rate) else "-"])
    aim = f"Aimed at: order {least:g} or more; bold: less.\n\n" if least is not None else ""
    return table(["method", *(f"n = {n}" for n in sizes), "order"], rows) + aim


# ---- the index ----------------------------------------------------------------------------------------------

def index():
    kept = [name for name in catalogue.names() if data(name).exists()]
    rows, pages = [], []
    for name in kept:
        scene = load(name)
        rows += index_rows(name, scene, catalogue.kept(scene, name, data(name)))
        pages.append(f"   {name}\n")
    text = [heading("Verification", "="), INTRODUCTION,
            table(["scene", "figure", "target", "measured", "", "methods that meet it"], rows),
            ".. toctree::\n   :maxdepth: 1\n\n", *pages]
    write(PAGES / "index.rst", "".join(text))


INTRODUCTION = f"""What comes out is compared with exact or converged solutions.  The table has the figures that are
aimed at and what is measured with the settings of a user who sets nothing ({methods.BY_KEY[methods.DEFAULT].group},
*viscosity {methods.BY_KEY[methods.DEFAULT].title}*) at the finest resolution of the scene, or with the method that is
named, and how many of the methods in the scene's table meet it.  The pages of the scenes have all methods,
resolutions and the reasons.

Everything here is written by ``./sphsolid verify``, which runs all scenes; ``./sphsolid verify wave`` runs one.  The
tests *verification.scene.* of ``./sphsolid test`` run a short form of each.

"""


def index_rows(name, scene, results):
    head = getattr(scene, "HEADLINE", methods.DEFAULT)
    groups = series(results)
    named = "" if head == methods.DEFAULT else f" ({methods.BY_KEY[head].title})"
    rows = []
    for figure in scene.FIGURES:
        limit = getattr(scene, "TARGETS", {}).get(figure.name)
        if limit is not None:
            values = {key: runs[-1].figures.get(figure.name, math.nan) for key, runs in groups.items()}
            rows.append(index_row(name, figure.text, figure.format.format(limit).replace("+", ""), values, head, named,
                                  figure.format, lambda value: abs(value) <= limit))
        least = getattr(scene, "ORDERS", {}).get(figure.name)
        if least is not None:
            values = {key: order(runs, figure.name) for key, runs in groups.items()}
            rows.append(index_row(name, f"order of: {figure.text}", f">= {least:g}", values, head, named, "{:.2f}",
                                  lambda value: value >= least))
    return rows


def index_row(name, text, target, values, head, named, form, meets):
    value = values.get(head, math.nan)
    values = {key: v for key, v in values.items() if math.isfinite(v)}
    met = sum(meets(v) for v in values.values())
    return [f":doc:`{name}`", text + named, target, form.format(value) if math.isfinite(value) else "-",
            "met" if meets(value) else "**missed**", f"{met} of {len(values)}"]

