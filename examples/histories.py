"""Numbers over time: what is read off the lines that a run prints. Nothing but Python."""

import math


def drift(values):
    """Largest change of what should stay as it was at first, over that; not a number if one of the values is none."""
    return max((abs(value / values[0] - 1) for value in values), key=lambda change: (math.isnan(change), change))


def crossings(t, y, first=1):
    """Times at which y changes sign, from line `first` on."""
    return [t[k - 1] + (t[k] - t[k - 1]) * y[k - 1] / (y[k - 1] - y[k]) for k in range(first, len(t)) if y[k - 1] * y[k] < 0]


def slope(values):
    """Of a straight line through values at 0, 1, 2, ..."""
    n = len(values)
    mean, middle = sum(values) / n, (n - 1) / 2
    return sum((k - middle) * (v - mean) for k, v in enumerate(values)) / sum((k - middle) ** 2 for k in range(n))
