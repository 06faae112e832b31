"""Writes doc/stability.rst: the text of page.rst.in with the tables and numbers of the charts' CSV files."""

import csv
import pathlib

import charts
import judge
from charts import FORMS, METHODS, ROOT

HERE = pathlib.Path(__file__).resolve().parent
TITLES = {"lagrangian": "lagrangian", "eulerian": "eulerian, corrected", "plain": "eulerian, plain",
          "eulerian, artificial": "eulerian, corrected, *tensile artificial 0.3 4*"}


def rst_table(head, rows):
    lines = [".. list-table::", "   :header-rows: 1", ""]
    for row in [head] + rows:
        lines += [("   * - " if k == 0 else "     - ") + (cell or "\\-") for k, cell in enumerate(row)]
    return "\n".join(lines)


def ranges(columns, good):
    """Columns that are good, with neighbours joined: "0.1 to 0.5, 2.0"; all, none."""
    if all(good):
        return f"all, {columns[0]} to {columns[-1]}"
    parts, start = [], None
    for k, fine in enumerate(list(good) + [False]):
        if fine and start is None:
            start = k
        elif not fine and start is not None:
            parts.append(columns[start] if k == start + 1 else f"{columns[start]} to {columns[k - 1]}")
            start = None
    return ", ".join(parts) or "none"


def survival(lines, title):
    """A table: what each viscosity survives in each panel."""
    panels = list(dict.fromkeys(line["panel"] for line in lines))
    rows = []
    for key in METHODS:
        cells = [key]
        for panel in panels:
            mine = [line for line in lines if line["panel"] == panel and line["row"] == key]
            offered = [line for line in mine if line["verdict"] != "refused"]
            cells.append(ranges([line["column"] for line in offered], [line["verdict"] == "survived" for line in offered])
                         if offered else "not offered")
        rows.append(cells)
    return rst_table(["viscosity"] + [TITLES.get(p) or title(p) for p in panels], rows)


def coefficients(lines):
    rows = []
    for form in FORMS:
        for kind in charts.PAIRS:
            mine = [line for line in lines if line["panel"] == f"{form} {kind}" and line["verdict"] != "refused"]
            if not mine:
                continue
            alive = [line for line in mine if line["verdict"] == "survived"]
            ones = next(line for line in mine if float(line["row"]) == float(line["column"]) == 1.0)
            feet = [100 * float(line["number"]) for line in mine if line["number"] not in ("", "nan")]
            rows.append([TITLES[form], kind, f"{len(alive)} of {len(mine)}", f"{100 * float(ones['number']):+.1f}",
                         f"{min(feet):+.0f} to {max(feet):+.0f}"])
    return rst_table(["frame, gradient", "viscosity", "pairs (a1, a2) that survive", "foot at (1, 1), %", "foot of all, %"], rows)


def worst(lines, exact):
    """Largest deviation of the runs from the formula, where it gives growth, in per cent, and the number of runs."""
    found = [abs(float(line["number"]) / float(line[exact]) - 1) for line in lines if float(line[exact]) > 1e-3]
    return f"{100 * max(found):.2g} %", len(found)


def growth_numbers(lines):
    part = {panel: [l for l in lines if l["panel"] == panel] for panel in ("tension", "smoothing", "viscosity", "artificial")}
    small = [l for l in part["smoothing"] if float(l["column"]) <= 1.5]
    # with artificial stress the second mode is the one that grows, whichever was started
    mode2 = [l for l in part["artificial"] if l["row"] == "2"]
    values = {}
    for name, some, exact in (("tension", part["tension"], "exact"), ("viscosity", part["viscosity"], "exact"),
                              ("h", small, "fastest"), ("artificial", mode2, "exact")):
        if name == "h":    # the run shows its own mode, or the fastest
            some = [dict(l, exact=l["exact"] if abs(float(l["number"]) - float(l["exact"])) <
                         abs(float(l["number"]) - float(l["fastest"])) else l["fastest"]) for l in some]
            exact = "exact"
        values[f"growth_{name}"], values[f"growth_{name}_runs"] = worst(some, exact)
    beyond = [l for l in part["smoothing"] if float(l["column"]) > 1.5 and float(l["number"]) > 1.1 * float(l["fastest"])]
    values["growth_beyond"] = ", ".join(sorted({l["column"] for l in beyond})) or "none"
    values["growth_beyond_rate"] = f"{max([float(l['number']) for l in beyond] or [0]):.3f}"
    values["artificial_h"] = ranges([l["column"] for l in mode2], [float(l["number"]) > 0 for l in mode2])
    for name, some in (("with", mode2), ("without", [l for l in part["smoothing"] if l["row"] == "corrected 2"])):
        values[f"sliding_{name}"] = next(f"{float(l['number']):.3f}" for l in some if l["column"] == "1.3")
    return values


def write(folder):
    lines = {}
    for chart in charts.CHARTS:
        with open(folder / f"{chart}.csv") as file:
            lines[chart] = list(csv.DictReader(file))
    scenes = {"rod": "rod", "strip": "strip", "square": "square"}
    values = {"table_coefficients": coefficients(lines["coefficients"]), **growth_numbers(lines["growth"]),
              "runs": sum(map(len, lines.values()))}
    for chart in ("smoothing", "courant", "speed", "tension", "turning"):
        values[f"table_{chart}"] = survival(lines[chart], str)
    for scene in scenes:
        mine = [dict(line, panel=line["panel"].split()[1]) for line in lines["jitter"] if line["panel"].startswith(scene)]
        values[f"table_jitter_{scene}"] = survival(mine, str)
    for name in ("ENERGY_ERROR", "CLOSEST", "PAIRED", "FOOT", "LENGTH", "WILKINS", "SPREAD", "STRESS", "SPIN", "TURN",
                 "LOADED", "RATE"):
        value = getattr(judge, name)
        values[name] = f"{value:g}"
        values[name + "_percent"] = f"{100 * value:g} %"
    text = (HERE / "page.rst.in").read_text()
    for name, value in values.items():
        text = text.replace("{" + name + "}", str(value))
    (ROOT / "doc/stability.rst").write_text(text)
    print("doc/stability.rst")
