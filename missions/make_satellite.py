#!/usr/bin/env python3
"""Writes satellite.obj, the tumbling satellite of the capture missions.

    python3 missions/make_satellite.py > missions/satellite.obj

The satellite is a union of the cells of an axis-aligned grid, so that its surface is one closed
manifold without T-junctions. Dimensions in metres; python3 and its standard library only.
"""

import sys
from itertools import product

HEADER = """\
# A tumbling satellite of the class of PROBA-2 (ESA, launched 2009). Metres. Written by
# make_satellite.py; edit that instead.
#
# Sources: bus 600 mm x 700 mm x 850 mm and mass 130 kg: D. Bernaerts and K. Gantois, "PROBA 2
# Satellite Status", Royal Observatory of Belgium, 5 November 2007. Two deployable solar panels,
# one on either side: ESA, "Entry 9: Proba-2 gains its second 'wing'", 10 September 2009, and
# S. Santandrea et al., "PROBA2: Mission and Spacecraft Overview", Solar Physics, 2013.
#
# Axes: x along the panels, y towards the sun, z along the bus's longest edge; the origin is the
# centre of the bus.
#   bus     x -0.30 to 0.30, y -0.35 to 0.35, z -0.425 to 0.425
#   panels  x 0.30 to 1.00 on either side, y 0.10 to 0.35, z -0.425 to 0.425; span 2.00 m
#
# Simplified: a plain box and two plain slabs; no instruments, antennas, hinges or launch ring. The
# panels' size is not published in these sources: each is taken as large as the bus's side of
# 0.70 m x 0.85 m, against which it is folded for launch. They are 0.25 m thick instead of some
# centimetres, on purpose: contact is found at the net's nodes, and a slab thinner than the spacing
# of the nodes could slip between them.
"""

X = [-1.00, -0.30, 0.30, 1.00]
Y = [-0.35, 0.10, 0.35]
Z = [-0.425, 0.425]
GRID = (X, Y, Z)


def is_solid(cell):
    """The middle column is the bus, the sunward outer cells are the panels."""
    i, j, _ = cell
    return i == 1 or j == 1


def faces(grid, is_solid):
    """Squares between a solid and an empty cell, counter-clockwise seen from outside."""
    cells = set(filter(is_solid, product(*(range(len(axis) - 1) for axis in grid))))
    for cell in sorted(cells):
        for axis, side in product(range(3), (0, 1)):
            beyond = list(cell)
            beyond[axis] += 1 if side else -1
            if tuple(beyond) in cells:
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            square = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cell)
                corner[axis] += side
                corner[u] += du
                corner[v] += dv
                square.append(tuple(corner))
            yield square if side else square[::-1]


def write(out, grid, is_solid):
    """The surface of the solid cells as OBJ: vertices, then two triangles a square."""
    squares = list(faces(grid, is_solid))
    corners = sorted({corner for square in squares for corner in square})
    number = {corner: index + 1 for index, corner in enumerate(corners)}
    for corner in corners:
        x, y, z = (axis[index] for axis, index in zip(grid, corner))
        out.write(f"v {x:.3f} {y:.3f} {z:.3f}\n")
    for a, b, c, d in ([number[corner] for corner in square] for square in squares):
        out.write(f"f {a} {b} {c}\nf {a} {c} {d}\n")


def main():
    sys.stdout.write(HEADER)
    write(sys.stdout, GRID, is_solid)


if __name__ == "__main__":
    main()
