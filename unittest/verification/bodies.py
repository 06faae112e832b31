"""What the scenes with two-dimensional bodies share: distances between particles, pictures of a body.

Measuring needs nothing but Python."""

import math


def buckets(x, y, size):
    """{cell: particles in it} of a grid."""
    grid = {}
    for k, (u, v) in enumerate(zip(x, y)):
        grid.setdefault((math.floor(u / size), math.floor(v / size)), []).append(k)
    return grid


def close_pairs(x, y, reach):
    """(i, j, distance) of all pairs of particles closer than reach, i < j."""
    grid = buckets(x, y, reach)
    for (p, q), here in grid.items():
        near = [j for a in (p - 1, p, p + 1) for b in (q - 1, q, q + 1) for j in grid.get((a, b), ())]
        for i in here:
            for j in near:
                if i < j:
                    distance = math.hypot(x[i] - x[j], y[i] - y[j])
                    if distance < reach:
                        yield i, j, distance


def closest(shot, spacing):
    """Distance of the two closest particles, in spacings."""
    return min((d for _, _, d in close_pairs(shot["x"], shot["y"], 1.5 * spacing)), default=math.inf) / spacing


def pieces(shot, reach):
    """Sizes of what hangs together, largest first: particles joined by distances below reach."""
    root = list(range(len(shot["x"])))

    def find(k):
        while root[k] != k:
            root[k] = root[root[k]]
            k = root[k]
        return k

    for i, j, _ in close_pairs(shot["x"], shot["y"], reach):
        root[find(i)] = find(j)
    sizes = {}
    for k in range(len(root)):
        sizes[find(k)] = sizes.get(find(k), 0) + 1
    return sorted(sizes.values(), reverse=True)


def particles(axes, shot, size, values, norm, cmap="viridis", unit=1.0):
    """A body as dots of the given size in units of the plot; unit: of the plot, in m."""
    import numpy as np
    from matplotlib.collections import EllipseCollection
    x, y = np.array(shot["x"]) / unit, np.array(shot["y"]) / unit
    width = np.full(len(x), size)
    axes.add_collection(EllipseCollection(width, width, 0 * width, units="xy", offsets=np.column_stack((x, y)),
                                          offset_transform=axes.transData, array=np.array(values), cmap=cmap, norm=norm,
                                          edgecolors="none"))
    axes.set_aspect("equal")


def colour_bar(figure, axes):
    """Beside the axes, for what was drawn there first; an inset, so that the legend of pictures.py keeps its room."""
    figure.colorbar(axes.collections[0], cax=axes.inset_axes([1.02, 0.1, 0.04, 0.8]))


def main_series(results):
    """Those that ran with nothing but the settings of their method."""
    return [r for r in results if not r.failed and r.case.series == r.case.method.key]


def errors(axes, results, name, floor=0.0, line=None, more=()):
    """Convergence of the main series, and of the series in more, named by their ending; line: (order, n, error)."""
    import pictures
    from catalogue import series
    if line:
        pictures.slope(axes, *line)
    for (name_of, group), mark in zip(((k, g) for k, g in series(results).items() if k in more), "sv^"):
        axes.loglog([r.case.n for r in group], [max(abs(r.figures[name]), floor) for r in group], "k:", marker=mark, ms=4, lw=1,
                    label=f"Lagrangian: {group[0].case.method.title}, {name_of.split('-')[-1]}")
    pictures.convergence(axes, main_series(results), name, floor)
