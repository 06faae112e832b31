#!/usr/bin/env python3
"""Draws the pictures of howto.rst from what the inputs of this folder left in the folder of the run, and saves them there.

usage: plot.py rod|ball|soft|pull|impact ...

A dump that is not there is left out.  Dumps of further runs are looked for under other names: ball2.dump and soft2.dump of those
with -var n 2, impact_correct.dump of in.impact with viscosity correct."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

plt.rcParams.update({"font.size": 9, "axes.titlesize": 9})


def frames(name):
    """Snapshots of a dump file: columns by name."""
    for block in open(name).read().split("ITEM: TIMESTEP\n")[1:]:
        lines = block.splitlines()
        n, names = int(lines[2]), lines[7].split()[2:]
        values = np.array([line.split() for line in lines[8:8 + n]], float).T
        yield dict(zip(names, values))


def there(name):
    found = pathlib.Path(name).exists()
    if not found:
        print(f"there is no {name}: left out")
    return found


def save(figure, name):
    figure.savefig(name, dpi=110)
    print(f"drawn: {name}")


def bodies(axes, shot, color, top, size, title):
    dots = axes.scatter(1e3 * shot["x"], 1e3 * shot["y"], c=shot[color], s=size, vmin=0, vmax=top, cmap="viridis", lw=0)
    axes.set_aspect("equal")
    axes.set_title(title)
    axes.set_xlabel("mm")
    return dots


def rod():
    if not there("rod.dump"):
        return
    shots = list(frames("rod.dump"))
    figure, axes = plt.subplots(1, 3, figsize=(8, 3.6), sharey=True, layout="constrained")
    for at, (i, time) in zip(axes, ((0, 0), (2, 20), (5, 50))):
        dots = bodies(at, shots[i], "c_state[1]", 1.5, 3, f"{time} us")
        at.set_xlim(-11, 11)
    figure.colorbar(dots, ax=axes, label="plastic strain")
    save(figure, "rod.png")


def ball(name, titles):
    here = {dump: there(dump) for dump in dict.fromkeys(dump for dump, *_ in titles)}
    titles = [title for title in titles if here[title[0]]]
    if not titles:
        return
    figure, axes = plt.subplots(len(titles), 1, figsize=(7, 2.6 * len(titles)), sharex=True, layout="constrained")
    for at, (dump, i, size, title) in zip(np.atleast_1d(axes), titles):
        dots = bodies(at, list(frames(dump))[i], "c_state[1]", 1.0, size, title)
        at.set_ylim(-9.5, 4.5)
    figure.colorbar(dots, ax=axes, label="plastic strain")
    save(figure, name)


def pull():
    if not (there("pull.dump") and there("pull.txt")):
        return
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.2), width_ratios=(1.3, 1), layout="constrained")
    dots = bodies(axes[0], list(frames("pull.dump"))[-1], "c_state[1]", 0.3, 3, "end of the run: plastic strain")
    figure.colorbar(dots, ax=axes[0])
    elongation, force = np.loadtxt("pull.txt", comments="#").T
    axes[1].plot(elongation, force)
    axes[1].axhline(2 / 3**0.5 * 300e6 * 15e-3 * 1e-6, color="gray", ls="--", lw=1)
    axes[1].text(0.5, 5.5, "limit load, 5.20 MN/m", color="gray")
    axes[1].set(xlabel="elongation (mm)", ylabel="force on a grip (MN/m)", ylim=(0, 6.5))
    save(figure, "pull.png")


def impact():
    runs = [("impact.dump", "viscosity front"), ("impact_correct.dump", "viscosity correct (the default)")]
    runs = [(dump, label) for dump, label in runs if there(dump)]
    if not runs:
        return
    figure, axes = plt.subplots(figsize=(7, 2.8), layout="constrained")
    for dump, label in runs:
        shot = list(frames(dump))[-1]
        rows = np.argsort(shot["x"])
        axes.plot(1e3 * shot["x"][rows], -1e-9 * shot["c_state[2]"][rows], label=label, lw=1)
    axes.axhline(6.636, color="gray", ls="--", lw=1)
    axes.set(xlabel="x (mm)", ylabel="compressive stress along x (GPa)")
    axes.legend(loc="upper left")
    save(figure, "impact.png")


PICTURES = {
    "rod": rod,
    "ball": lambda: ball("ball.png", [("ball.dump", 2, 4, "20 us"), ("ball.dump", 5, 4, "50 us"),
                                      ("ball2.dump", 5, 1, "50 us, lattice twice as fine")]),
    "soft": lambda: ball("soft.png", [("soft.dump", 5, 4, "50 us"), ("soft2.dump", 5, 1, "50 us, lattice twice as fine")]),
    "pull": pull,
    "impact": impact,
}

if __name__ == "__main__":
    if len(sys.argv) < 2 or set(sys.argv[1:]) - set(PICTURES):
        sys.exit(__doc__)
    for word in sys.argv[1:]:
        PICTURES[word]()
