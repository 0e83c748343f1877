#!/usr/bin/env python3
"""Writes one random capture: FOLDER/mission.toml and FOLDER/satellite.obj.

    python3 scripts/random_capture.py FOLDER SEED NUMBER [SELF_SHARE [EVERY_STEP]]

A flat net of 500 to 5,000 nodes meets a satellite with panels 5 mm thick and rods 10 mm thick that
comes at 1 to 30 m/s, in any attitude, turning at up to 10 deg/s; two seconds, with the first touch
at about a tenth of them. The same seed and number give the same capture. Prints one line of what
was drawn: nodes, step, speed, friction, thread on thread, radius. SELF_SHARE is the probability of
thread on thread, 0.1 where it is not given; with a fifth argument the mission keeps a frame of every
accepted step, for `retiarius check-contact`.
"""

import math
import os
import random
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "missions"))
import make_satellite  # noqa: E402

# The bus, two panels 5 mm thick and three rods, as cells of a grid; metres.
X = [-1.000, -0.300, -0.005, 0.005, 0.300, 1.000]
Y = [-0.900, -0.350, -0.005, 0.005, 0.200, 0.205, 0.350]
Z = [-0.900, -0.425, -0.005, 0.005, 0.425, 0.900]
REACH = 1.4  # m, of a sphere about the satellite


def is_solid(cell):
    i, j, k = cell
    bus = i in (1, 2, 3) and j in (1, 2, 3, 4, 5) and k in (1, 2, 3)
    panel = i in (0, 4) and j == 4 and k in (1, 2, 3)
    rod_along_z = i == 2 and j == 2
    rod_along_y = i == 2 and k == 2 and j == 0
    return bus or panel or rod_along_z or rod_along_y


def draw_net(rng):
    """Pattern, meshes a side and segments a piece for about as many nodes as drawn."""
    wanted = math.exp(rng.uniform(math.log(500), math.log(5000)))
    pattern = rng.choice(["square", "hexagon"])
    segments = rng.choice([1, 2, 3, 4])

    def nodes(n):
        if pattern == "square":
            return (n + 1) ** 2 + 2 * n * (n + 1) * (segments - 1)
        return 3 * n * (n + 1) + 1 + 6 * n * (n + 1) * (segments - 1)

    fits = [n for n in range(2, 80) if 500 <= nodes(n) <= 5000]
    n = min(fits, key=lambda n: abs(nodes(n) - wanted))
    return pattern, n, segments, nodes(n)


def direction(rng):
    v = [rng.gauss(0, 1) for _ in range(3)]
    size = math.sqrt(sum(c * c for c in v))
    return [c / size for c in v]


def vector(direction, size):
    return "[" + ", ".join(f"{size * c:.9g}" for c in direction) + "]"


def main():
    folder, seed, number = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    self_share = float(sys.argv[4]) if len(sys.argv) > 4 else 0.1
    every_step = len(sys.argv) > 5
    rng = random.Random(seed * 1000003 + number)
    pattern, n, segments, nodes = draw_net(rng)
    side = rng.uniform(3.0, 5.0) if pattern == "square" else rng.uniform(2.0, 3.0)
    mesh = round(side / n, 5)
    radius = rng.choice([0.0005, 0.00075, 0.001])
    speed = math.exp(rng.uniform(0.0, math.log(30.0)))
    step = rng.choice([0.0025, 0.005, 0.01])
    friction = rng.choice([0.0, 0.1, 0.2, 0.4])
    own = rng.random() < self_share
    distance = REACH + 0.2 * speed
    aim = [rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)]
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "satellite.obj"), "w") as out:
        make_satellite.write(out, (X, Y, Z), is_solid)
    lines = [
        f'title = "Random capture {number} of seed {seed}"',
        "[net]",
        f'pattern = "{pattern}"',
        f"side = {n * mesh:.5f}",
        f"mesh = {mesh:.5f}",
        f"segments = {segments}",
        f"disturbance = {rng.choice([1e-4, 1e-3])}",
        "[net.thread]",
        f"young_modulus = {rng.choice([1e9, 10e9, 70e9]):.3g}",
        "density = 1390.0",
        f"radius = {radius}",
        *(['bending = "bounded"', "bending_stiffness = 1.0e-6"] if rng.random() < 0.5 else []),
        "compression = false",
        "material_damping = 1.0e-5",
        "[net.corner_mass]",
        f"mass = {rng.uniform(0.1, 0.5):.6g}",
        "[target]",
        'shape = "mesh"',
        'file = "satellite.obj"',
        f"mass = {math.exp(rng.uniform(math.log(10.0), math.log(1000.0))):.6g}",
        f"position = [{aim[0]:.6g}, {aim[1]:.6g}, {distance:.6g}]",
        f"velocity = [0.0, 0.0, {-speed:.9g}]",
        f"attitude_deg = {vector(direction(rng), rng.uniform(0.0, 180.0))}",
        f"spin_deg = {vector(direction(rng), rng.uniform(0.0, 10.0))}",
        "[integrator]",
        f"step = {step}",
        "max_iterations = 100",
        "tolerance = 1.0e-6",
        "[contact]",
        'method = "barrier"',
        f"friction = {friction}",
        f"thread_friction = {friction}",
        f"self = {'true' if own else 'false'}",
        "[[phase]]",
        'kind = "contact"',
        'until = "time >= 2.0"',
        "[output]",
        "interval = 0.01",
        "frame_interval = 0.01",
        *(["every_step = true"] if every_step else []),
    ]
    with open(os.path.join(folder, "mission.toml"), "w") as out:
        out.write("\n".join(lines) + "\n")
    print(nodes, step, f"{speed:.2f}", friction, "self" if own else "-", radius)


if __name__ == "__main__":
    main()
