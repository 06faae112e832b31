"""What the figures were measured on: processor, compiler, flags, LAMMPS. No names of machines."""

import os
import pathlib
import re
import subprocess

BUILD = pathlib.Path(os.environ.get("LMP") or pathlib.Path(__file__).resolve().parent / "../build/lmp").parent


def output(*words):
    try:
        return subprocess.run(words, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    except OSError:
        return ""


def cached(name):
    cache = BUILD / "CMakeCache.txt"
    found = re.search(rf"^{name}(?::\w+)?=(.*)$", cache.read_text(), re.M) if cache.exists() else None
    return found.group(1) if found else ""


def compiler(path=None):
    lines = output(path or cached("CMAKE_CXX_COMPILER") or "c++", "--version").splitlines()
    return lines[0].strip() if lines else "unknown"


def lammps(lmp):
    found = re.search(r"(?:Massively Parallel Simulator|LAMMPS)[^\n]*- ([^\n]+)", output(lmp, "-help"))
    return found.group(1).strip() if found else "unknown"


def describe(lmp):
    """{what: text}"""
    cpu = dict(re.findall(r"^([^:\n]+):\s+(.*)$", output("lscpu"), re.M))
    flags = f"{cached('CMAKE_BUILD_TYPE')}: {cached('CMAKE_CXX_FLAGS_RELEASE')}; SPHSOLID_ARCH = {cached('SPHSOLID_ARCH')}"
    return {
        "processor": cpu.get("Model name", "unknown"), "processors": str(os.cpu_count()),
        "second-level cache": cpu.get("L2 cache", "unknown"), "third-level cache": cpu.get("L3 cache", "unknown"),
        "compiler": compiler(), "flags": flags, "LAMMPS": lammps(lmp),
        "processes that wanted to run, at the start (processors)": f"{os.getloadavg()[0]:.1f} ({os.cpu_count()})",
    }
