"""Numbers that are read off what a run left: off the lines of its history, off a snapshot. Nothing but Python."""

import math


# ---- over time ----------------------------------------------------------------------------------------------

def largest(values):
    """Largest of the values; not a number if one of them is none, which max() may pass over."""
    return max(values, key=lambda value: (math.isnan(value), value))


def drift(values):
    """Largest change of what should stay as it was at first, over that."""
    return largest(abs(value / values[0] - 1) for value in values)


def crossings(t, y, first=1):
    """Times at which y changes sign, from line `first` on."""
    return [t[k - 1] + (t[k] - t[k - 1]) * y[k - 1] / (y[k - 1] - y[k]) for k in range(first, len(t)) if y[k - 1] * y[k] < 0]


def slope(ys, xs=None):
    """Of the straight line through these values, by least squares; without xs they are at 0, 1, 2, ..."""
    xs = range(len(ys)) if xs is None else xs
    x0, y0 = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((x - x0) * (y - y0) for x, y in zip(xs, ys)) / sum((x - x0) ** 2 for x in xs)


# ---- between particles --------------------------------------------------------------------------------------

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
