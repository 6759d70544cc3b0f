// SPDX-License-Identifier: MIT
// Families of ordinary scenes: vehicles and linkages with motors.
#include <worlds/ordinary_builder.hpp>

namespace worlds {

using Index = OrdinaryBuilder::Index;
using Vec = OrdinaryBuilder::Vec;

namespace {

constexpr kodo::Flags kMachine = OrdinaryBuilder::kMachine;
constexpr kodo::Flags kSolid = OrdinaryBuilder::kSolid;
constexpr kodo::Flags kWheel = OrdinaryBuilder::kWheel;

/// Terrain from x = -40 m to 400 m, flat for the first 50 m, with heights from -rough to 0.
void addRoughGround(OrdinaryBuilder& b, double rough) {
    const double spacing = b.between(0.5, 1.5);
    kodo::Heightmap map{{-40, 0}, static_cast<kodo::Real>(spacing), {}};
    for (double x = -40; x < 400; x += spacing) {
        map.heights.push_back(static_cast<kodo::Real>(x < 10 ? 0 : b.between(-rough, 0.0)));
    }
    b.addStatic(map, {});
}

/// Where circles of radius r about a and s about c meet, left of the way from a to c.
Vec meet(Vec a, double r, Vec c, double s) {
    const Vec way = c - a;
    const double d = kodo::length(way);
    const double along = (r * r - s * s + d * d) / (2 * d);
    const double aside = std::sqrt(r * r - along * along);
    return a + along / d * way + aside / d * Vec{-way.y, way.x};
}

/// Chebyshev's lambda linkage: the foot is on the far end of the coupler.
void addLeg(OrdinaryBuilder& b, Index body, Index crank, Vec hub, double side, double phase) {
    const double unit = 0.22; // m, length of the crank
    const Vec rocker = hub + side * Vec{2 * unit, 0};
    const Vec wrist = hub + unit * atAngle(phase);
    const Vec knee = side > 0 ? meet(rocker, 2.5 * unit, wrist, 2.5 * unit)
                              : meet(wrist, 2.5 * unit, rocker, 2.5 * unit);
    const Vec way = knee - wrist;
    const Index coupler =
        b.add(b.box(2 * kodo::length(way), 0.1), wrist + way, 1, std::atan2(way.y, way.x));
    const Vec back = knee - rocker;
    const Index link =
        b.add(b.box(kodo::length(back), 0.1), 0.5 * (knee + rocker), 1, std::atan2(back.y, back.x));
    for (const Index part : {coupler, link}) {
        b.filter(part, kMachine, kSolid);
    }
    b.addPin(crank, coupler, wrist);
    b.addPin(body, link, rocker);
    b.addPin(link, coupler, knee);
}

} // namespace

void addCar(OrdinaryBuilder& b) {
    addRoughGround(b, b.between(0.0, 0.25));
    const double radius = b.between(0.35, 0.5);
    const Vec middle{0, radius + 0.6};
    const bool sprung = b.oneIn(2);
    std::vector<Index> wheels;
    for (const double x : {-0.9, 0.9}) {
        wheels.push_back(b.add(b.disc(radius), {x, radius + 0.01}));
        b.filter(wheels.back(), kMachine, kSolid);
    }
    const kodo::Shape hull = b.box(2.6, 0.5);
    const Index chassis =
        b.add(hull, middle + Vec{0, 0.2}, b.densityFor(hull, wheels[0], b.ratio()));
    b.filter(chassis, kMachine, kSolid);
    const double speed = -b.between(4.0, 14.0);
    const double torque = b.between(0.2, 1.0) * 10 * b.massOf(chassis) * radius;
    for (const Index wheel : wheels) {
        const kodo::Vec2 at = b.body(wheel).position;
        const Vec hub{static_cast<double>(at.x), static_cast<double>(at.y)};
        Index axle = chassis;
        if (sprung) {
            axle = b.add(b.box(0.3, 0.2), hub, b.between(1.0, 4.0));
            b.filter(axle, kMachine, kSolid);
            kodo::PrismaticJoint strut = b.slider(chassis, axle, hub, {0, 1});
            strut.limits = kodo::Range{kodo::Real(-0.15), kodo::Real(0.15)};
            b.add(strut);
            b.addSpring(chassis, axle, hub + Vec{0, 0.6}, hub, b.between(3.0, 8.0),
                        b.between(0.3, 0.9));
        }
        b.addMotor(axle, wheel, hub, speed, torque);
    }
}

void addPiston(OrdinaryBuilder& b) {
    const Index floor = b.addFloor();
    const double throw_ = b.between(0.2, 0.5); // m, radius of the crank
    const double rod = throw_ * b.between(2.0, 4.0);
    const Vec hub{0, 1.2};
    const double phase = b.between(0.0, 2 * kPi);
    const Vec wrist = hub + throw_ * atAngle(phase);
    const Vec pinAt{0, wrist.y + std::sqrt(rod * rod - wrist.x * wrist.x)};
    const Index crank = b.add(b.disc(throw_ + 0.1), hub);
    const Vec way = pinAt - wrist;
    const Index bar = b.add(b.box(rod, 0.12), wrist + 0.5 * way, 1, std::atan2(way.y, way.x));
    for (const Index part : {crank, bar}) {
        b.filter(part, kMachine, OrdinaryBuilder::kNothing);
    }
    const Index head = b.add(b.box(1, 0.5), pinAt + Vec{0, 0.15}, 2);
    for (const double side : {-1.0, 1.0}) { // the cylinder
        b.addStatic(b.box(0.4, 8), {side * 0.75, 4 + hub.y + rod});
    }
    double load = b.massOf(head);
    const int crates = b.between(0, 3);
    for (int i = 0; i < crates; ++i) {
        const kodo::Shape crate = b.box(0.8, 0.5);
        const Vec at{0, pinAt.y + 0.7 + 0.52 * i};
        const double times = std::max(0.1, std::min(b.ratio() / 5, 10.0));
        load += b.massOf(b.add(crate, at, b.densityFor(crate, head, times)));
    }
    b.addPin(crank, bar, wrist);
    b.addPin(bar, head, pinAt);
    b.add(b.slider(floor, head, pinAt, {0, 1}));
    b.addMotor(floor, crank, hub, b.between(1.0, 9.0), b.between(1.5, 4.0) * 10 * load * throw_);
}

void addTank(OrdinaryBuilder& b) {
    b.addFloor();
    for (int i = 0; i < 6; ++i) {
        b.addStatic(b.box(0.6, b.between(0.05, 0.3)), {6 + 3.0 * i, 0});
    }
    const double radius = b.between(0.35, 0.5);
    const int wheels = b.between(2, 4);
    const double half = b.between(1.1, 1.3) * radius * (wheels - 1); // m, between end hubs: 2 half
    const double thick = 0.08;
    const double rim = radius + thick / 2 + 0.04; // m, of the line of pins
    const Vec middle{0, rim + thick / 2 + 0.08};
    const int links = static_cast<int>(std::round((4 * half + 2 * kPi * rim) / 0.28));
    const auto at = [&](int i) { // on the outline, counter-clockwise
        double s = (4 * half + 2 * kPi * rim) * (i % links) / links;
        for (const double side : {1.0, -1.0}) {
            if (s < 2 * half) {
                return middle + side * Vec{s - half, -rim};
            }
            s -= 2 * half;
            if (s < kPi * rim) {
                return middle + side * (Vec{half, 0} + rim * atAngle(s / rim - kPi / 2));
            }
            s -= kPi * rim;
        }
        return middle + Vec{-half, -rim};
    };
    std::vector<Index> track;
    for (int i = 0; i < links; ++i) {
        const Vec way = at(i + 1) - at(i);
        track.push_back(
            b.add(b.box(kodo::length(way), thick), at(i) + 0.5 * way, 2, std::atan2(way.y, way.x)));
        b.filter(track.back(), kMachine, kSolid | kWheel);
    }
    for (std::size_t i = 0; i < track.size(); ++i) {
        b.addPin(track[i], track[(i + 1) % track.size()], at(static_cast<int>(i) + 1));
    }
    const kodo::Shape hull = b.box(2 * half, 0.5);
    const Index chassis =
        b.add(hull, middle + Vec{0, 0.3}, b.densityFor(hull, track[0], b.ratio()));
    b.filter(chassis, OrdinaryBuilder::kHull, kSolid);
    const double speed = -b.between(2.0, 8.0);
    for (int i = 0; i < wheels; ++i) {
        const Vec hub = middle + Vec{-half + 2 * half * i / (wheels - 1), 0};
        const Index wheel = b.add(b.disc(radius), hub);
        b.filter(wheel, kWheel, kSolid | kMachine);
        b.addMotor(chassis, wheel, hub, speed, b.between(1.0, 4.0) * 10 * b.massOf(chassis) * 0.3);
    }
}

void addRobotArm(OrdinaryBuilder& b) {
    const Index floor = b.addFloor();
    const int parts = b.between(2, 4);
    const double part = b.between(0.8, 1.5);
    Vec end{0, parts * part + 1};
    double angle = kPi / 2 + b.between(-0.8, 0.8);
    Index last = floor;
    std::vector<Index> arm;
    std::vector<Vec> elbows;
    for (int i = 0; i < parts; ++i) {
        const Index bar = b.add(b.box(part, 0.2), end + part / 2 * atAngle(angle), 1, angle);
        b.filter(bar, kMachine, kSolid);
        arm.push_back(bar);
        elbows.push_back(end);
        end += part * atAngle(angle);
        angle += b.between(-1.0, 1.0);
    }
    const kodo::Shape load = b.box(0.5, 0.5);
    const Index hand = b.add(load, end, b.densityFor(load, arm[0], b.ratio()));
    b.filter(hand, kMachine, kSolid);
    for (int i = 0; i < parts; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double reach = part * (parts - i);
        const double weight = 10 * (b.massOf(hand) + (parts - i) * b.massOf(arm[k]) / 2);
        kodo::RevoluteJoint motor = b.pin(last, arm[k], elbows[k]);
        motor.motorSpeed = static_cast<kodo::Real>((b.oneIn(2) ? 1 : -1) * b.between(0.2, 2.0));
        motor.motorTorque = static_cast<kodo::Real>(b.between(1.5, 4.0) * weight * reach);
        motor.limits = kodo::Range{kodo::Real(-0.7), kodo::Real(0.7)};
        b.add(motor);
        last = arm[k];
    }
    b.addWeld(last, hand, end);
    b.recipe().rests = true;
}

void addWalker(OrdinaryBuilder& b) {
    b.addFloor();
    const Vec hub{0, 1.6};
    const Index crank = b.add(b.disc(0.25), hub);
    b.filter(crank, kMachine, OrdinaryBuilder::kNothing);
    const kodo::Shape hull = b.box(1.6, 0.3);
    const Index chassis = b.add(hull, hub + Vec{0, 0.1}, b.densityFor(hull, crank, b.ratio()));
    b.filter(chassis, kMachine, kSolid);
    const double phase = b.between(0.0, 2 * kPi);
    const int pairs = b.between(1, 2);
    for (int i = 0; i < pairs; ++i) {
        for (const double side : {-1.0, 1.0}) {
            addLeg(b, chassis, crank, hub, side, phase + kPi * i);
        }
    }
    const double torque = b.between(1.0, 4.0) * 10 * b.massOf(chassis) * 0.25;
    b.addMotor(chassis, crank, hub, (b.oneIn(2) ? 1 : -1) * b.between(1.0, 6.0), torque);
}

void addScissorLift(OrdinaryBuilder& b) {
    const Index floor = b.addFloor();
    const int stages = b.between(1, 4);
    const double long_ = b.between(1.6, 2.4);
    const double angle = b.between(0.35, 0.7);
    const Vec side = long_ * Vec{std::cos(angle), 0};
    const Vec up = long_ * Vec{0, std::sin(angle)};
    const Vec low{-side.x / 2, 0.3};
    const Index foot = b.add(b.box(0.3, 0.3), low + side, 4);
    b.filter(foot, kMachine, OrdinaryBuilder::kNothing);
    Index left = floor; // what holds the lower ends of the next stage
    Index right = foot;
    for (int i = 0; i < stages; ++i) {
        const Vec at = low + static_cast<double>(i) * up;
        const Vec middle = at + 0.5 * (side + up);
        const Index rising = b.add(b.box(long_, 0.1), middle, 1, angle);
        const Index falling = b.add(b.box(long_, 0.1), middle, 1, -angle);
        for (const Index bar : {rising, falling}) {
            b.filter(bar, kMachine, OrdinaryBuilder::kNothing);
        }
        b.addPin(rising, falling, middle);
        b.addPin(left, rising, at);
        b.addPin(right, falling, at + side);
        left = falling;
        right = rising;
    }
    const Vec top = low + static_cast<double>(stages) * up;
    const Index table = b.add(b.box(side.x + 0.8, 0.12), top + 0.5 * side + Vec{0, 0.06}, 2);
    const Index shoe = b.add(b.box(0.3, 0.3), top + side, 4);
    b.filter(shoe, kMachine, OrdinaryBuilder::kNothing);
    b.addPin(left, table, top);
    b.addPin(right, shoe, top + side);
    b.add(b.slider(table, shoe, top + side, {1, 0}));
    const kodo::Shape crate = b.box(0.7, 0.7);
    const Vec at = top + 0.5 * side + Vec{b.between(-0.3, 0.3), 0.5};
    const Index load = b.add(crate, at, b.densityFor(crate, left, b.ratio()));
    kodo::PrismaticJoint drive = b.slider(floor, foot, low + side, {1, 0});
    const double weight = 10 * (b.massOf(load) + b.massOf(table) + stages * 0.4);
    drive.motorSpeed = static_cast<kodo::Real>(-b.between(0.1, 0.5));
    drive.motorForce =
        static_cast<kodo::Real>(b.between(1.2, 2.0) * stages * weight / std::tan(angle));
    drive.limits = kodo::Range{static_cast<kodo::Real>(-0.4 * side.x), kodo::Real(0.02)};
    b.add(drive);
    b.recipe().rests = true;
}

} // namespace worlds
