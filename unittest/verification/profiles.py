"""Profiles along a strip whose state depends on x alone, and their distance from an exact profile. Nothing but Python.

A profile is {name: [values]}, one value per column of particles, ordered by x."""

import math

from running import snapshots


def profile(first, shot):
    """Means over the columns of the lattice. first: the snapshot that shows the lattice, sorted by particle as shot."""
    members = {}
    for k, x in enumerate(first["x"]):
        members.setdefault(round(x * 1e9), []).append(k)    # lattice columns are far more than a nanometre apart
    found = {name: [] for name in shot}
    for _, group in sorted(members.items()):
        for name, values in shot.items():
            found[name].append(sum(values[k] for k in group) / len(group))
    order = sorted(range(len(found["x"])), key=lambda k: found["x"][k])
    return {name: [values[k] for k in order] for name, values in found.items()}


def over_time(dump):
    """[(time, profile)] of the snapshots of a run; the first shows the lattice."""
    shots = snapshots(dump)
    return [(t, profile(shots[0][1], shot)) for t, shot in shots]


def resample(xs, ys, grid):
    """Linear interpolation on an increasing grid; constant beyond the ends."""
    values, k = [], 0
    for x in grid:
        while k < len(xs) - 2 and xs[k + 1] < x:
            k += 1
        share = min(1.0, max(0.0, (x - xs[k]) / (xs[k + 1] - xs[k]))) if xs[k + 1] > xs[k] else 0.5
        values.append(ys[k] + share * (ys[k + 1] - ys[k]))
    return values


def l1(xs, ys, exact, low, high, points=4000):
    """Integral of |y - exact(x)| from low to high over that of |exact|: relative error in the L1 norm."""
    grid = [low + (high - low) * (k + 0.5) / points for k in range(points)]
    want = [exact(x) for x in grid]
    error = sum(abs(a - b) for a, b in zip(resample(xs, ys, grid), want))
    return error / sum(abs(b) for b in want)


def mean(xs, ys, low, high, points=400):
    grid = [low + (high - low) * (k + 0.5) / points for k in range(points)]
    return sum(resample(xs, ys, grid)) / points


def deviation(xs, ys, low, high):
    """Root mean square difference of the columns between low and high from their mean."""
    inside = [y for x, y in zip(xs, ys) if low < x < high]
    middle = sum(inside) / len(inside)
    return math.sqrt(sum((y - middle) ** 2 for y in inside) / len(inside))


def front(xs, ys, level):
    """Where y first exceeds a level, seen from the far right; nan if it never does."""
    for k in range(len(xs) - 1, 0, -1):
        if ys[k] <= level < ys[k - 1]:
            return xs[k] + (level - ys[k]) / (ys[k - 1] - ys[k]) * (xs[k - 1] - xs[k])
    return math.nan
