# SPDX-License-Identifier: MIT
"""Hello: a ball falls on the ground and bounces."""
import kodo

world = kodo.World(gravity=(0, -10))  # m/s^2

# A contact takes the smaller restitution of the two materials.
rubber = kodo.with_friction(0.6, 0.8)
ground = world.add(kodo.Box(20, 1), position=(0, -0.5), material=rubber,
                   type=kodo.BodyType.STATIC)
ball = world.add(kodo.Circle(0.5), position=(0, 4), material=rubber)

for step in range(1, 181):
    world.step(1 / 60)
    for hit in world.begun_collisions():
        if hit.involves(ground.id):
            print(f"{step / 60:.2f} s: hits the ground at {hit.approach_speed:.1f} m/s")
    if step % 30 == 0:
        print(f"{step / 60:.2f} s: height {ball.position[1]:.2f} m")
