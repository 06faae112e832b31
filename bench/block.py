"""Runs a block, and reads what it cost."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "examples"))

from running import loops

LMP = os.environ.get("LMP") or str(HERE / "../build/lmp")


@dataclass(frozen=True)
class Cost:
    nanoseconds: float      # user CPU of all ranks and threads, per particle and step
    elapsed: float          # elapsed, the same way
    neighbors: float
    peak: float             # resident memory of the process, bytes; nan with several ranks


def command(lmp, script, variables, dim, n, steps, warm, log="none"):
    words = [lmp, "-in", script, "-log", str(log), "-nocite", "-screen", "none"]
    for name, value in {"dim": dim, "n": n, "warm": warm, "steps": steps, **variables}.items():
        words += ["-var", name, str(value)]
    return words


def environment(threads=1):
    return {**os.environ, "OMP_NUM_THREADS": str(threads), "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def run(variant, block, warm=3):
    """The Cost of one run."""
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder) / "log"
        words = command(LMP, variant.script, variant.variables, block.dim, block.n, block.steps, warm, log)
        if variant.ranks > 1:
            words = [os.environ.get("MPIEXEC") or shutil.which("mpiexec") or "mpiexec", "-n", str(variant.ranks)] + words
        child = subprocess.Popen(words, cwd=HERE, env=environment(variant.threads), stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        text = log.read_text() if log.exists() else ""
        if child.returncode:
            raise RuntimeError(f"{' '.join(words)} failed:\n{text[-1500:]}")
        count, neighbors = map(float, re.search(r"^cost (\S+) (\S+)", text, re.M).groups())
        each = 1e9 / (count * block.steps)
        elapsed = float(re.findall(r"Loop time of (\S+)", text)[-1])
        return Cost(loops(log)[-1] * each, elapsed * each, neighbors,
                    usage.ru_maxrss * 1024.0 if variant.ranks == 1 else float("nan"))


def instructions(lmp, script, variables, block, warm=3):
    """Instructions per particle and step, counted by valgrind: a long run minus a short one, both without output."""
    counts = []
    for steps in (2, 2 + block.steps):
        words = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
        words += command(lmp, script, variables, block.dim, block.n, steps, warm)
        result = subprocess.run(words, cwd=HERE, env=environment(), capture_output=True, text=True)
        found = re.search(r"Collected\s*:\s*(\d+)", result.stderr)
        if result.returncode or not found:
            raise RuntimeError(f"{' '.join(words)} failed:\n{result.stderr[-1500:]}")
        counts.append(int(found.group(1)))
    return (counts[1] - counts[0]) / (block.count * block.steps)


def free_memory():
    """Bytes that a run may take: what is available now."""
    with open("/proc/meminfo") as file:
        return float(re.search(r"MemAvailable:\s+(\d+)", file.read()).group(1)) * 1024
