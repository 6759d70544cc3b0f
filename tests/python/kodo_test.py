# SPDX-License-Identifier: MIT
"""The Python module. Each test runs with NumPy's arrays and without, where NumPy is installed."""
import array
import dataclasses
import gc
import math
import pathlib
import re
import unittest
import xml.etree.ElementTree

import kodo
from kodo import _structs, buffers, fields

DT = 1 / 60
ABI = pathlib.Path(__file__).resolve().parents[2] / "engine/c/abi.txt"


def falling_boxes():
    """A World with ground and three boxes above it, and the boxes."""
    world = kodo.World(gravity=(0, -10))
    world.add(kodo.Plane(), type=kodo.BodyType.STATIC)
    return world, [world.add(kodo.Box(1, 1), position=(2 * i, 1 + i)) for i in range(3)]


class Structs(unittest.TestCase):
    def test_sizes_and_offsets_are_those_of_the_abi(self):
        column = 2 if kodo.REAL_SIZE == 4 else 3
        struct, compared = None, 0
        for line in ABI.read_text(encoding="utf-8").splitlines():
            words = line.split()
            if words[0] == "struct":
                struct = getattr(_structs, words[1].replace("kodo_", ""))
                self.assertEqual(int(words[column]), _structs.ctypes.sizeof(struct), line)
            elif line.startswith(" "):
                self.assertEqual(int(words[column - 1]), getattr(struct, words[0]).offset, line)
                compared += 1
            elif words[0] == "version":
                self.assertEqual(int(words[1]), _structs.VERSION)
        self.assertGreater(compared, 200)

    def test_enumerators_are_those_of_the_abi(self):
        numbers = dict(re.findall(r"enumerator KODO_(\w+) (\d+)", ABI.read_text(encoding="utf-8")))
        for enum in (kodo.BodyType, kodo.Flags, kodo.Phase, kodo.Feature):
            for member in enum:
                self.assertEqual(int(numbers[member.name]), member.value, member)
        for member in kodo.StartOverlap:
            self.assertEqual(int(numbers["START_" + member.name]), member.value, member)
        for member in kodo.ContinuousMode:
            self.assertEqual(int(numbers["CONTINUOUS_" + member.name]), member.value, member)


class Pictures(unittest.TestCase):
    def test_each_body_is_an_element_of_a_well_formed_svg(self):
        world, _ = falling_boxes()
        world.add(kodo.Circle(0.5), position=(0, 8))
        root = xml.etree.ElementTree.fromstring(world.svg(view=((-5, -1), (5, 9))))
        name = "{http://www.w3.org/2000/svg}"
        self.assertEqual(name + "svg", root.tag)
        self.assertEqual("0 0 6400 6400", root.get("viewBox"))
        self.assertEqual(1 + 3, len(root.findall(f".//{name}polygon")))  # ground and boxes
        self.assertEqual(1, len(root.findall(f".//{name}circle")))
        labelled = xml.etree.ElementTree.fromstring(world.svg(labels=True))
        self.assertEqual(5, len(labelled.findall(f".//{name}text")))
        self.assertEqual(world.svg(), world._repr_svg_())
        for _ in range(60):
            world.step(DT)
        arrows = [world.svg(impulses=True, metres_per_impulse=length) for length in (1, 2)]
        self.assertNotEqual(*arrows)

    def test_a_stiffness_becomes_hertz_and_a_damping_ratio(self):
        world = kodo.World()
        wall = world.add(type=kodo.BodyType.STATIC)
        weight = world.add(kodo.Box(1, 1), position=(3, 0), mass=4)
        hertz, damping = world.spring_of(kodo.DistanceJoint(wall.id, weight.id), 100, 20)
        self.assertAlmostEqual(5 / (2 * math.pi), hertz, places=5)  # sqrt(100 / 4) rad/s
        self.assertAlmostEqual(0.5, damping, places=5)

    def test_a_joint_instead_of_a_shape_names_add_joint(self):
        world, (box, other, _) = falling_boxes()
        with self.assertRaisesRegex(TypeError, "add_joint"):
            world.add(kodo.FilterJoint(box.id, other.id))

    def test_an_empty_view_is_refused(self):
        with self.assertRaises(kodo.BadDefinition):
            kodo.World().svg(view=((0, 0), (0, 0)))


class Bodies(unittest.TestCase):
    def test_a_ball_falls_as_the_closed_form_says(self):
        world = kodo.World(gravity=(0, -10))
        ball = world.add(kodo.Circle(0.5), position=(0, 10), velocity=(1, 0))
        for _ in range(60):
            world.step(DT)
        self.assertAlmostEqual(1, ball.position[0], places=4)
        self.assertAlmostEqual(5, ball.position[1], places=1)
        self.assertAlmostEqual(-10, ball.velocity[1], places=4)

    def test_each_property_is_read_as_it_was_set(self):
        world, (box, other, _) = falling_boxes()
        box.position, box.angle = (3, 4), 0.5
        box.velocity, box.angular_velocity = (1, 2), 3
        box.flags, box.required, box.user_data = 2**63 | kodo.Flags.MATCH_ANY, 2**40, 2**63
        box.group = -3
        self.assertEqual((3, 4), box.position)
        self.assertAlmostEqual(0.5, box.angle, places=6)
        self.assertEqual(((1, 2), 3), (box.velocity, box.angular_velocity))
        self.assertEqual((2**63 | kodo.Flags.MATCH_ANY, 2**40, 2**63, -3),
                         (box.flags, box.required, box.user_data, box.group))
        box.set_mass(kodo.MassDef(2, center=(0.1, 0), inertia=0.3))
        self.assertAlmostEqual(0.3, box.inertia, places=6)
        self.assertTrue(box.has_set_mass)
        box.set_mass_from_density()
        self.assertEqual((1, 1), (box.mass, box.area))
        box.type = kodo.BodyType.KINEMATIC
        self.assertEqual(kodo.BodyType.KINEMATIC, box.type)
        other.copy_from(box)
        self.assertEqual(kodo.BodyType.KINEMATIC, other.type)
        self.assertTrue(box.contains((3, 4)))
        self.assertAlmostEqual(1 + 3, box.velocity_at((3, 3))[0], places=5)
        self.assertEqual(box, world[box.id])
        self.assertEqual(1, len({box, world[box]}))

    def test_each_shape_is_read_as_it_was_given(self):
        corners = ((0.0, 0.0), (2.0, 0.0), (0.0, 3.0))
        shapes = [
            kodo.Circle(2, (1, 3)),
            kodo.Box(2, 3, (4, 5), 0.0, 0.5),
            kodo.Polygon(corners, 0.5),
            kodo.Point((1, 2)),
            kodo.Segment((0, 1), (2, 3), one_sided=True),
            kodo.Plane((1, 0), 3),
            kodo.Capsule((0, 1), (2, 3), 0.5),
        ]
        world = kodo.World()
        for shape in shapes:
            body = world.add(shape, type=kodo.BodyType.STATIC)
            self.assertEqual([shape], [part.shape for part in body.parts])
            if shape == kodo.Box(2, 3, (4, 5), 0.0, 0.5):
                own = dataclasses.replace(body.parts[0], filter=kodo.Filter(kodo.Flags.SENSOR),
                                          user_data=2**40)
                body.set_part(0, own)
                self.assertEqual(own, body.parts[0])
        compound = world.add(kodo.Compound(shapes), type=kodo.BodyType.STATIC)
        self.assertEqual(shapes, [part.shape for part in compound.parts])
        ground = world.add(kodo.Heightmap(1, [0, 1, 0]), type=kodo.BodyType.STATIC)
        self.assertEqual(2, len(ground.parts))
        chain = world.add(
            kodo.Chain(corners, closed=True, materials=[kodo.with_friction(i) for i in range(3)]),
            type=kodo.BodyType.STATIC,
        )
        self.assertEqual([0, 1, 2], [part.material.static_friction for part in chain.parts])

    def test_a_belt_conveys_and_a_bumper_throws(self):
        world = kodo.World(gravity=(0, -10))
        belt = kodo.Material(0.5, 0.5, surface_speed=2, friction_rule=kodo.MixRule.MAXIMUM)
        floor = world.add(kodo.Box(100, 1), (0, -0.5), material=belt, type=kodo.BodyType.STATIC)
        self.assertEqual(belt, floor.parts[0].material)
        ice = kodo.with_friction(0)
        crate = world.add(kodo.Box(1, 0.5), (0, 0.25), material=ice)
        bumper = kodo.Material(restitution=1.5, restitution_rule=kodo.MixRule.MAXIMUM)
        world.add(kodo.Box(1, 1), (20.5, 0.5), material=bumper, type=kodo.BodyType.STATIC)
        ball = world.add(kodo.Circle(0.5), (18, 5), velocity=(8, 4), material=ice)
        for _ in range(60):
            world.step(1 / 60)
        self.assertAlmostEqual(2, crate.velocity[0], places=3)
        self.assertGreater(ball.position[1], 0)

    def test_only_a_body_whose_continuous_mode_says_so_tunnels(self):
        mode = kodo.ContinuousMode
        for own, thick in ((mode.NEVER, False), (mode.STATIC, True), (mode.ALL, True)):
            world = kodo.World()
            world.add(kodo.Box(0.02, 9), (5, 0), type=kodo.BodyType.STATIC)
            ball = world.add(kodo.Circle(0.1), velocity=(400, 0), continuous_mode=own)
            self.assertEqual(own, ball.continuous_mode)
            world.step(1 / 60)
            self.assertEqual(thick, ball.position[0] < 5)
            self.assertEqual(int(thick), world.stats.continuous_stops)
            ball.continuous_mode = mode.ALL
            self.assertIs(mode.ALL, ball.continuous_mode)

    def test_a_world_without_collision_has_no_contacts(self):
        settings = kodo.balanced()
        settings.leave_out = kodo.Feature.COLLISION
        world = kodo.World(gravity=(0, -10), settings=settings)
        world.add(kodo.Box(9, 1), type=kodo.BodyType.STATIC)
        ball = world.add(kodo.Circle(0.5), (0, 1))
        for _ in range(60):
            world.step(1 / 60)
        self.assertLess(ball.position[1], -3)
        self.assertEqual(0, world.stats.pair_work)

    def test_damping_gravity_scale_and_sleep_by_call(self):
        world = kodo.World(gravity=(0, -10))
        slow = world.add(velocity=(1, 0), angular_velocity=1, linear_damping=2, angular_damping=3,
                         gravity_scale=0)
        self.assertEqual((2, 3, 0), (slow.linear_damping, slow.angular_damping, slow.gravity_scale))
        for _ in range(60):
            world.step(1 / 60)
        self.assertAlmostEqual(math.exp(-2), slow.velocity[0], places=5)
        self.assertAlmostEqual(math.exp(-3), slow.angular_velocity, places=5)
        self.assertEqual([slow], world.moved_bodies)
        local = slow.transform.to_local(slow.transform * (1, 2))
        self.assertAlmostEqual(2, local[1], places=5)
        slow.linear_damping, slow.angular_damping, slow.gravity_scale = 0, 0, -1
        slow.apply_angular_impulse(slow.inertia)
        self.assertAlmostEqual(1 + math.exp(-3), slow.angular_velocity, places=5)
        self.assertTrue(slow.sleep())
        self.assertTrue(slow.is_asleep)
        self.assertEqual((0, 0), slow.velocity)

    def test_outlines_become_polygons(self):
        corner = ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))
        self.assertEqual(5, len(kodo.convex_hull(corner).corners))
        world = kodo.World()
        self.assertAlmostEqual(3, world.add(kodo.decompose(corner)).area, places=5)
        with self.assertRaises(kodo.BadDefinition):
            kodo.decompose(((0, 0), (1, 1), (1, 0), (0, 1)))

    def test_weld_and_unweld_keep_the_mass(self):
        world, (box, other, _) = falling_boxes()
        self.assertEqual(1, box.weld(other))
        self.assertNotIn(other, world)
        self.assertEqual(2, box.weld(kodo.Circle(0.5, (0, 1)), density=2))
        self.assertAlmostEqual(2 + math.pi / 2, box.mass, places=5)
        part = box.unweld(1, flags=kodo.Flags.NEVER_SLEEP)
        self.assertEqual((1, kodo.Flags.NEVER_SLEEP), (part.mass, part.flags))

    def test_a_body_that_is_removed_is_unknown(self):
        world, (box, *_) = falling_boxes()
        clone = box.clone((9, 9))
        box.remove()
        self.assertNotIn(box, world)
        self.assertIn(clone, world)
        self.assertEqual(4, len(world))
        with self.assertRaisesRegex(kodo.BadBodyId, "is not in this World"):
            box.velocity = (1, 0)


class Errors(unittest.TestCase):
    def test_each_status_has_its_exception_and_the_sentence_of_the_engine(self):
        world, (box, *_) = falling_boxes()
        with self.assertRaisesRegex(kodo.BadDefinition, "^shape.radius: must be greater than 0"):
            world.add(kodo.Circle(-1))
        with self.assertRaises(kodo.BadSnapshot):
            kodo.World.from_bytes(b"nothing")
        with self.assertRaisesRegex(kodo.BadDefinition, "dt"):
            world.step(2)
        with self.assertRaises(kodo.BadDefinition):
            kodo.ThreadPool(-1)
        self.assertTrue(issubclass(kodo.BadDefinition, ValueError))
        self.assertEqual(4, len(world))
        with self.assertRaises(TypeError):
            world.add("a ball")
        with self.assertRaises(TypeError):
            world.add_joint(box)

    def test_sentences_name_things_as_this_module_does(self):
        world, (box, other, *_) = falling_boxes()
        far = kodo.RevoluteJoint(a=box.id, b=other.id, anchor_a=(1e30, 0))
        with self.assertRaisesRegex(kodo.BadDefinition, "^ends.anchor_a: x must be"):
            world.add_joint(far)
        with self.assertRaisesRegex(kodo.BadDefinition, "motor_torque: must be"):
            world.add_joint(kodo.RevoluteJoint(a=box.id, b=other.id, motor_torque=-1))
        with self.assertRaisesRegex(kodo.BadDefinition, "at most MAX_COORDINATE"):
            world.explode((0, 0), radius=1e30)
        with self.assertRaisesRegex(kodo.BadDefinition, "of length 2: divide it by its length"):
            world.add_joint(kodo.PrismaticJoint(a=box.id, b=other.id, axis=(2, 0)))

    def test_what_would_be_cut_off_or_ignored_is_refused(self):
        world, (box, *_) = falling_boxes()
        for group in (1 << 31, -(1 << 31) - 1):
            with self.assertRaisesRegex(ValueError, "group: must be from"):
                world.add(group=group)
            with self.assertRaisesRegex(ValueError, "group: must be from"):
                box.group = group
        with self.assertRaisesRegex(ValueError, "user_data"):
            world.add(user_data=1 << 64)
        with self.assertRaisesRegex(ValueError, "user_data"):
            box.user_data = -1
        with self.assertRaisesRegex(ValueError, "user_data"):
            world.add_joint(kodo.MotorJoint(a=box.id, b=world.bodies[1].id, user_data=1 << 64))
        with self.assertRaisesRegex(ValueError, "user_data"):
            box.set_part(0, kodo.Part(kodo.Circle(1), user_data=-1))
        with self.assertRaises(AttributeError):
            world.gravty = (0, -10)
        with self.assertRaisesRegex(TypeError, "named by a Body or a BodyId, but is 7"):
            world[7].velocity = (1, 0)
        with self.assertRaisesRegex(TypeError, "named by its JointId"):
            world.remove_joint(box)
        self.assertEqual(4, len(world))

    def test_values_of_a_wrong_kind_are_told_with_the_value(self):
        world, (box, *_) = falling_boxes()
        with self.assertRaisesRegex(TypeError, r"two numbers, \(x, y\), but is 3$"):
            world.add(position=3)
        with self.assertRaisesRegex(TypeError, r"two numbers, \(x, y\), but is \(1, 2, 3\)$"):
            box.apply_impulse((1, 2, 3))
        with self.assertRaisesRegex(TypeError, r"material.*but is 0\.5$"):
            world.add(material=0.5)
        for change in (lambda: world.add(flags=1 << 64), lambda: setattr(box, "flags", -1)):
            with self.assertRaisesRegex(ValueError, "^flags: must have bits 0 to 63"):
                change()
        with self.assertRaisesRegex(ValueError, "required"):
            box.required = 1 << 64

    def test_worlds_refuse_a_count_of_zero_unknown_bodies_and_text(self):
        world, boxes = falling_boxes()
        with self.assertRaisesRegex(ValueError, "count: must be at least 1, but is 0"):
            kodo.Worlds(world, 0, boxes)
        with self.assertRaises((TypeError, ValueError)):
            kodo.Worlds(world, 2, boxes).apply_loads("x")
        boxes[0].remove()
        with self.assertRaisesRegex(kodo.BadBodyId, "not in this World"):
            kodo.Worlds(world, 2, boxes)

    def test_a_number_of_a_wrong_kind_is_told_with_its_name(self):
        world = kodo.World()
        ball = world.add(kodo.Circle(0.5))
        hinge = kodo.RevoluteJoint(ball, ball, motor_speed="fast")
        for name, call in {
            "density": lambda: world.add(kodo.Circle(0.5), density="1"),
            "radius": lambda: world.add(kodo.Circle("1")),
            "angle": lambda: world.add(kodo.Circle(1), angle=None),
            "user_data": lambda: world.add(kodo.Circle(1), user_data="a"),
            "flags": lambda: world.add(kodo.Circle(1), flags=0.5),
            "type": lambda: world.add(kodo.Circle(1), type="static"),
            "continuous_mode": lambda: setattr(ball, "continuous_mode", 3),
            "motor_speed": lambda: world.add_joint(hinge),
            "gravity_scale": lambda: setattr(ball, "gravity_scale", "1"),
            "dt": lambda: world.step("1/60"),
            "max_distance": lambda: world.closest_point((0, 0), "far"),
        }.items():
            with self.subTest(name), self.assertRaisesRegex(TypeError, f"^{name}: must be "):
                call()
        self.assertEqual(len(world), 1)

    def test_a_world_twice_in_a_list_is_wrong_use(self):
        world, boxes = falling_boxes()
        worlds = kodo.Worlds(world, 2, boxes)
        worlds._handles[1] = worlds._handles[0]
        with self.assertRaisesRegex(kodo.WrongUse, "twice in the list"):
            worlds.step(DT)


class State(unittest.TestCase):
    def test_a_copy_and_a_snapshot_continue_alike(self):
        world, boxes = falling_boxes()
        copy, again = world.copy(), kodo.World.from_bytes(world.to_bytes())
        for each in (world, copy, again):
            for _ in range(60):
                each.step(DT)
        self.assertEqual(world.state_hash(), copy.state_hash())
        self.assertEqual(world.state_hash(), again.state_hash())
        self.assertEqual(world.to_bytes(), copy.to_bytes())
        self.assertEqual(boxes[1].position, copy[boxes[1]].position)
        world.step(DT)
        world.assign(copy)
        self.assertEqual(60, world.step_count)

    def test_settings_and_profiles_are_read_as_they_were_set(self):
        world, _ = falling_boxes()
        for profile in (kodo.fast, kodo.balanced, kodo.accurate, kodo.thesis2006):
            settings = profile()
            settings.sleep_steps = 7
            settings.leave_out = kodo.Feature.FRICTION | kodo.Feature.SLEEP
            world.settings = settings
            self.assertEqual(settings, world.settings)
        self.assertIsInstance(world.settings.solver, kodo.PropagationSettings)

    def test_the_region_leaves_bodies_out(self):
        world, boxes = falling_boxes()
        world.region = ((-1, -1), (1, 5))
        world.step(DT)
        self.assertEqual(((-1, -1), (1, 5)), world.region)
        self.assertTrue(boxes[2].flags & kodo.Flags.OUTSIDE)
        self.assertEqual(1, world.stats.bodies)
        world.region = None
        self.assertIsNone(world.region)


class Joints(unittest.TestCase):
    def test_each_joint_is_read_as_it_was_given(self):
        world, (box, other, _) = falling_boxes()
        ends = {"a": box.id, "b": other.id, "anchor_a": (0.5, 0.0), "break_force": 1000.0}
        joints = [
            kodo.RevoluteJoint(**ends, limits=(-1.0, 2.0), motor_speed=3.0, motor_torque=4.0,
                               target=5.0, hertz=6.0, damping=7.0),
            kodo.FixedJoint(**ends, reference=0.5, hertz=2.0, damping=3.0),
            kodo.DistanceJoint(**ends, length=2.0, hertz=3.0, damping=0.5, limits=(0.0, 4.0),
                               motor_speed=5.0, motor_force=6.0),
            kodo.PrismaticJoint(**ends, axis=(0.0, 1.0), motor_speed=2.0, motor_force=3.0,
                                target=4.0, hertz=5.0, damping=6.0),
            kodo.MotorJoint(**ends, force=2.0, torque=3.0, hertz=0.0),
            kodo.MouseJoint(box.id, target=(1.0, 2.0), damping=0.5, user_data=9),
            kodo.WheelJoint(**ends, axis=(1.0, 0.0), limits=(-1.0, 2.0), hertz=3.0, damping=4.0,
                            motor_speed=5.0, motor_torque=6.0),
            kodo.PulleyJoint(**ends, ground_a=(1.0, 9.0), ground_b=(2.0, 8.0), length=12.0,
                             ratio=2.0),
            kodo.GearJoint(**ends, ratio=-3.0),
            kodo.GearJoint(**ends, ratio=0.5, rack=(0.0, 1.0)),
            kodo.FilterJoint(box.id, other.id, user_data=2**63),
        ]
        for joint in joints:
            added = world.add_joint(joint)
            self.assertEqual(joint, world.joint(added))
            world.set_joint(added, joint)
            world.remove_joint(added)
            self.assertFalse(world.contains_joint(added))
        self.assertEqual([], world.joints)

    def test_a_joint_tells_its_state_and_changes_one_number(self):
        world = kodo.World()
        post = world.add(kodo.Circle(0.1), type=kodo.BodyType.STATIC)
        drum = world.add(kodo.Circle(0.5))
        hinge = world.add_joint(kodo.RevoluteJoint(post, drum, limits=(-100.0, 100.0),
                                                   motor_speed=8.0, motor_torque=100.0))
        for _ in range(60):
            world.step(DT)
        state = world.joint_state(hinge)
        self.assertAlmostEqual(8, state.angle, delta=0.05)  # less a part of the first step
        self.assertAlmostEqual(8, state.angular_speed, places=3)
        self.assertAlmostEqual(0, state.length, places=4)
        world.change_joint(hinge, motor_speed=-2.0)
        world.step(DT)
        self.assertAlmostEqual(-2, world.joint_state(hinge).angular_speed, places=3)
        self.assertEqual(100.0, world.joint(hinge).motor_torque)
        self.assertEqual([hinge], world.joints_of(drum))

    def test_a_joint_carries_and_breaks(self):
        world = kodo.World(gravity=(0, -10))
        hook = world.add(kodo.Circle(0.1), type=kodo.BodyType.STATIC)
        box = world.add(kodo.Box(1, 1), position=(0, -0.5))
        joint = world.add_joint(kodo.RevoluteJoint(hook, box, anchor_b=(0, 0.5)))
        for _ in range(60):
            world.step(DT)
        (_, force), _ = world.joint_load(joint)
        self.assertAlmostEqual(10, force, places=2)
        numbers = world.joint(joint)
        numbers.break_force = 1.0
        world.set_joint(joint, numbers)
        box.wake()
        world.step(DT)
        (broken,) = world.broken_joints()
        self.assertEqual((joint, box.id), (broken.id, broken.b))


class Fields(unittest.TestCase):
    def test_fields_are_read_as_they_were_given(self):
        world = kodo.World()
        given = [
            (kodo.Gravity((1, -9)), kodo.Filter()),
            (kodo.Drag(1, 2, (3, 4)), kodo.Filter()),
            (kodo.Wind(1, 2, (3, 4), ((-5, -6), (7, 8))), kodo.Filter()),
            (kodo.Attractor((1, 2), 3, 4, linear=True), kodo.Filter()),
            (kodo.Buoyancy(1, 2, (3, 4), (0, -10)), kodo.Filter(kodo.Flags.MATCH_ANY, 6)),
            (kodo.OwnField(lambda body, dt: kodo.FieldForce()), kodo.Filter()),
        ]
        world.set_fields(given)
        self.assertEqual(given, world.fields)

    def test_a_field_of_the_user_pulls_and_ends_with_its_world(self):
        pull = kodo.OwnField(lambda body, dt: kodo.FieldForce((2 * body.mass, 0.0)))
        world = kodo.World()
        ball = world.add(kodo.Circle(0.5))
        world.add_field(pull)
        for _ in range(60):
            world.step(DT)
        self.assertAlmostEqual(2, ball.velocity[0], places=4)
        again = kodo.World.from_bytes(world.to_bytes(), [pull])
        again.step(DT)
        world.step(DT)
        self.assertEqual(world.state_hash(), again.state_hash())
        with self.assertRaises(kodo.BadDefinition):
            world.add_field(pull, kodo.Filter(required=1))
        self.assertEqual(2, len(fields._fields))
        del world, again, ball
        gc.collect()
        self.assertEqual(0, len(fields._fields))

    def test_an_exception_of_a_field_reaches_the_caller_of_the_step(self):
        def fails(body, dt):
            raise ZeroDivisionError("out of order")

        world = kodo.World(gravity=(0, -10))
        ball = world.add()
        world.add_field(kodo.OwnField(fails))
        with self.assertRaisesRegex(ZeroDivisionError, "out of order"):
            world.step(DT)
        self.assertLess(ball.velocity[1], 0)
        world.set_fields([])
        world.step(DT)


class Collisions(unittest.TestCase):
    def test_a_contact_begins_once_and_ends_once(self):
        world, (box, *_) = falling_boxes()
        begun = ended = 0
        for _ in range(60):
            world.step(DT)
            begun += sum(hit.involves(box.id) for hit in world.begun_collisions())
        box.position = (0, 20)
        world.step(DT)
        ended += sum(hit.involves(box.id) for hit in world.ended_collisions())
        self.assertEqual((1, 1), (begun, ended))
        for _ in range(400):
            world.step(DT)
            if hits := world.hits(5):
                break
        self.assertEqual(box.id, hits[0].other(world.bodies[0].id))
        self.assertGreater(hits[0].approach_speed, 15)
        self.assertEqual(kodo.Phase.BEGIN, world.collisions(box)[0].phase)

    def test_a_list_beyond_the_first_room_is_complete(self):
        world = kodo.World()
        for i in range(50):
            world.add(position=(3 * i, 0))
        self.assertEqual(50, len(list(world)))
        self.assertEqual(50, len(world.ray_cast_all((-5, 0), (200, 0))))


class Queries(unittest.TestCase):
    def test_queries_find_what_is_there(self):
        world = kodo.World()
        first, second = (world.add(position=(3 * i, 0), flags=1 + i) for i in range(2))
        self.assertEqual(first.id, world.ray_cast((-5, 0), (9, 0)).body)
        self.assertEqual(second.id, world.ray_cast((-5, 0), (9, 0), ignore=[first]).body)
        self.assertIsNone(world.ray_cast((-5, 3), (9, 3)))
        red = kodo.Filter(kodo.Flags.MATCH_ANY, 2)
        self.assertEqual([second.id], world.overlap_box(((-9, -9), (9, 9)), red))
        self.assertEqual([first.id], world.overlap(kodo.Box(1, 1), angle=0.5))
        hit = world.shape_cast(kodo.Circle(0.5), (-5, 0), (10, 0))
        self.assertAlmostEqual(0.4, hit.fraction, places=2)
        closest = world.closest_point((3, 2))
        self.assertEqual(second.id, closest.body)
        self.assertAlmostEqual(1.5, closest.distance, places=5)
        self.assertIsNone(world.closest_point((3, 2), 1))


    def test_a_ray_leaves_a_disc_at_the_second_root(self):
        world = kodo.World()
        disc = world.add(kodo.Circle(2), position=(5, 0))
        (span,) = world.ray_spans((0, 1), (10, 1))
        self.assertEqual(disc.id, span.entry.body)
        self.assertAlmostEqual((5 + math.sqrt(3)) / 10, span.exit_fraction, places=5)
        self.assertAlmostEqual(0.5, span.exit_normal[1], places=5)

    def test_a_cast_turns_and_leaves_out_what_it_starts_in(self):
        world = kodo.World()
        target = world.add(kodo.Box(1, 1), position=(0, 3))
        bar = kodo.Box(4, 0.2, center=(2, 0))
        self.assertIsNone(world.shape_cast(bar, (0, 0), (0, 0)))
        hit = world.shape_cast(bar, (0, 0), (0, 0), turn=math.pi)
        self.assertEqual(target.id, hit.body)
        # The upper side of the bar meets the corner (0.5, 2.5) when 2.5 cos a - 0.5 sin a = 0.1.
        angle = math.pi * hit.fraction
        self.assertAlmostEqual(0.1, 0.5 * math.sin(-angle) + 2.5 * math.cos(angle), delta=0.01)
        ball = kodo.Circle(0.5)
        self.assertEqual(0, world.shape_cast(ball, (0, 2.2), (0, 1)).fraction)
        hit = world.shape_cast(ball, (0, 2.2), (0, 1), at_start=kodo.StartOverlap.NORMAL)
        self.assertAlmostEqual(-1, hit.normal[1], places=5)
        ignore = kodo.StartOverlap.IGNORE
        self.assertIsNone(world.shape_cast(ball, (0, 2.2), (0, 1), at_start=ignore))

    def test_contacts_and_distances_are_those_of_the_shapes(self):
        world = kodo.World()
        first, second = (world.add(kodo.Circle(0.5), position=(3 * i, 0)) for i in range(2))
        (contact,) = world.collide(kodo.Circle(0.5), (1.2, 0), margin=0.3)
        self.assertEqual(first.id, contact.body)
        self.assertAlmostEqual(0.2, contact.separation, places=5)
        self.assertAlmostEqual(0.6, contact.point[0], places=5)
        self.assertEqual([], world.collide(kodo.Circle(0.5), (1.2, 0), margin=0.1))
        closest = world.closest_point_of(second, (0, 0))
        self.assertAlmostEqual(2.5, closest.distance, places=5)
        points = world.distance(first, second)
        self.assertAlmostEqual(2, points.distance, places=5)
        self.assertAlmostEqual(2.5, points.on_b[0], places=5)
        self.assertAlmostEqual(1, points.normal[0], places=5)

    def test_touching_lists_sleeping_bodies_too(self):
        world, (box, other, _) = falling_boxes()
        for _ in range(300):
            world.step(DT)
        self.assertTrue(box.is_asleep)
        self.assertEqual([world.bodies[0].id], world.touching(box))
        self.assertEqual(3, len(world.touching(world.bodies[0])))
        other.remove()
        self.assertEqual(2, len(world.touching(world.bodies[0])))

    def test_queries_may_leave_out_sensors(self):
        world = kodo.World()
        world.add(position=(0, 0), flags=kodo.Flags.SENSOR)
        solid = world.add(position=(3, 0))
        which = kodo.Filter(kodo.Flags.NO_SENSORS)
        self.assertEqual(solid.id, world.ray_cast((-5, 0), (9, 0), which).body)


class Helpers(unittest.TestCase):
    def test_a_mover_walks_up_a_slope(self):
        world = kodo.World()
        ground = world.add(kodo.Chain(((-20, 0), (0, 0), (20, 6)), one_sided=True),
                           type=kodo.BodyType.STATIC)
        mover = kodo.Mover(position=(-3, 1))
        for _ in range(240):
            world.step(DT)
            mover.move(world, (3, mover.velocity[1] - 20 * DT), DT)
        self.assertTrue(mover.grounded)
        self.assertEqual(ground.id, mover.ground_body)
        self.assertAlmostEqual(-6 / math.hypot(20, 6), mover.ground_normal[0], places=5)
        self.assertAlmostEqual(3, mover.velocity[0], places=5)
        self.assertGreater(mover.position[1], 1.5)
        copy = dataclasses.replace(mover)
        copy.move(world, (3, 0), DT)
        self.assertLess(mover.position[0], copy.position[0])

    def test_a_bad_mover_is_refused(self):
        mover = kodo.Mover(shape=kodo.Plane())
        with self.assertRaisesRegex(kodo.BadDefinition, "plane"):
            mover.move(kodo.World(), (0, 0), DT)

    def test_an_explosion_spares_what_is_behind_a_wall(self):
        world = kodo.World()
        world.add(kodo.Box(0.2, 4), position=(1, 0), type=kodo.BodyType.STATIC)
        behind = world.add(kodo.Box(1, 1), position=(3, 0))
        near = world.add(kodo.Box(1, 1), position=(-3, 0))
        hits = world.explode((0, 0), radius=5, impulse=2)
        self.assertEqual([near.id], [hit.body for hit in hits])
        self.assertAlmostEqual(near.mass * near.velocity[0], hits[0].impulse[0], places=4)
        self.assertLess(near.velocity[0], -1)
        self.assertEqual((0, 0), behind.velocity)
        self.assertEqual([], kodo.World().explode((0, 0)))

    def test_an_axis_is_locked_by_a_groove(self):
        world = kodo.World()
        body = world.add(velocity=(2, 5))
        groove = world.lock_axis(body, (0, 1))
        world.step(1 / 60)
        self.assertAlmostEqual(0, body.velocity[1], places=3)
        self.assertAlmostEqual(2, body.velocity[0], places=3)
        with self.assertRaisesRegex(kodo.BadDefinition, "axis"):
            world.lock_axis(body, (0, 2))
        groove.remove()
        self.assertEqual([], list(world.joints))

    def test_a_ratchet_holds_the_last_tooth(self):
        world = kodo.World()
        frame, wheel = world.add(type=kodo.BodyType.STATIC), world.add(kodo.Circle(1))
        pin = world.add_joint(kodo.RevoluteJoint(a=frame, b=wheel, limits=(0, 99), ratchet=0.5))
        wheel.angular_velocity = 4
        for _ in range(20):
            world.step(1 / 60)
        wheel.angular_velocity = -4
        for _ in range(20):
            world.step(1 / 60)
        self.assertAlmostEqual(1, world.joint_state(pin).angle, places=2)

    def test_the_default_category_is_that_of_bodies_without_one(self):
        world = kodo.World()
        plain, named = world.add(), world.add(position=(9, 0), flags=1)
        which = kodo.Filter(kodo.Flags.MATCH_ANY, kodo.Flags.DEFAULT_CATEGORY)
        self.assertEqual([plain.id], world.overlap_box(((-20, -20), (20, 20)), which))
        with self.assertRaisesRegex(kodo.BadDefinition, "DEFAULT_CATEGORY"):
            named.flags = kodo.Flags.DEFAULT_CATEGORY


class ArraysTest(unittest.TestCase):
    """With the arrays of `module`, or of the standard library if it is None."""

    module = None

    def setUp(self):
        before = buffers.numpy
        self.addCleanup(lambda: setattr(buffers, "numpy", before))
        buffers.numpy = self.module

    def rows(self, made):
        return made.tolist()

    def test_poses_and_velocities_are_those_of_each_body(self):
        world, boxes = falling_boxes()
        boxes[1].angular_velocity = 1
        for _ in range(20):
            world.step(DT)
        poses, velocities = self.rows(world.poses(boxes)), self.rows(world.velocities(boxes))
        for i, box in enumerate(boxes):
            self.assertEqual([*box.position, *box.transform.rotation], poses[i])
            self.assertEqual([*box.velocity, box.angular_velocity], velocities[i])
        self.assertEqual([], self.rows(world.poses([])))

    def test_an_array_of_the_caller_is_filled_without_a_copy(self):
        world, boxes = falling_boxes()
        out = world.poses(boxes)
        boxes[2].position = (7, 8)
        self.assertIs(out, world.poses(boxes, out=out))
        self.assertEqual(7, out[2, 0])
        flat = array.array(kodo.REAL_CODE, [0] * 12)
        world.poses(boxes, out=flat)
        self.assertEqual(8, flat[9])

    def test_an_array_of_another_type_or_size_is_refused(self):
        world, boxes = falling_boxes()
        for wrong in (array.array("i", [0] * 12), array.array(kodo.REAL_CODE, [0] * 11)):
            with self.assertRaisesRegex(ValueError, "3 x 4 numbers of the type"):
                world.poses(boxes, out=wrong)
        with self.assertRaisesRegex(ValueError, "writable"):
            world.poses(boxes, out=memoryview(bytes(12 * kodo.REAL_SIZE)).cast(kodo.REAL_CODE))
        with self.assertRaises(ValueError):
            world.apply_loads(boxes, [[1, 2, 3]])

    def test_loads_act_on_each_body(self):
        world, boxes = falling_boxes()
        other = world.copy()
        world.apply_loads(boxes, [[1, 2, 3], [4, 5, 6], [7, 8, 9]])
        for i, box in enumerate(boxes):
            other[box].apply_force((1 + 3 * i, 2 + 3 * i))
            other[box].apply_torque(3 + 3 * i)
        world.step(DT)
        other.step(DT)
        self.assertEqual(other.state_hash(), world.state_hash())

    def test_worlds_step_as_each_alone(self):
        world, boxes = falling_boxes()
        for pool in (None, kodo.ThreadPool(2)):
            worlds = kodo.Worlds(world, 5, boxes, pool)
            loads = worlds.velocities()
            for i in range(5):
                loads[i, 1, 0] = i
            worlds.apply_loads(loads)
            worlds.step(DT, count=10)
            for i in range(5):
                alone = world.copy()
                alone[boxes[1]].apply_force((i, 0))
                for _ in range(10):
                    alone.step(DT)
                self.assertEqual(alone.state_hash(), worlds[i].state_hash())
            self.assertEqual(self.rows(worlds.poses())[4], self.rows(worlds[4].poses(boxes)))
            worlds.reset(4)
            self.assertEqual(world.state_hash(), worlds[4].state_hash())
            worlds.set_velocities(loads)
            self.assertEqual(3, worlds[3][boxes[1]].velocity[0])


@unittest.skipIf(buffers.numpy is None, "NumPy is not installed")
class NumpyTest(ArraysTest):
    module = buffers.numpy

    def test_arrays_are_those_of_numpy(self):
        world, boxes = falling_boxes()
        worlds = kodo.Worlds(world, 5, boxes)
        self.assertIsInstance(worlds.poses(), buffers.numpy.ndarray)
        self.assertEqual((5, 3, 4), worlds.poses().shape)
        self.assertEqual(kodo.REAL_CODE, worlds.poses().dtype.char)
        worlds.apply_loads(buffers.numpy.ones((5, 3, 3), dtype=kodo.REAL_CODE))


if __name__ == "__main__":
    unittest.main()
