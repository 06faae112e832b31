#!/usr/bin/env python3
"""./sphsolid chart [case ...] [--level n] [--missing] [--pages]: error against CPU time, doc/chart and doc/chart.rst.

Runs level by level, so that what is compared is run close together; level 0 takes a minute or two, 3 (the default)
half an hour on a free processor. What takes less than a second of CPU runs three times, the median counts. --missing: only
what has no result yet. --pages: pictures and page again from the kept data.

Environment: LMP=<program> (default build/lmp)."""

import argparse
import csv
import math
import os
import statistics
import sys

sys.dont_write_bytecode = True
import chart_cases
import chart_page
from chart_cases import CHARTS, OUTPUT, ROOT

import running    # chart_cases has put examples/ on the path

LIMIT = 900          # elapsed seconds after which a run that gets nowhere is ended
REPEATED = 1.0       # CPU seconds up to which a run is repeated
say = running.say


def path(chart):
    return chart_page.DATA / f"{chart.key}.csv"


def once(run, lmp):
    """CPU seconds, and the last message of a run that did not come to its end."""
    output = OUTPUT / run.chart
    output.mkdir(parents=True, exist_ok=True)
    case, result, _ = running.simulate(run.here, lmp, run.case, os.path.relpath(output, run.here), LIMIT)
    log = output / f"{case.name}.log"
    return running.seconds(log), why(result.returncode, running.last_error(log)) if result.returncode else ""


def why(status, last):
    """What ended a run: its own message, the time limit (status 124 of timeout), or what it was."""
    return last if "ERROR" in last else f"ended after {LIMIT} s" if status == 124 else f"ended with status {status}"


def row(chart, run, times, failed):
    errors = {}
    if not failed:
        try:
            errors = {name: value for name, value in chart.measure(run).items() if math.isfinite(value)}
        except (KeyError, IndexError, ValueError, ZeroDivisionError) as error:
            failed = f"nothing to measure: {error}"
        failed = failed or ("" if errors else "ended early")
    return {"method": run.method.key, "n": f"{run.n:g}", "cpu_s": f"{statistics.median(times):.4g}", "repetitions": len(times),
            **{name: f"{errors[name]:.5g}" if name in errors else "" for name in chart.errors}, "failed": failed.replace("\n", " ")}


def keep(chart, rows):
    path(chart).parent.mkdir(parents=True, exist_ok=True)
    order = {(run.method.key, f"{run.n:g}"): k for k, run in enumerate(chart.runs)}
    with open(path(chart), "w", newline="") as file:
        writer = csv.DictWriter(file, ["method", "n", "cpu_s", "repetitions", *chart.errors, "failed"], lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted((r for r in rows.values() if (r["method"], r["n"]) in order), key=lambda r: order[r["method"], r["n"]]))


def measure(chart, level, lmp, missing):
    """The runs of one level; what was kept of them before is replaced, or left if only missing ones are wanted."""
    rows = {(r["method"], r["n"]): r for r in chart_page.kept(chart)}
    runs = [run for run in chart.runs if run.level == level and not (missing and (run.method.key, f"{run.n:g}") in rows)]
    times = {id(run): [] for run in runs}
    for turn in range(3):
        for run in runs if turn % 2 == 0 else runs[::-1]:
            if turn and (times[id(run)][0] > REPEATED or rows[run.method.key, f"{run.n:g}"]["failed"]):
                continue
            seconds, failed = once(run, lmp)
            times[id(run)].append(seconds)
            rows[run.method.key, f"{run.n:g}"] = got = row(chart, run, times[id(run)], failed)
            say(f"  {seconds:.2f} s of CPU;", "  ".join(f"{name} {got[name]}" for name in chart.errors), failed)
            keep(chart, rows)


def main():
    parser = argparse.ArgumentParser(prog="./sphsolid chart")
    parser.add_argument("case", nargs="*", choices=[[], *chart_cases.BY_KEY], help="default: all")
    parser.add_argument("--level", type=int, default=3)
    parser.add_argument("--only", type=int, help="this level alone")
    parser.add_argument("--missing", action="store_true")
    parser.add_argument("--pages", action="store_true")
    asked = parser.parse_args()
    charts = [chart for chart in CHARTS if not asked.case or chart.key in asked.case]
    if not asked.pages:
        os.environ.setdefault("LMP", str(ROOT / "build" / "lmp"))
        lmp = running.program(ROOT)
        for level in range(asked.level + 1) if asked.only is None else [asked.only]:
            for chart in charts:
                measure(chart, level, lmp, asked.missing)
        chart_page.describe(lmp)
    chart_page.write(CHARTS)


if __name__ == "__main__":
    main()
