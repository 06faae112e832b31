#!/usr/bin/env python3
"""Runs scenes of the catalogue (catalogue.py) and judges them.

  verify.py test <scene>         the short form, for ctest: fails if a gate is missed, nothing ran, or a run crashed
  verify.py report [scene ...]   everything, and the pages doc/verification; all scenes if none is named
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
        missed += [f"{name}: {text}" for text in catalogue.complaints(scene, results)[0]]
    report.index()
    for text in missed:
        say("MISSED:", text)
    say(f"The pages are in {report.PAGES}; ./sphsolid docs makes them into web pages.")
    sys.exit(1 if missed else 0)


def pages(names):
    for name in names:
        if report.data(name).exists():
            scene = load(name)
            report.page(name, scene, catalogue.kept(scene, name, report.data(name)))
    report.index()


def main():
    command, names = sys.argv[1] if len(sys.argv) > 1 else "", sys.argv[2:]
    if command not in ("test", "report", "pages") or (command == "test" and not names):
        sys.exit(__doc__)
    {"test": test, "report": make_report, "pages": pages}[command](names or catalogue.names())


if __name__ == "__main__":
    main()
