"""Draws the shear stress in the middle of the square against the angle, and the squares at 45 degrees.

python3 plot.py [folder]     folder: where the picture goes, default output"""

import sys

import numpy as np

sys.dont_write_bytecode = True
import measure
from drawing import COLORS, plt, save    # beside running.py; measure has put that folder on the path
from measure import OUTPUT

folder = sys.argv[1] if len(sys.argv) > 1 else OUTPUT
figure, axes = plt.subplots(1, 3, figsize=(11.5, 3.7), width_ratios=(1.35, 1, 1), constrained_layout=True)

angle = np.linspace(0, 90, 181)
axes[0].plot(angle, np.sin(np.radians(2 * angle)), "k-", lw=1, label="exact: sin 2 t")
for name, color, marker in (("sph-solid", COLORS[0], "o"), ("ulsph", COLORS[1], "s")):
    if (OUTPUT / f"{name}.dump").exists():
        angles, values = measure.history(name)
        axes[0].plot(angles, [v[1] for v in values], marker, ms=4.5, color=color, label=measure.BY_NAME[name].title)
axes[0].set(xlabel="angle t of the square (degrees)", ylabel="sxy in the middle / stress before", xlim=(-2, 92),
            xticks=range(0, 91, 15), ylim=(-1.15, 1.7))
axes[0].axhline(0, color="0.8", lw=0.8, zorder=0)
axes[0].legend(loc="upper left", fontsize=8.5)

dots = None
for ax, name in zip(axes[1:], ("sph-solid", "ulsph")):
    if (OUTPUT / f"{name}.dump").exists():
        shots = measure.snapshots(name)
        atoms = next(a for t, a in shots if abs(t - 45) < 1e-6)
        rows = np.array(list(atoms.values()))
        dots = ax.scatter(rows[:, 0] * 1e3, rows[:, 1] * 1e3, c=rows[:, 4] * 1e-6, s=20, cmap="RdBu", vmin=-200, vmax=200)
    ax.set(title=f"{name}: sxy at 45 degrees", aspect="equal", xlim=(-15, 15), ylim=(-15, 15), xlabel="mm")
if dots is not None:
    figure.colorbar(dots, ax=axes[1:], label="MPa", shrink=0.85)
save(figure, folder, "prestress")
