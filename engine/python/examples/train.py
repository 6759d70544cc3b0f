# SPDX-License-Identifier: MIT
"""Training: 60 carts learn to balance a pole, by random search over four numbers.

All Worlds step in one call; poses and velocities of all are read in one call each. With NumPy the
arrays are NumPy's, without it they are memoryviews of the same shape."""
import random

import kodo

WORLDS, STEPS, DT = 60, 180, 1 / 60


def cart_and_pole():
    """A cart on a rail with a pole of 2 m, which leans by 0.05 rad."""
    world = kodo.World(gravity=(0, -10))
    rail = world.add(kodo.Circle(0.1), type=kodo.BodyType.STATIC, flags=kodo.Flags.DISABLED)
    cart = world.add(kodo.Box(1, 0.5))
    pole = world.add(kodo.Box(0.1, 2), position=(-0.05, 1), angle=0.05, density=0.5)
    world.add_joint(kodo.PrismaticJoint(rail, cart, limits=(-5, 5)))
    world.add_joint(kodo.RevoluteJoint(cart, pole, anchor_b=(0, -1)))
    return world, [cart, pole]


def play(worlds, policies):
    """Steps in which each pole stays within 0.5 rad, by the policy of its World, and the places of
    the carts at the end (m)."""
    lasted = [0] * WORLDS
    standing = set(range(WORLDS))
    poses, speeds = worlds.poses(), worlds.velocities()
    loads = [[0.0, 0.0, 0.0] * 2 for _ in range(WORLDS)]
    for _ in range(STEPS):
        worlds.poses(out=poses)
        worlds.velocities(out=speeds)
        for i in list(standing):
            lean = poses[i, 1, 3]  # sine of the angle of the pole
            if abs(lean) > 0.5:
                standing.discard(i)
                continue
            lasted[i] += 1
            seen = (lean, speeds[i, 1, 2], poses[i, 0, 0], speeds[i, 0, 0])
            push = sum(weight * value for weight, value in zip(policies[i], seen))
            loads[i][0] = max(-10.0, min(10.0, float(push)))  # N, on the cart
        worlds.apply_loads(loads)
        worlds.step(DT)
    return lasted, [abs(float(poses[i, 0, 0])) for i in range(WORLDS)]


def main() -> None:
    world, bodies = cart_and_pole()
    worlds = kodo.Worlds(world, WORLDS, bodies)
    chance = random.Random(1)
    weights = [0.0] * 4
    for generation in range(1, 6):
        policies = [weights] + [
            [weight + chance.uniform(-20, 20) for weight in weights] for _ in range(WORLDS - 1)
        ]
        lasted, places = play(worlds, policies)
        for i in range(WORLDS):
            worlds.reset(i)
        # The longest counts, and of these the cart that is closest to the middle.
        best = max(range(WORLDS), key=lambda i: (lasted[i], -places[i]))
        weights = policies[best]
        standing = sum(steps == STEPS for steps in lasted)
        print(f"generation {generation}: {standing} of {WORLDS} poles stand for {STEPS * DT:.0f} s")


if __name__ == "__main__":
    main()
