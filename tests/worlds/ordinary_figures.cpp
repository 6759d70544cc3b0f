// SPDX-License-Identifier: MIT
// Families of ordinary scenes: figures, toys and doors.
#include <worlds/ordinary_builder.hpp>

namespace worlds {

using Index = OrdinaryBuilder::Index;
using Vec = OrdinaryBuilder::Vec;

namespace {

/// A figure of ten parts, 1.9 m high at size 1; `at` is the middle of the torso. Its torso weighs
/// up to 30 times as much as a forearm. Its joints have friction, so that hanging limbs come to
/// rest.
void addRagdoll(OrdinaryBuilder& b, Vec at, double size, Vec velocity, double spin) {
    struct Limb {
        Vec middle;
        double width, height;
        int parent; // in the order of limbs
        Vec joint;
        double lower, upper;
    };
    const Limb limbs[] = {
        {{0, 0}, 0.4, 0.6, -1, {}, 0, 0},
        {{0, 0.48}, 0.24, 0.3, 0, {0, 0.31}, -0.5, 0.5},
        {{-0.36, 0.23}, 0.3, 0.12, 0, {-0.21, 0.23}, -1.5, 1.5},
        {{0.36, 0.23}, 0.3, 0.12, 0, {0.21, 0.23}, -1.5, 1.5},
        {{-0.67, 0.23}, 0.3, 0.1, 2, {-0.515, 0.23}, -2.2, 0.1},
        {{0.67, 0.23}, 0.3, 0.1, 3, {0.515, 0.23}, -0.1, 2.2},
        {{-0.11, -0.51}, 0.16, 0.4, 0, {-0.11, -0.31}, -0.8, 1.5},
        {{0.11, -0.51}, 0.16, 0.4, 0, {0.11, -0.31}, -1.5, 0.8},
        {{-0.11, -0.92}, 0.13, 0.4, 6, {-0.11, -0.715}, -2, 0.1},
        {{0.11, -0.92}, 0.13, 0.4, 7, {0.11, -0.715}, -0.1, 2},
    };
    std::vector<Index> parts;
    for (const Limb& limb : limbs) {
        const Vec arm = size * limb.middle;
        parts.push_back(b.add(b.box(size * limb.width, size * limb.height), at + arm));
        b.setMotion(parts.back(), velocity + kodo::cross(spin, arm), spin);
        if (limb.parent >= 0) {
            kodo::RevoluteJoint joint = b.pin(parts[static_cast<std::size_t>(limb.parent)],
                                              parts.back(), at + size * limb.joint);
            joint.limits = kodo::Range{static_cast<kodo::Real>(limb.lower),
                                       static_cast<kodo::Real>(limb.upper)};
            joint.motorTorque = static_cast<kodo::Real>(0.01 * size * size * size); // N m
            b.add(joint);
        }
    }
    const double heavier = std::min(30.0, b.ratio()) / 8; // the torso has the area of 8 forearms
    b.body(parts[0]).density = static_cast<kodo::Real>(std::max(1.0, heavier));
}

} // namespace

void throwRagdolls(OrdinaryBuilder& b) {
    b.addFloor(7);
    const int count = b.between(1, 3);
    for (int i = 0; i < count; ++i) {
        const Vec velocity{b.between(-12.0, 12.0), b.between(-8.0, 6.0)};
        const Vec at{-4.0 + 4 * i, b.between(2.0, 6.0)};
        addRagdoll(b, at, b.between(0.8, 1.2), velocity, b.between(-8.0, 8.0));
    }
    b.setRestitution(b.oneIn(3) ? b.between(0.0, 0.4) : 0);
    b.recipe().rests = true;
}

void wedgeRagdolls(OrdinaryBuilder& b) {
    b.addFloor(7);
    const double gap = b.between(0.2, 0.5);
    const double steep = b.between(0.7, 1.3);
    for (const double side : {-1.0, 1.0}) { // a funnel
        const Vec low{side * gap, 2};
        const Vec along = {side * std::cos(steep), std::sin(steep)};
        b.addStatic(b.box(6, 0.4), low + 3.0 * along, side > 0 ? steep : -steep);
    }
    const int count = b.between(1, 3);
    for (int i = 0; i < count; ++i) {
        addRagdoll(b, {b.between(-0.3, 0.3), 9 + 2.4 * i}, b.between(0.8, 1.1),
                   {0, b.between(-8.0, 0.0)}, 0);
    }
    b.recipe().rests = true;
}

void addSoftRing(OrdinaryBuilder& b) {
    b.addFloor(6);
    const int count = 2 * b.between(3, 6); // corners that stop it from rolling
    const double radius = b.between(0.7, 1.5);
    const double side = 1.2 * radius * std::sin(kPi / count);
    const double hertz = b.between(3.0, 10.0);
    const double damping = b.between(0.3, 0.8);
    const Vec middle{b.between(-2.0, 2.0), radius + side + b.between(0.2, 4.0)};
    std::vector<Index> blocks; // balls would roll
    const auto at = [&](double i) { return middle + radius * atAngle(2 * kPi * i / count); };
    for (int i = 0; i < count; ++i) {
        blocks.push_back(b.add(b.box(side, side), at(i), 1, 2 * kPi * i / count));
        b.setMotion(blocks.back(), {b.between(-0.5, 0.5), 0});
    }
    for (int i = 0; i < count; ++i) {
        const Index one = blocks[static_cast<std::size_t>(i)];
        const Index next = blocks[static_cast<std::size_t>((i + 1) % count)];
        const Vec half = (0.5 * side) * atAngle(2 * kPi * (i + 0.5) / count + kPi / 2);
        b.addSpring(one, next, at(i) + half, at(i + 1) - half, hertz, damping);
        const Index third = blocks[static_cast<std::size_t>((i + 2) % count)];
        b.addSpring(one, third, at(i), at(i + 2), hertz, damping); // against bending
        if (i < count / 2) {
            const auto opposite = static_cast<std::size_t>(i + count / 2);
            b.addSpring(one, blocks[opposite], at(i), at(i + count / 2), hertz, damping);
        }
    }
    if (b.oneIn(2)) {
        const kodo::Shape crate = b.box(radius, 0.6);
        const double times = std::min(b.ratio(), 10.0);
        b.add(crate, {middle.x, middle.y + radius + side + 1},
              b.densityFor(crate, blocks[0], times));
    }
    b.recipe().rests = true;
}

void addCradle(OrdinaryBuilder& b) {
    b.addFloor();
    const Index beam = b.addStatic(b.box(8, 0.4), {0, 8});
    const int count = b.between(2, 7);
    const int lifted = b.between(1, count - 1);
    const double long_ = b.between(2.0, 5.0);
    const double angle = b.between(0.4, 1.1);
    const double pitch = 1.002; // m; the balls do not touch
    for (int i = 0; i < count; ++i) {
        const Vec top{pitch * (i - 0.5 * (count - 1)), 7.8};
        const double tilt = i < lifted ? -kPi / 2 - angle : -kPi / 2;
        const Vec bottom = top + long_ * atAngle(tilt);
        const Index ball = b.add(b.disc(0.5), bottom);
        b.filter(ball, OrdinaryBuilder::kMachine, OrdinaryBuilder::kMachine);
        if (b.oneIn(2)) {
            b.addRod(beam, ball, top, bottom);
        } else {
            b.addPin(beam, ball, top);
        }
    }
    b.setRestitution(1);
}

void addSeeSaw(OrdinaryBuilder& b) {
    const Index floor = b.addFloor();
    const double half = b.between(1.5, 3.0);
    const double height = b.between(0.7, 1.0);
    const Index plank = b.add(b.box(2 * half, 0.15), {0, height});
    b.addLimitedPin(floor, plank, {0, height}, -0.2, 0.2);
    const kodo::Shape crate = b.box(0.6, 0.6);
    Index light = 0;
    for (const double side : {-1.0, 1.0}) {
        const Vec at{side * (half - 0.4), height + 0.4 + b.between(0.0, 3.0)};
        const double density = side > 0 ? b.densityFor(crate, light, b.ratio()) : 1;
        light = b.add(crate, at, density);
    }
    b.setRestitution(b.oneIn(3) ? b.between(0.0, 0.3) : 0);
    b.recipe().rests = true;
}

void addDoors(OrdinaryBuilder& b) {
    const bool fromAbove = b.oneIn(2); // a plan, without gravity
    if (fromAbove) {
        b.recipe().world.gravity = {};
    }
    b.addFloor(9);
    const int count = b.between(1, 4);
    for (int i = 0; i < count; ++i) {
        const double x = -6 + 4.0 * i;
        const double width = b.between(1.0, 2.0);
        const Index post = b.addStatic(b.box(0.6, 0.6), {x, 5});
        const Vec hinge{x + 0.35, 5};
        const Index door = b.add(b.box(width, 0.12), {hinge.x + width / 2, 5});
        b.addLimitedPin(post, door, hinge, -b.between(0.8, 1.4), fromAbove ? 1.2 : 0.0);
        const double size = b.between(0.4, 0.8);
        const kodo::Shape shape = b.oneIn(2) ? b.disc(size / 2) : b.box(size, size);
        const Vec at{hinge.x + b.between(0.5, 1.0) * width, b.between(5.8, 8.0)};
        const Index load = b.add(shape, at, b.densityFor(shape, door, b.ratio()));
        if (fromAbove) {
            b.setMotion(load, {0, -b.between(2.0, 12.0)});
        } else {
            b.body(load).shape = b.box(size, size); // a disc would roll for ever
        }
    }
    b.recipe().rests = !fromAbove;
}

void addFlail(OrdinaryBuilder& b) {
    b.addFloor();
    const double long_ = b.between(0.25, 0.5);
    const int links = b.between(3, 8);
    const double radius = b.between(0.25, 0.5);
    const Vec hand{0, 1.5 + 2 + long_ * links + 2 * radius};
    const Index handle = b.add(b.box(2, 0.2), hand);
    Vec end = hand + Vec{1, 0};
    const Index last = b.addLinks(handle, end, links, long_, 0);
    const kodo::Shape ball = b.disc(radius);
    const Index weight = b.add(ball, end + Vec{radius, 0}, b.densityFor(ball, last, b.ratio()));
    b.addPin(last, weight, end);
    const double spin = b.between(3.0, 12.0);
    if (b.oneIn(2)) { // swung by a motor
        const Index post = b.addStatic(b.box(0.2, 0.2), hand);
        const double reach = 2 + long_ * links;
        const double torque = b.between(1.0, 4.0) * 10 * reach * b.massOf(weight);
        b.addMotor(post, handle, hand, spin, torque);
    } else { // thrown
        for (kodo::BodyDef& def : b.recipe().bodies) {
            if (def.type == kodo::BodyType::Dynamic) {
                const Vec arm{static_cast<double>(def.position.x) - hand.x, 0};
                const Vec velocity = Vec{b.between(4.0, 4.0), 3} + kodo::cross(spin / 3, arm);
                def.velocity = {static_cast<kodo::Real>(velocity.x),
                                static_cast<kodo::Real>(velocity.y)};
                def.angularVelocity = static_cast<kodo::Real>(spin / 3);
            }
        }
    }
}

} // namespace worlds
