"""What the pictures of all examples share: style, colours, particles as discs, and a small PNG file."""

import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection
from matplotlib.colors import ListedColormap

plt.rcParams.update({"font.size": 10, "axes.titlesize": 10, "figure.dpi": 110, "axes.axisbelow": True,
                     "legend.frameon": False})

COLORS = ("#4477aa", "#ee6677", "#228833", "#aa8800", "#66ccee", "#aa3377")    # of lines
STRAIN = ListedColormap(plt.get_cmap("turbo")(np.linspace(0.07, 0.97, 36)))    # of the plastic strain


def discs(axes, x, y, size, values, norm, cmap="viridis", **more):
    """Particles as discs, their diameter in units of the axes."""
    width = np.full(len(x), size)
    axes.add_collection(EllipseCollection(width, width, 0 * width, units="xy", offsets=np.column_stack((x, y)),
                                          offset_transform=axes.transData, array=np.array(values), cmap=cmap, norm=norm,
                                          edgecolors="none", **more))
    axes.set_aspect("equal")


def particles(axes, shot, size, values, norm, cmap="viridis", unit=1e-3):
    """All particles of a snapshot; unit: of the axes, in m."""
    discs(axes, np.array(shot["x"]) / unit, np.array(shot["y"]) / unit, size, values, norm, cmap)


def save(figure, folder, name):
    """Writes folder/name.png, and says so."""
    path = pathlib.Path(folder) / f"{name}.png"
    figure.savefig(path, bbox_inches="tight", pad_inches=0.08)
    plt.close(figure)
    from PIL import Image    # comes with matplotlib; 256 colours make the file three times smaller
    Image.open(path).convert("RGB").quantize(256, kmeans=2, dither=Image.Dither.NONE).save(path, optimize=True)
    try:
        print(path.relative_to(pathlib.Path.cwd()))
    except ValueError:
        print(path)
