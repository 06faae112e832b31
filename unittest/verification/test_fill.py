#!/usr/bin/env python3
"""doc/howto/fill.py: how many particles are inside of known bodies, and how much volume they share. Status 77: no
python3 with numpy, which fill.py needs."""

import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

FILL = pathlib.Path(__file__).resolve().parents[2] / "doc/howto/fill.py"
CORNERS = [(x, y, z) for x in (0, 2) for y in (0, 1) for z in (0, 1)]
# of a block of 2 x 1 x 1, outward, by number of corner
BLOCK = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7),
         (1, 7, 3)]


def text(triangles):
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners) +
                     "endloop\nendfacet\n" for corners in triangles)
    return f"solid body\n{facets}endsolid\n".encode()


def binary(triangles):
    return bytes(80) + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(c for corner in corners for c in corner), 0) for corners in triangles)


def has_numpy(python):
    try:
        return subprocess.run([python, "-c", "import numpy"], stderr=subprocess.DEVNULL).returncode == 0
    except OSError:
        return False


# the first one of the PATH may be another one than Debian's, without numpy (tools/packages.sh)
PYTHON = next(filter(has_numpy, (os.environ.get("PYTHON", sys.executable), sys.executable, "/usr/bin/python3")), None)


def filled(raw, spacing, *scale):
    with tempfile.TemporaryDirectory() as folder:
        surface, data = pathlib.Path(folder, "body.stl"), pathlib.Path(folder, "body.data")
        surface.write_bytes(raw)
        subprocess.run([PYTHON, FILL, surface, str(spacing), data, *scale], check=True, stdout=subprocess.DEVNULL)
        lines = data.read_text().split("Atoms # sph/solid\n\n")
        atoms = [[float(word) for word in line.split()] for line in lines[1].splitlines()]
        assert int(re.search(r"(\d+) atoms", lines[0])[1]) == len(atoms)
        return atoms


def main():
    if not PYTHON:
        sys.exit(77)
    block = [[CORNERS[k] for k in triangle] for triangle in BLOCK]
    for form in (text, binary):
        for scale in ((), ("1e-3",)):
            unit = float(scale[0]) if scale else 1.0
            atoms = filled(form(block), 0.1 * unit, *scale)
            assert len(atoms) == 20 * 10 * 10, len(atoms)
            assert all(abs(atom[2] / (1e-3 * unit**3) - 1) < 1e-6 for atom in atoms)    # whole cells
            for k, length in ((6, 2), (7, 1), (8, 1)):    # cells touch the faces
                places = {round(atom[k] / unit, 6) for atom in atoms}
                assert min(places) == 0.05 and max(places) == length - 0.05, (min(places), max(places))
    corner = [[(0, 0, 0), (0, 1, 0), (1, 0, 0)], [(0, 0, 0), (1, 0, 0), (0, 0, 1)], [(0, 0, 0), (0, 0, 1), (0, 1, 0)],
              [(1, 0, 0), (0, 1, 0), (0, 0, 1)]]    # a sixth of a cube
    atoms = filled(text(corner), 0.05)
    assert abs(sum(atom[2] for atom in atoms) * 6 - 1) < 1e-6
    assert all(atom[6] + atom[7] + atom[8] < 1 for atom in atoms)
    print("fill.py fills what is closed.")


if __name__ == "__main__":
    main()
