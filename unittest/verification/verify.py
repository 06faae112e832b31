#!/usr/bin/env python3
"""Runs scenes of the catalogue (catalogue.py) and judges them.

  verify.py test <scene>         the short form, for ctest: fails if a gate is missed, nothing ran, or a run crashed
  verify.py report [scene ...]   everything, and the pages doc/verification; all scenes if none is named
  verify.py measure [scene ...]  figures and pages again, from the output that the runs left
  verify.py pages [scene ...]    the pages again, from the figures kept there, without running

LMP=<program> (default build/lmp); JOBS=<n>: runs at the same time; see examples/running.py."""

import os
import sys
import time

sys.dont_write_bytecode = True
import catalogue
import report
from catalogue import ROOT, load
from running import say


def program():
    os.environ.setdefault("LMP", str(ROOT / "build" / "lmp"))
    return catalogue.running.program(ROOT)


def test(names):
    complaints, looked, ran = [], 0, 0
    for name in names:
        scene, results = load(name), catalogue.run(name, "test", program())
        for each in results:
            say(each.case.name, each.failed or "  ".join(f"{k}={v:.6g}" for k, v in each.figures.items()))
        found, gates = catalogue.complaints(scene, results)
        complaints, looked, ran = complaints + found, looked + gates, ran + sum(not r.failed for r in results)
    if not ran or not looked:
        complaints.append(f"{ran} runs came to their end and {looked} gates were looked at")
    for complaint in complaints:
        say("FAILED:", complaint)
    if complaints:
        sys.exit(1)
    say(f"{ran} runs meet {looked} gates.")


def make_report(names):
    weights = {name: sum(case.weight for case in load(name).cases("report")) for name in names}
    missed, start, done = [], time.monotonic(), 0.0
    for k, name in enumerate(names):
        pace = (time.monotonic() - start) / done if done else 1.0
        say(f"=== scene {k + 1} of {len(names)}: {name}; about {pace * sum(weights[n] for n in names[k:]):.0f} s left for all")
        scene, results = load(name), catalogue.run(name, "report", program())
        done += weights[name]
        catalogue.keep(results, scene, report.data(name))
        report.page(name, scene, results)
        missed += judge(name, scene, results)
    report.index()
    say(f"The pages are in {report.PAGES}; ./sphsolid docs makes them into web pages.")
    sys.exit(1 if missed else 0)


def judge(name, scene, results):
    """Says which gates are missed, and returns the sentences."""
    found, _ = catalogue.complaints(scene, results)
    for text in found:
        say(f"MISSED: {name}: {text}")
    return found


def measure(names):
    """From what is in the output folders; runs that failed keep their message."""
    for name in names:
        scene = load(name)
        failed = {r.case.name: r.failed for r in catalogue.kept(scene, name, report.data(name)) if r.failed}
        results = [catalogue.result(scene, each, failed.get(each.name, "")) for each in
                   catalogue.cases_of(scene, name, "report") if each.csv.exists() or each.name in failed]
        catalogue.keep(results, scene, report.data(name))
        report.page(name, scene, results)
        judge(name, scene, results)
    report.index()


def pages(names):
    for name in names:
        if report.data(name).exists():
            scene = load(name)
            report.page(name, scene, catalogue.kept(scene, name, report.data(name)))
    report.index()


COMMANDS = {"test": test, "report": make_report, "measure": measure, "pages": pages}


def main():
    command, names = sys.argv[1] if len(sys.argv) > 1 else "", sys.argv[2:]
    if command not in COMMANDS or (command == "test" and not names):
        sys.exit(__doc__)
    COMMANDS[command](names or catalogue.names())


if __name__ == "__main__":
    main()
