"""Draws the pictures of this example from the runs in output/; what has not been run is left out.

python3 plot.py [folder]     folder: where the pictures go, default output"""

import sys

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

sys.dont_write_bytecode = True
import measure
from cases import BY_NAME
from drawing import COLORS, particles, plt, save    # beside running.py; measure has put that folder on the path
from measure import OUTPUT


def pick(scene, names):
    """Those of the cases that have run, in this order."""
    cases = [BY_NAME[f"{scene}-{name}"] for name in names if f"{scene}-{name}" in BY_NAME]
    return [case for case in cases if measure.has_run(case)]


def title(case):
    text = f"{case.frame}, h = {case.h}, {case.title}"
    return text + (f", jitter {100 * case.jitter:.0f} %" if case.jitter else "")


def plate(folder):
    cases = pick("plate", ["lagrangian-h0.8-correct-channel-10", "lagrangian-h1.3-correct-channel-10",
                           "lagrangian-h0.8-correct-channel-20", "eulerian-h1.3-correct-channel-10", "eulerian-h1.3-0.5-channel-10"])
    if not cases:
        return
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.2, 3.7), layout="constrained")
    for case, color in zip(cases, COLORS):
        data = measure.read(case)
        text = f"{case.frame}, {case.variables['rows']} rows, h = {case.h}, {case.title}"
        energy = (np.array(data["kinetic_J"]) + np.array(data["elastic_J"])) / data["kinetic_J"][0]
        left.plot(data["t_s"], np.array(data["tip_mm"]) - data["tip_mm"][0], color=color, lw=1.3, label=text)
        right.plot(data["t_s"], energy, color=color, lw=1.3, label=text)
    for k in range(1, 5):
        left.axvline(k * measure.PERIOD["channel"] / 2, color="0.6", lw=0.8, ls="--")
    left.set(xlabel="time (s)", ylabel="tip (mm)", title="bonded in a channel; dashed: exact zero crossings")
    right.set(xlabel="time (s)", ylabel="kinetic + elastic energy, over the initial one", ylim=(0, 1.05))
    right.legend(fontsize=8)
    for axes in (left, right):
        axes.grid(color="0.92")
        axes.set_xlim(0, 0.6)
    save(figure, folder, "plate")

    case = cases[0]
    shots = measure.shots_of(case)[:5]
    figure, grid = plt.subplots(len(shots), 1, figsize=(7.0, 1.55 * len(shots)), sharex=True, layout="constrained")
    scale = max(max(map(abs, shot["sxx"])) for _, shot in shots) / 1e3 or 1.0
    norm = Normalize(-scale, scale)
    for axes, (moment, shot) in zip(np.atleast_1d(grid), shots):
        particles(axes, shot, 1.9, np.array(shot["sxx"]) / 1e3, norm, "RdBu_r")
        axes.set(xlim=(-54, 206), ylim=(-42, 42), ylabel="y (mm)")
        axes.set_facecolor("0.86")
        axes.set_title(f"{moment:.3f} s", loc="right", y=0.76, fontsize=9)
    axes.set_xlabel("x (mm)")
    figure.colorbar(ScalarMappable(norm=norm, cmap="RdBu_r"), ax=grid, label="stress along the plate (kPa)")
    save(figure, folder, "plate-shapes")


def strip(folder):
    cases = pick("strip", ["lagrangian-h1.0-correct", "lagrangian-h1.3-correct-jitter0.25", "eulerian-h1.3-0.5", "eulerian-h1.3-correct"])
    if not cases:
        return
    norm = Normalize(0, measure.tension(0.5) / 1e6)
    figure, grid = plt.subplots(len(cases), 1, figsize=(7.4, 1.65 * len(cases)), sharex=True, layout="constrained", squeeze=False)
    for axes, case in zip(grid[:, 0], cases):
        moment, shot = measure.shots_of(case)[-1]
        particles(axes, shot, 0.8, np.array(shot["sxx"]) / 1e6, norm)
        ended = measure.read(case)["elongation"][-1]
        axes.set(xlim=(-33, 33), ylim=(-6, 6), ylabel="y (mm)", title=f"{title(case)}: {100 * moment * 100:.0f} % longer" +
                 ("" if ended > 0.49 else f", stopped at {100 * ended:.0f} %"))
    axes.set_xlabel("x (mm)")
    figure.colorbar(ScalarMappable(norm=norm, cmap="viridis"), ax=grid, label="stress along the strip (MPa)")
    save(figure, folder, "strip")

    figure, axes = plt.subplots(figsize=(6.0, 3.8), layout="constrained")
    for case, color in zip(cases, COLORS):
        data = measure.read(case)
        axes.plot(data["elongation"], np.array(data["sxx_Pa"]) / 1e6, color=color, lw=1.4, label=title(case))
    elongation = np.linspace(0, 0.5, 60)
    axes.plot(elongation, [measure.tension(e) / 1e6 for e in elongation], "k--", lw=1.1, label="exact")
    axes.set(xlim=(0, 0.5), xlabel="elongation", ylabel="mean stress in the middle (MPa)", ylim=(-10, None))
    axes.grid(color="0.92")
    axes.legend(fontsize=8)
    save(figure, folder, "strip-stress")


def ring(folder):
    cases = pick("ring", ["lagrangian-h1.0-correct", "lagrangian-h1.3-correct-jitter0.25", "eulerian-h1.3-correct", "eulerian-h1.3-0.5"])
    if not cases:
        return
    figure, grid = plt.subplots(1, len(cases), figsize=(3.6 * len(cases), 3.6), sharey=True, squeeze=False, layout="constrained")
    for axes, case in zip(grid[0], cases):
        shot = measure.shots_of(case)[-1][1]
        particles(axes, shot, 0.9, np.array(shot["vonmises"]) / 1e6, Normalize(0, 4))
        axes.set(xlim=(-45, 45), ylim=(-45, 45), xlabel="x (mm)", title=title(case))
    grid[0, 0].set_ylabel("y (mm)")
    figure.colorbar(ScalarMappable(norm=Normalize(0, 4), cmap="viridis"), ax=grid, label="von Mises stress (MPa)")
    save(figure, folder, "ring")

    figure, axes = plt.subplots(figsize=(6.0, 3.6), layout="constrained")
    for case, color in zip(cases, COLORS):
        data = measure.read(case)
        axes.plot(data["turns"], (np.array(data["kinetic_J"]) + np.array(data["elastic_J"])) / data["kinetic_J"][0], color=color,
                  lw=1.3, label=title(case))
    axes.set(xlabel="turns", ylabel="kinetic + elastic energy, over the initial one")
    axes.grid(color="0.92")
    axes.legend(fontsize=8)
    save(figure, folder, "ring-energy")


def square(folder):
    cases = pick("square", ["lagrangian-h1.0-correct", "lagrangian-h1.3-correct-jitter0.25", "eulerian-h1.3-correct"])
    if not cases:
        return
    norm = Normalize(0, 130)
    figure, grid = plt.subplots(len(cases), 4, figsize=(9.6, 2.5 * len(cases)), squeeze=False, layout="constrained",
                                sharex=True, sharey=True)
    for row, case in zip(grid, cases):
        shots = measure.shots_of(case)
        for axes, k in zip(row, (0, 1, 4, 8)):
            if k < len(shots):
                particles(axes, shots[k][1], 0.9, np.array(shots[k][1]["vonmises"]) / 1e6, norm)
                axes.set(xlim=(-15, 15), ylim=(-15, 15), title=f"{k}/8 turn")
        row[0].set_ylabel(title(case).replace(", ", "\n"), fontsize=8)
    figure.colorbar(ScalarMappable(norm=norm, cmap="viridis"), ax=grid, label="von Mises stress (MPa)")
    save(figure, folder, "square")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else OUTPUT
    for scene in (plate, strip, ring, square):
        scene(folder)


if __name__ == "__main__":
    main()
