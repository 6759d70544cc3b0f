// SPDX-License-Identifier: MIT
// Families of ordinary scenes: what hangs on ropes and links.
#include <worlds/ordinary_builder.hpp>

namespace worlds {

using Index = OrdinaryBuilder::Index;
using Vec = OrdinaryBuilder::Vec;

void addBridge(OrdinaryBuilder& b) {
    b.addFloor();
    const int planks = b.between(6, 24);
    const double left = -0.5 * planks;
    const Index west = b.addStatic(b.box(4, 1), {left - 2, 9.5});
    const Index east = b.addStatic(b.box(4, 1), {-left + 2, 9.5});
    Index last = west;
    for (int i = 0; i < planks; ++i) {
        const Index plank = b.add(b.box(1, 0.2), {left + 0.5 + i, 9.9});
        b.addPin(last, plank, {left + i, 9.9});
        last = plank;
    }
    b.addPin(last, east, {-left, 9.9});
    const int loads = b.between(1, std::min(5, planks / 2));
    for (int i = 0; i < loads; ++i) {
        const double size = b.between(0.5, 1.0);
        const kodo::Shape shape = b.oneIn(3) ? b.disc(size / 2) : b.box(size, size);
        const Vec at{left + planks * (i + 0.5) / loads, 10.5 + b.between(0.05, 2.0)};
        b.add(shape, at, b.densityFor(shape, last, i == 0 ? b.ratio() : b.between(1.0, b.ratio())));
    }
}

void addCrane(OrdinaryBuilder& b) {
    const Index floor = b.addFloor();
    const double long_ = b.between(5.0, 9.0);
    const double angle = b.between(0.1, 0.8);
    const Vec foot{-4, 9};
    const Index jib = b.add(b.box(long_, 0.3), foot + long_ / 2 * atAngle(angle), 1, angle);
    Vec end = foot + long_ * atAngle(angle);
    const double link = b.between(0.3, 0.6);
    const int links = b.between(4, 10);
    const Index last = b.addLinks(jib, end, links, link, -kPi / 2);
    const kodo::Shape load = b.box(b.between(0.5, 1.5), 0.8);
    const Index crate = b.add(load, end - Vec{0, 0.4}, b.densityFor(load, last, b.ratio()));
    b.addPin(last, crate, end);
    b.setMotion(crate, {b.between(-2.0, 2.0), 0});
    kodo::RevoluteJoint motor = b.pin(floor, jib, foot);
    const double weight = 10 * (b.massOf(crate) + links * b.massOf(last) + b.massOf(jib) / 2);
    const double up = b.oneIn(2) ? 1 : -1;
    motor.motorSpeed = static_cast<kodo::Real>(up * b.between(0.1, 0.6));
    motor.motorTorque = static_cast<kodo::Real>(b.between(1.2, 3.0) * weight * long_);
    motor.limits = kodo::Range{kodo::Real(-0.4), kodo::Real(0.5)};
    b.add(motor);
}

void addWreckingBall(OrdinaryBuilder& b) {
    b.addFloor();
    const double link = b.between(0.4, 0.7);
    const int links = b.between(5, 12);
    const double radius = b.between(0.4, 0.8);
    const double reach = link * links + 2 * radius;
    const Vec top{0, reach + 0.3};
    const Index hook = b.addStatic(b.box(0.4, 0.4), top + Vec{0, 0.3});
    const double tilt = -kPi / 2 - b.between(0.5, 1.4);
    Vec end = top;
    const Index last = b.addLinks(hook, end, links, link, tilt);
    const kodo::Shape shape = b.disc(radius);
    const Index ball =
        b.add(shape, end + radius * atAngle(tilt), b.densityFor(shape, last, b.ratio()));
    b.addPin(last, ball, end);
    const int rows = b.between(2, 8);
    const int columns = b.between(1, 3);
    const double width = b.between(0.5, 1.0);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            b.add(b.box(width, 0.5), {radius + 0.5 + (width + 0.01) * column, 0.25 + 0.5 * row});
        }
    }
}

void addRopeLadder(OrdinaryBuilder& b) {
    b.addFloor();
    const int rungs = b.between(4, 14);
    const double pitch = b.between(0.3, 0.6);
    const double half = b.between(0.3, 0.6);
    const double top = pitch * rungs + 2.5;
    Index last = b.addStatic(b.box(4, 0.2), {0, top + 0.1});
    for (int i = 1; i <= rungs; ++i) {
        const Vec at{0, top - pitch * i};
        const Index rung = b.add(b.box(2 * half + 0.1, 0.08), at);
        for (const double side : {-half, half}) {
            b.addRope(last, rung, at + Vec{side, pitch}, at + Vec{side, 0});
        }
        b.setMotion(rung, {b.between(-0.5, 0.5), 0});
        last = rung;
    }
    const kodo::Shape load = b.box(0.5, 0.8);
    const Vec hand{half, top - pitch * rungs};
    const Index weight = b.add(load, hand - Vec{0, 0.5}, b.densityFor(load, last, b.ratio()));
    if (b.oneIn(2)) { // on the last rung
        b.addPin(last, weight, hand);
    } else {
        b.addRope(last, weight, hand, hand - Vec{0, 0.1});
    }
    b.setMotion(weight, {b.between(-3.0, 3.0), 0});
}

void addTrebuchet(OrdinaryBuilder& b) {
    const Index floor = b.addFloor();
    const Vec pivot{0, 3.2};
    const double angle = kPi + b.between(0.5, 0.75); // of the long end
    const double longEnd = 4;
    const double shortEnd = b.between(0.7, 1.3);
    const Vec along = atAngle(angle);
    const kodo::Shape beam = b.box(longEnd + shortEnd, 0.2);
    const Index arm = b.add(beam, pivot + (longEnd - shortEnd) / 2 * along, 1, angle);
    b.filter(arm, OrdinaryBuilder::kMachine, OrdinaryBuilder::kSolid);
    b.addPin(floor, arm, pivot);
    const Vec hook = pivot - shortEnd * along;
    const kodo::Shape block = b.box(0.9, 0.9);
    const Index weight = b.add(block, hook - Vec{0, 0.8}, b.densityFor(block, arm, b.ratio()));
    b.filter(weight, OrdinaryBuilder::kMachine, OrdinaryBuilder::kSolid);
    b.addPin(arm, weight, hook);
    const Vec tip = pivot + longEnd * along;
    const double radius = b.between(0.12, 0.3);
    const Vec ball{tip.x + b.between(1.0, 2.0), radius + 0.01};
    const Index stone = b.add(b.disc(radius), ball, b.between(1.0, 3.0));
    b.filter(stone, OrdinaryBuilder::kWheel, OrdinaryBuilder::kSolid);
    b.addRope(arm, stone, tip, ball);
}

void addBigWheel(OrdinaryBuilder& b) {
    const Index floor = b.addFloor();
    const double radius = b.between(2.5, 5.0);
    const int gondolas = 2 * b.between(2, 4);
    const Vec hub{0, radius + 2};
    std::vector<kodo::Shape> spokes;
    for (int i = 0; i < gondolas / 2; ++i) {
        spokes.push_back(b.box(2 * radius, 0.15, {}, kPi * i / (gondolas / 2)));
    }
    const Index wheel = b.add(b.joined(spokes), hub);
    b.filter(wheel, OrdinaryBuilder::kMachine, OrdinaryBuilder::kNothing);
    double load = 0; // kg
    for (int i = 0; i < gondolas; ++i) {
        const Vec rim = hub + radius * atAngle(2 * kPi * i / gondolas);
        const std::vector<kodo::Shape> walls{
            b.box(1, 0.1, {0, -0.4}), b.box(0.1, 0.6, {-0.5, -0.1}), b.box(0.1, 0.6, {0.5, -0.1})};
        const Index gondola = b.add(b.joined(walls), rim - Vec{0, 0.5});
        b.addPin(wheel, gondola, rim);
        const kodo::Shape shape = b.oneIn(2) ? b.disc(0.25) : b.box(0.4, 0.5);
        const double times = std::max(0.2, b.ratio() / 10) * b.between(0.1, 1.0);
        const Index passenger =
            b.add(shape, rim - Vec{0, 0.58}, b.densityFor(shape, gondola, times));
        load += b.massOf(gondola) + b.massOf(passenger);
    }
    const double speed = (b.oneIn(2) ? 1 : -1) * b.between(0.1, 0.8);
    b.addMotor(floor, wheel, hub, speed, b.between(0.5, 2.0) * 10 * radius * load);
}

} // namespace worlds
