"""What the `run` scripts of the examples share: finding the program, running cases with progress and time left,
judging them, reading CSV and dump files. Needs nothing but Python.

A case is any object with name, script, variables (for -var) and weight (expected run time, relative). It may have a
folder of its own to run in, and an output folder for its files.
Environment: LMP=<program> (default ../../build/lmp), JOBS=<n>: runs at the same time (default: 2 where there are
two processors), PYTHON=<python3 with numpy and matplotlib> for the pictures."""

import csv
import math
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait


def say(*words, **more):
    print(*words, flush=True, **more)


def program(here):
    """LMP, or build/lmp, as the command line of a run in this folder shows it."""
    lmp = os.environ.get("LMP") or str(here / "../../build/lmp")
    found = shutil.which(lmp)
    if not found:
        sys.exit(f"There is no program {lmp}: build it with \"./sphsolid build\", or set LMP.")
    return os.path.abspath(found) if os.environ.get("LMP") else os.path.relpath(os.path.abspath(found), here)


def empty(output):
    """The output folder without what an earlier run left there."""
    output.mkdir(exist_ok=True)
    for old in output.iterdir():
        if old.suffix in (".csv", ".dump", ".log", ".png", ".md"):
            old.unlink()


def places(here, case, output):
    """Folder that a case runs in and folder of its output: its own, where it has them."""
    return getattr(case, "folder", here), pathlib.Path(getattr(case, "output", here / output))


def simulate(here, lmp, case, output="output", quiet=False, limit=None):
    """Runs a case; limit: seconds after which a run that gets nowhere is ended."""
    folder, out = places(here, case, output)
    command = ["timeout", str(limit)] if limit else []
    command += [lmp, "-in", case.script, "-log", os.path.relpath(out / f"{case.name}.log", folder), "-screen", "none"]
    elsewhere = {} if str(output) == "output" else {"out": output}    # the default of all inputs
    for name, value in {**case.variables, **elsewhere, "label": case.name}.items():
        command += ["-var", name, str(value)]
    if not quiet:
        say("+", shlex.join(command))
    start = time.monotonic()
    result = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                            env={**os.environ, "OMP_NUM_THREADS": "1"})
    return case, result, time.monotonic() - start


def simulate_all(here, lmp, cases, output="output", after=None):
    """Runs the cases; {name: last error message} of those that did not come to their end. With after, a function of
    a case and its error message: it is called when a run has ended, and what it returns is shown in one line."""
    workers = int(os.environ.get("JOBS") or min(2, os.cpu_count() or 1))
    total, done, start, failed = sum(case.weight for case in cases), 0.0, time.monotonic(), {}
    say("+ cd", shlex.quote(os.path.relpath(here)))
    with ThreadPoolExecutor(workers) as pool:
        waiting = {pool.submit(simulate, here, lmp, case, output, after is not None)
                   for case in sorted(cases, key=lambda c: -c.weight)}
        count = 0
        while waiting:
            finished, waiting = wait(waiting, return_when=FIRST_COMPLETED)
            for future in finished:
                case, result, seconds = future.result()
                count, done = count + 1, done + case.weight
                left = (time.monotonic() - start) * (total - done) / done
                if result.returncode:
                    failed[case.name] = last_error(places(here, case, output)[1] / f"{case.name}.log")
                if after:
                    say(f"[{count}/{len(cases)}, {left:.0f} s left] {case.name}: {after(case, failed.get(case.name))}")
                    continue
                say(f"[{count}/{len(cases)}] {case.name}: {seconds:.1f} s, about {left:.0f} s left")
                if result.returncode:
                    say(f"{case.name} ended with status {result.returncode}: {failed[case.name]}", result.stderr)
    return failed


def last_error(log):
    lines = log.read_text().splitlines() if log.exists() else []
    errors = [line for line in lines if "ERROR" in line]
    return errors[-1] if errors else " / ".join(lines[-3:])


def draw(here):
    """plot.py of the example; True if it made its pictures."""
    command = [os.environ.get("PYTHON") or "python3", "plot.py"]
    say("+", shlex.join(command))
    return subprocess.run(command, cwd=here).returncode == 0


def forgive(cases, failed):
    """Takes the runs that may fail out of {name: message}, and says so."""
    for case in cases:
        if case.may_fail and case.name in failed:
            say(f"{case.name} ended early, as it may: {failed.pop(case.name)}")


def exceeded(case, figures):
    """What is beyond its limit or not a number, in words; figures: (text, value, limit)."""
    return [f"{case.name}: {text} {value:.3g}, allowed {limit:.3g}" for text, value, limit in figures
            if not abs(value) <= limit]


def example(here, measure, cases, table, words=""):
    """What most `run` scripts do: the runs, their table (a function of the cases) below the words that explain it, the
    gates of measure, and the pictures."""
    lmp = program(here)
    empty(measure.OUTPUT)
    failed = simulate_all(here, lmp, cases)
    forgive(cases, failed)

    text = table(cases)
    (measure.OUTPUT / "table.md").write_text(text)
    say(f"\n{words}{text}")

    complaints = []
    for case in cases:
        if case.gated and case.name not in failed:
            complaints += measure.missed(case, measure.figures(case))
    verdict(failed, complaints, draw(here), sum(case.gated for case in cases))


def verdict(failed, complaints, plotted, gated):
    """Says what went wrong, and ends with status 1 if anything did."""
    for name, why in failed.items():
        say(f"FAILED: {name} did not run: {why}")
    for complaint in complaints:
        say(f"FAILED: {complaint}")
    if not plotted:
        say("FAILED: no pictures")
    if failed or complaints or not plotted:
        sys.exit(1)
    say(f"All {gated} gated runs meet their figures.")


# ---- files --------------------------------------------------------------------------------------------------

def columns(path):
    """A CSV file as a dictionary of columns."""
    with open(path) as file:
        rows = [row for row in csv.reader(file) if row]
    return {name: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}


def at(x, xs, ys):
    """Linear interpolation; the last value beyond the end."""
    for k in range(1, len(xs)):
        if x <= xs[k]:
            return ys[k - 1] + (ys[k] - ys[k - 1]) * (x - xs[k - 1]) / (xs[k] - xs[k - 1])
    return ys[-1]


def snapshots(path):
    """The snapshots of a dump file: a list of (time in s, {column: values}), sorted by particle."""
    shots = []
    with open(path) as file:
        moment = 0.0
        for line in file:
            if line.startswith("ITEM: TIME\n"):
                moment = float(next(file))
            elif line.startswith("ITEM: NUMBER"):
                count = int(next(file))
            elif line.startswith("ITEM: ATOMS"):
                names = line.split()[2:]
                rows = [[float(word) for word in next(file).split()] for _ in range(count)]
                shots.append((moment, {name: [row[k] for row in rows] for k, name in enumerate(names)}))
    return shots


def loops(log):
    """User CPU seconds of each run in a log file, summed over ranks and threads; resolution 0.1 % of the elapsed time."""
    text = pathlib.Path(log).read_text()
    times = re.findall(r"Loop time of (\S+) on (\d+) procs", text)
    shares = re.findall(r"([\d.]+)% CPU use with (\d+) MPI tasks", text)
    return [float(time) * float(share) / 100 * int(tasks) for (time, _), (share, tasks) in zip(times, shares)]


def seconds(log):
    """CPU seconds of all runs in a log file."""
    return sum(loops(log))


def number(value, form):
    """A cell of a table."""
    return "-" if math.isnan(value) else format(value, form)


def markdown(head, rows, left=1):
    """A table; the first columns left, the others right."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * left + "--:|" * (len(head) - left)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"
