# SPDX-License-Identifier: MIT
"""Speed of Worlds beside one World at a time: 1,000 Worlds of 10 bodies.

    python3 benchmark.py [--worlds 1000] [--steps 60] [--helpers 0]

Each way applies a force to each body, steps, and reads all poses and velocities. Prints the CPU time
of one step of one World, or its real time if there are helpers. The ways take turns, and the
shortest time of three counts."""
import argparse
import time

import kodo

DT = 1 / 60


def scene(bodies):
    """Boxes that fall on the ground, side by side."""
    world = kodo.World(gravity=(0, -10))
    world.add(kodo.Plane(), type=kodo.BodyType.STATIC)
    moving = [world.add(kodo.Box(0.9, 0.9), position=(i, 1.0 + 0.1 * i)) for i in range(bodies)]
    return world, moving


def one_at_a_time(worlds, bodies, steps):
    for _ in range(steps):
        for world in worlds:
            for body in bodies:
                world[body].apply_force((0.1, 0.0))
            world.step(DT)
            for body in bodies:
                state = world[body]
                _ = state.transform, state.velocity


def one_by_one_with_arrays(worlds, bodies, steps):
    loads = [[0.1, 0.0, 0.0]] * len(bodies)
    for _ in range(steps):
        for world in worlds:
            world.apply_loads(bodies, loads)
            world.step(DT)
            world.poses(bodies)
            world.velocities(bodies)


def all_in_one_call(worlds, steps):
    loads = worlds.velocities()  # of the right shape and type
    for i in range(len(worlds)):
        for j in range(loads.shape[1]):
            loads[i, j, 0], loads[i, j, 1], loads[i, j, 2] = 0.1, 0.0, 0.0
    poses, velocities = worlds.poses(), worlds.velocities()
    for _ in range(steps):
        worlds.apply_loads(loads)
        worlds.step(DT)
        worlds.poses(out=poses)
        worlds.velocities(out=velocities)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--worlds", type=int, default=1000)
    parser.add_argument("--bodies", type=int, default=10)
    parser.add_argument("--steps", type=int, default=60)
    parser.add_argument("--helpers", type=int, default=0, help="threads of the pool")
    given = parser.parse_args()
    world, bodies = scene(given.bodies)
    pool = kodo.ThreadPool(given.helpers) if given.helpers else None
    clock = time.perf_counter if given.helpers else time.process_time
    times = {}
    for _ in range(3):
        for name in ("a body at a time", "arrays, a World at a time", "Worlds"):
            worlds = kodo.Worlds(world, given.worlds, bodies, pool)
            begin = clock()
            if name == "Worlds":
                all_in_one_call(worlds, given.steps)
            elif name == "a body at a time":
                one_at_a_time(worlds.worlds, bodies, given.steps)
            else:
                one_by_one_with_arrays(worlds.worlds, bodies, given.steps)
            spent = (clock() - begin) / given.steps / given.worlds
            times[name] = min(spent, times.get(name, spent))
    for name, spent in times.items():
        print(f"{name:26} {1e6 * spent:8.1f} us  {times['a body at a time'] / spent:6.1f} x")


if __name__ == "__main__":
    main()
