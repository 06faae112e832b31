#!/usr/bin/env python3
"""./sphsolid bench: throughput, memory and instructions of this package and of the styles that come with LAMMPS.

  bench.py [--quick | --large] [--repeat n]   runs everything in turns, writes results/<date>.csv and README.md
             --quick: 10^4 particles only, and nothing is written; --large: up to 4*10^6 particles too
  bench.py --instructions                     counts instructions (lmp_counted), writes instructions.csv and README.md
  bench.py --compare                          the newest results over those before
  bench.py --pages                            README.md again, from what is kept
  bench.py test <lmp_counted> <compiler>      what ctest runs

Environment: LMP=<program> (default ../build/lmp), MPIEXEC=<program>."""

import argparse
import csv
import datetime
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys

sys.dont_write_bytecode = True
import block
import counted
import machine
import report
from variants import BLOCKS, measured_on

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ("dim", "particles", "key", "ranks", "threads", "h", "neighbors", "repetitions", "ns", "ns_least", "ns_most",
           "elapsed_ns", "peak_bytes", "ns_small")
ROOM = {2: 2.0e3, 3: 4.5e3}    # bytes a particle may need, to see whether a block fits into the memory


def say(*words):
    print(*words, flush=True)


# ---- times and memory ----------------------------------------------------------------------------------------

def turns(variants, repeat):
    """A B C, C B A, A B C ...: a drift of the machine's speed meets all alike."""
    for k in range(repeat):
        yield from ((k, variant) for variant in (variants if k % 2 == 0 else variants[::-1]))


def possible(variant, each):
    if variant.ranks > 1 and not (os.environ.get("MPIEXEC") or shutil.which("mpiexec")):
        return "no mpiexec"
    if ROOM[each.dim] * each.count > block.free_memory():
        return "not enough free memory"
    return ""


def beside(variant, each):
    """Cost of the smallest block at the same time, for the growth of costs with size: None of variants that are not run at all sizes."""
    small = next(b for b in BLOCKS if b.dim == each.dim)
    if each == small or not variant.large or variant.ranks * variant.threads > 1:
        return None
    return block.run(variant, small).nanoseconds


def measure(each, variants, repeat):
    """The rows of one block."""
    left_out = {v.key: possible(v, each) for v in variants}
    for key, why in left_out.items():
        if why:
            say(f"{each.dim}D, {each.count} particles, {key}: left out, {why}")
    variants = [v for v in variants if not left_out[v.key]]
    costs, small = {v.key: [] for v in variants}, {v.key: [] for v in variants}
    for k, variant in turns(variants, repeat):
        try:
            before = beside(variant, each)
            costs[variant.key].append(block.run(variant, each))
            if before:
                small[variant.key].append((before, beside(variant, each)))
        except RuntimeError as error:
            say(f"{variant.key} does not run: {str(error).splitlines()[-1]}")
            continue
        got = costs[variant.key][-1]
        say(f"{each.dim}D, {each.count} particles, {k + 1}/{repeat}, {variant.title}: {got.nanoseconds:.0f} ns")
    return [row(each, v, costs[v.key], small[v.key]) for v in variants if costs[v.key]]


def row(each, variant, costs, small):
    times = [c.nanoseconds for c in costs]
    return {"dim": each.dim, "particles": each.count, "key": variant.key, "ranks": variant.ranks, "threads": variant.threads,
            "h": variant.h, "neighbors": f"{costs[-1].neighbors:.1f}", "repetitions": len(costs),
            "ns": f"{statistics.median(times):.1f}", "ns_least": f"{min(times):.1f}", "ns_most": f"{max(times):.1f}",
            "elapsed_ns": f"{statistics.median(c.elapsed for c in costs):.1f}",
            "peak_bytes": "" if math.isnan(costs[-1].peak) else f"{max(c.peak for c in costs):.0f}",
            "ns_small": f"{statistics.median(sum(pair) / 2 for pair in small):.1f}" if small else ""}


def throughput(level, repeat):
    described, rows = machine.describe(block.LMP), []
    for each in BLOCKS:
        if each.level <= level:
            times = repeat if each.level < 2 else 1
            rows += measure(each, measured_on(each, level == 2), times)
            keep(rows, described, level)
    return rows, described


def keep(rows, described, level):
    """After every block, so that a run that is cut off leaves what it has."""
    if level == 0:
        return
    path = HERE / "results" / f"{datetime.date.today().isoformat()}.csv"
    path.parent.mkdir(exist_ok=True)
    with open(path, "w", newline="") as file:
        for what, text in described.items():
            file.write(f"# {what}: {text}\n")
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


# ---- the commands --------------------------------------------------------------------------------------------

def build_counted():
    """Path of lmp_counted, after building it."""
    folder = machine.BUILD
    subprocess.run(["cmake", "--build", str(folder), "--target", "lmp_counted"], check=True)
    return next(str(path) for path in (folder / "bench" / "lmp_counted", folder / "lmp_counted") if path.exists())


def test(lmp, compiler):
    complaints = counted.complaints(counted.count(lmp, only_ratios=True, say=say), compiler, say)
    for text in complaints:
        say("FAILED:", text)
    sys.exit(1 if complaints else 0)


def main():
    if sys.argv[1:2] == ["test"]:
        test(*sys.argv[2:4])
    parser = argparse.ArgumentParser(prog="./sphsolid bench")
    for flag in ("quick", "large", "instructions", "compare", "pages"):
        parser.add_argument(f"--{flag}", action="store_true")
    parser.add_argument("--repeat", type=int, default=3)
    asked = parser.parse_args()
    if asked.compare:
        say(report.comparison())
        return
    if asked.instructions:
        counted.keep(counted.count(build_counted(), say=say), machine.cached("CMAKE_CXX_COMPILER") or "c++")
    elif not asked.pages:
        level = 0 if asked.quick else 2 if asked.large else 1
        rows, _ = throughput(level, asked.repeat)
        if level == 0:
            say(report.times([{k: str(v) for k, v in r.items()} for r in rows]))
            return
    report.write()
    say("bench/README.md is written.")


if __name__ == "__main__":
    main()
