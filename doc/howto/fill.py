#!/usr/bin/env python3
"""Fills a closed surface (STL file, text or binary) with particles on a cubic lattice, for read_data.

usage: fill.py <surface.stl> <spacing> <file.data> [scale]

The points are centers of lattice cells.  They share the volume inside the surface equally; mass, density and energy are 0,
which means: from the material.  scale: unit of the file in units of the run, for example 1e-3 for millimeters in si."""

import sys

import numpy as np


def triangles(name):
    """Corners of the triangles: n x 3 x 3."""
    raw = open(name, "rb").read()
    n = int.from_bytes(raw[80:84], "little")
    if len(raw) == 84 + 50 * n:
        facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
        return np.frombuffer(raw, facet, n, 84)["corners"].astype(float)
    words = [line.split()[1:] for line in raw.decode().splitlines() if line.split()[:1] == ["vertex"]]
    return np.array(words, float).reshape(-1, 3, 3)


def crossings(surface, x, y):
    """Heights at which the line (x, y) passes through the surface, ascending."""
    a, b, c = (surface[:, k, :2] - (x, y) for k in range(3))
    weights = np.array([p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] for p, q in ((b, c), (c, a), (a, b))])
    hit = (weights > 0).all(0) | (weights < 0).all(0)
    shares = weights[:, hit] / weights[:, hit].sum(0)
    return np.sort((shares * surface[hit, :, 2].T).sum(0))


def fill(surface, d):
    low, high = surface.min((0, 1)), surface.max((0, 1))
    count = np.ceil((high - low) / d - 1e-9).astype(int)
    start = 0.5 * (low + high - (count - 1) * d)
    axes = [s + d * np.arange(n) for s, n in zip(start, count)]
    points = []
    for x in axes[0]:
        for y in axes[1]:
            # not quite through corners and edges, which belong to several triangles
            z = crossings(surface, x + 1.3e-6 * d, y + 2.7e-6 * d)
            inside = np.searchsorted(z, axes[2]) % 2 == 1
            points += [(x, y, height) for height in axes[2][inside]]
    return np.array(points)


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    d = float(sys.argv[2])
    surface = triangles(sys.argv[1]) * float(sys.argv[4] if len(sys.argv) == 5 else 1)
    points = fill(surface, d)
    volume = abs(np.linalg.det(surface).sum()) / 6
    margin = 0.5 * np.ptp(points, 0)
    low, high = points.min(0) - margin, points.max(0) + margin
    with open(sys.argv[3], "w") as out:
        out.write(f"particles in {sys.argv[1]}, spacing {d}\n\n{len(points)} atoms\n1 atom types\n\n")
        for k, axis in enumerate("xyz"):
            out.write(f"{low[k]:.10g} {high[k]:.10g} {axis}lo {axis}hi\n")
        out.write("\nAtoms # sph/solid\n\n")
        for k, point in enumerate(points, 1):
            out.write(f"{k} 1 {volume / len(points):.10g} 0 0 0 {point[0]:.10g} {point[1]:.10g} {point[2]:.10g}\n")
    print(f"{len(points)} particles, {volume / len(points) / d**3:.4f} cells each; volume {volume:.6g}")


if __name__ == "__main__":
    main()
