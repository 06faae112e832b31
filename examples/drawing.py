"""What the pictures of all examples share: style, and a small PNG file."""

import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({"font.size": 10, "axes.titlesize": 10, "figure.dpi": 110, "axes.axisbelow": True,
                     "legend.frameon": False})


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
