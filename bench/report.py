"""Tables from results/*.csv and instructions.csv, and README.md."""

import csv
import itertools
import pathlib

import counted
from variants import BY_KEY, VARIANTS, features
from running import markdown    # counted imports block, which has put that folder on the path

HERE = pathlib.Path(__file__).resolve().parent


def results():
    """All kept results, oldest first: paths."""
    return sorted((HERE / "results").glob("*.csv"))


def read(path):
    """(description of the machine, rows)"""
    with open(path, newline="") as file:
        lines = file.readlines()
    described = dict(line[2:].rstrip("\n").split(": ", 1) for line in lines if line.startswith("#"))
    return described, list(csv.DictReader(line for line in lines if not line.startswith("#")))


def of(rows, key, dim, particles):
    return next((r for r in rows if r["key"] == key and int(r["dim"]) == dim and int(r["particles"]) == particles), None)


def sizes(rows, dim):
    return sorted({int(r["particles"]) for r in rows if int(r["dim"]) == dim})


def title(row):
    if row["key"] in BY_KEY:
        return BY_KEY[row["key"]].title
    base = BY_KEY[row["key"].rsplit("-", 1)[0]].title
    return f"{base}, {row['ranks']} ranks" if row["ranks"] != "1" else f"{base}, {row['threads']} threads"


# ---- times ---------------------------------------------------------------------------------------------------

def times(rows):
    """A table for each dimension at 10^4 particles: everything, over smd/ulsph and smd/tlsph of h = 1.3."""
    text = []
    for dim in (2, 3):
        size = min(sizes(rows, dim), default=0)
        ulsph, tlsph = of(rows, "ulsph-h1.3", dim, size), of(rows, "tlsph-h1.3", dim, size)
        table = []
        for v in VARIANTS:
            r = of(rows, v.key, dim, size)
            if r:
                table.append([v.title, f"{v.h:g}", r["neighbors"], f"{float(r['ns']):.0f}",
                              f"{float(r['ns_least']):.0f}, {float(r['ns_most']):.0f}", f"{1e9 / float(r['ns']):.3g}"] +
                             [f"{float(o['ns']) / float(r['ns']):.1f}" if o else "-" for o in (ulsph, tlsph)])
        if table:
            text.append(f"**{dim}D, {size} particles**\n\n" + markdown(
                ("style", "h", "neighbours", "ns", "least, most", "particle-steps per CPU second", "times smd/ulsph",
                 "times smd/tlsph"), table))
    return "\n".join(text)


def growth(row, smallest):
    return f"{float(row['ns']):.0f} ({float(row['ns']) / float(row.get('ns_small') or smallest['ns']):.2f})"


def scaling(rows):
    """ns per particle and step over the size, and over the smallest one right before and after (where results have none: over
    that of the same run)."""
    table = []
    for dim in (2, 3):
        for v in VARIANTS:
            found = [(n, of(rows, v.key, dim, n)) for n in sizes(rows, dim)]
            found = [r for _, r in found if r]
            if len(found) > 1:
                table.append([f"{dim}D, {v.title}, h {v.h:g}"] + [growth(r, found[0]) for r in found])
    most = max((len(r) for r in table), default=1)
    heads = ("10^4", "10^5", "10^6", "4*10^6")[:most - 1]
    return markdown(("particles",) + heads, [r + [""] * (most - len(r)) for r in table])


def shared(rows):
    """Two ranks or threads against one: CPU time of all together, since elapsed time says nothing on a busy machine."""
    table = []
    for r in rows:
        alone = of(rows, r["key"].rsplit("-", 1)[0], int(r["dim"]), int(r["particles"])) if r["ranks"] + r["threads"] != "11" else None
        if alone:
            ways = int(r["ranks"]) * int(r["threads"])
            table.append([f"{r['dim']}D, {r['particles']} particles, {title(r)}", f"{float(alone['ns']):.0f}", f"{float(r['ns']):.0f}",
                          f"{ways * float(alone['ns']) / float(r['ns']):.2f}", f"{float(alone['elapsed_ns']) / float(r['elapsed_ns']):.2f}"])
    return markdown(("", "CPU ns of one", "CPU ns of both", "speed-up if both had a processor", "speed-up in elapsed time"), table)


def memory(rows):
    """Bytes per particle: peak of the process minus that at 10^4 particles."""
    table = []
    for dim in (2, 3):
        known = sizes(rows, dim)
        for v in VARIANTS:
            small = of(rows, v.key, dim, known[0]) if known else None
            line = []
            for n in known[1:]:
                r = of(rows, v.key, dim, n)
                line.append(f"{(float(r['peak_bytes']) - float(small['peak_bytes'])) / (n - known[0]):.0f}"
                            if r and small and r["peak_bytes"] else "-")
            if small and any(cell != "-" for cell in line):
                table.append([f"{dim}D, {v.title}, h {v.h:g}"] + line)
    most = max((len(r) for r in table), default=1)
    return markdown(("bytes per particle, from blocks of",) + ("10^5", "10^6", "4*10^6")[:most - 1],
                    [r + ["-"] * (most - len(r)) for r in table])


# ---- instructions --------------------------------------------------------------------------------------------

def feature_table():
    if not counted.FILE.exists():
        return "Not counted yet.\n"
    signature, counts = counted.kept()
    text = [f"Counted with {signature}.\n"]
    for frame in counted.FRAMES:
        table = []
        for key, what, _ in features(frame):
            cells = [what]
            for each in counted.COUNTED:
                value, bare = counts.get((each.dim, frame, key)), counts.get((each.dim, frame, "bare"))
                cells += [f"{value:.0f}", f"{value / bare:.3f}"] if value else ["-", "-"]
            table.append(cells)
        text.append(f"**frame {frame}**\n\n" + markdown(("", "2D", "", "3D", ""), table))
    return "\n".join(text)


def ratio_table():
    if not counted.FILE.exists():
        return ""
    return markdown(("instructions", "ratio", "bounds"),
                    [[t, f"{v:.3f}", f"{low:g} to {high:g}"] for t, v, low, high in counted.ratios(counted.kept()[1])])


# ---- figures of the issue, and the ratio to what was before --------------------------------------------------

def ratio(rows, fast, slow, dim, particles):
    a, b = of(rows, fast, dim, particles), of(rows, slow, dim, particles)
    return float(b["ns"]) / float(a["ns"]) if a and b else None


AIMS = [    # (text, dim, faster, slower, least ratio)
    ("Eulerian frame, everything on, over smd/ulsph of the same support", 2, "E-correct", "ulsph-h1.3", 5.0),
    ("Eulerian frame, everything on, over smd/ulsph of the same support", 3, "E-correct", "ulsph-h1.3", 6.0),
    ("Lagrangian frame, default, over smd/ulsph", 2, "L-correct", "ulsph-h1.3", 10.0),
    ("Lagrangian frame, default, over smd/tlsph", 2, "L-correct", "tlsph-h1.3", 25.0),
    ("Lagrangian frame, default, over smd/ulsph", 3, "L-correct", "ulsph-h1.3", 15.0),
]


def aims(rows):
    table = []
    mixed = [(f"{text}, precision mixed", dim, f"{fast}-mixed", slow, least) for text, dim, fast, slow, least in AIMS]
    for text, dim, fast, slow, least in AIMS + mixed:
        for n in sizes(rows, dim):
            value = ratio(rows, fast, slow, dim, n)
            if value:
                table.append([f"{text}, {dim}D, {n} particles", f"{value:.1f}", f"{least:g}",
                              "reached" if value >= least else f"missed by a factor of {least / value:.2f}"])
    for frame, letter in (("Lagrangian", "L"), ("Eulerian", "E")):
        for dim, (end, words) in itertools.product((2, 3), (("", ""), ("-mixed", ", precision mixed"))):
            n = min(sizes(rows, dim), default=0)
            value = ratio(rows, f"{letter}-monaghan{end}", f"{letter}-correct{end}", dim, n)
            if value:
                table.append([f"*correct* over *monaghan*, {frame} frame, {dim}D{words} (at most)", f"{value:.2f}", "1.15",
                              "reached" if value <= 1.15 else f"missed by {value / 1.15 - 1:.1%}"])
    return markdown(("", "times", "aim", ""), table)


def comparison():
    """The newest results over those before."""
    paths = results()
    if len(paths) < 2:
        return f"There is one set of results only: {paths[0].stem}." if paths else "There are no results yet."
    (old_machine, old), (new_machine, new) = read(paths[-2]), read(paths[-1])
    table = []
    for r in new:
        before = of(old, r["key"], int(r["dim"]), int(r["particles"]))
        if before:
            table.append([f"{r['dim']}D", r["particles"], title(r), f"{float(before['ns']):.0f}", f"{float(r['ns']):.0f}",
                          f"{float(r['ns']) / float(before['ns']):.3f}"])
    differ = [what for what in new_machine if new_machine[what] != old_machine.get(what) and "wanted to run" not in what]
    note = f"\nNot the same: {', '.join(differ)}.\n" if differ else ""
    return (f"{paths[-1].stem} over {paths[-2].stem}, ns of CPU per particle and step\n\n" +
            markdown(("", "particles", "style", "before", "now", "ratio"), table, left=3) + note)


# ---- README.md -----------------------------------------------------------------------------------------------

def write():
    template = (HERE / "README.in.md").read_text()
    paths = results()
    described, rows = read(paths[-1]) if paths else ({}, [])
    blanks = {"DATE": paths[-1].stem if paths else "-", "MACHINE": markdown(("", ""), [list(item) for item in described.items()]),
              "AIMS": aims(rows), "TIMES": times(rows), "SCALING": scaling(rows), "SHARED": shared(rows), "MEMORY": memory(rows),
              "FEATURES": feature_table(), "RATIOS": ratio_table(),
              "REPEAT": max((r["repetitions"] for r in rows), default="0")}
    for name, text in blanks.items():
        template = template.replace(f"@{name}@", text.rstrip("\n"))
    (HERE / "README.md").write_text(template)
