// SPDX-License-Identifier: MIT
// The passes against sequential impulses in double: one contact at a time, and each impulse is
// applied to both bodies before the next one is computed.
#include <gtest/gtest.h>
#include <solve/random_blocks.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace kodo {
namespace {

using DoubleVec = BasicVec2<double>;

// For numbers of up to 50, after some twenty operations.
constexpr double kRounding = sizeof(Real) == 4 ? 1e-4 : 1e-12;

DoubleVec wide(Vec2 v) {
    return {double(v.x), double(v.y)};
}

struct Side {
    DoubleVec velocity;
    double spin;
    double invMass;
    double invInertia;
    DoubleVec move;
    double turn;

    explicit Side(const BodyVelocity& motion)
        : velocity(wide(motion.velocity)),
          spin(double(motion.angularVelocity)),
          invMass(double(motion.invMass)),
          invInertia(double(motion.invInertia)),
          move(wide(motion.deltaPosition)),
          turn(double(motion.deltaAngle)) {}

    void push(DoubleVec impulse, double moment) {
        velocity = velocity + invMass * impulse;
        spin += invInertia * moment;
    }
};

/// A direction of impulses, with the levers of both bodies.
struct Line {
    DoubleVec direction;
    double leverA;
    double leverB;
};

/// One contact before a pass, and the result of the pass.
class InTurn {
public:
    InTurn(const RandomBlocks& before, const RandomBlocks& after, const PassSettings& settings,
           std::size_t i, std::size_t lane)
        : before_(before.blocks[i]),
          after_(after.blocks[i]),
          lane_(lane),
          points_(before.use[i].twoPoints ? 2 : 1),
          surface_(before.use[i].surface < 0
                       ? nullptr
                       : &before.surfaces[static_cast<std::size_t>(before.use[i].surface)]),
          soft_(before.use[i].onLocked ? settings.onLocked : settings.soft),
          invH_(double(settings.invH)),
          pushSpeed_(double(settings.pushSpeed)),
          normal_{double(before_.normalX[lane]), double(before_.normalY[lane])},
          a_(before.motion[bodyOfPlace(before_.a[lane])]),
          b_(before.motion[bodyOfPlace(before_.b[lane])]) {}

    void warmStart() {
        for (std::size_t k = 0; k < points_; ++k) {
            push(lineOf(k), double(before_.points[k].impulse[lane_]));
        }
        push(tangent(), double(before_.friction[lane_]));
        if (surface_ != nullptr) {
            turn(double(before_.rolling[lane_]));
        }
    }
    void solve() {
        if (points_ == 2 && (pushes(0) || pushes(1))) {
            pushTogether(true);
        } else {
            pushPoints(true);
        }
        roll();
    }
    void relax(bool friction) {
        pushTogether(false);
        if (friction) {
            applyFriction();
        }
        roll();
    }

    void expectBodies(const RandomBlocks& after) const {
        expectBody(after.motion[bodyOfPlace(before_.a[lane_])], a_);
        expectBody(after.motion[bodyOfPlace(before_.b[lane_])], b_);
    }

private:
    static void expectBody(const BodyVelocity& motion, const Side& side) {
        EXPECT_NEAR(double(motion.velocity.x), side.velocity.x, kRounding);
        EXPECT_NEAR(double(motion.velocity.y), side.velocity.y, kRounding);
        EXPECT_NEAR(double(motion.angularVelocity), side.spin, kRounding);
    }

    Line lineOf(std::size_t k) const {
        const ContactBlock::Point& point = before_.points[k];
        return {normal_, double(point.leverA[lane_]), double(point.leverB[lane_])};
    }
    Line tangent() const {
        return {perp(normal_), double(before_.tangentLeverA[lane_]),
                double(before_.tangentLeverB[lane_])};
    }
    double speedAlong(const Line& line) const {
        return dot(line.direction, b_.velocity - a_.velocity) + line.leverB * b_.spin -
               line.leverA * a_.spin;
    }
    double gapAt(std::size_t k) const {
        const Line line = lineOf(k);
        return double(before_.points[k].separation[lane_]) + dot(normal_, b_.move - a_.move) +
               line.leverB * b_.turn - line.leverA * a_.turn;
    }

    void push(const Line& line, double impulse) {
        a_.push(-impulse * line.direction, -impulse * line.leverA);
        b_.push(impulse * line.direction, impulse * line.leverB);
    }
    void turn(double moment) {
        a_.push({}, -moment);
        b_.push({}, moment);
    }

    /// With softness and bias if `apart`, which separates overlaps; without them otherwise.
    double wanted(std::size_t k, bool apart) const {
        const double sum = double(before_.points[k].impulse[lane_]);
        const double mass = double(before_.points[k].mass[lane_]);
        const double speed = speedAlong(lineOf(k));
        const double gap = gapAt(k);
        if (gap > 0 || !apart) {
            return sum - mass * (speed + invH_ * std::max(gap, 0.0));
        }
        return sum - double(soft_.massScale) * mass * (speed + biasOf(gap)) -
               double(soft_.impulseScale) * sum;
    }
    double biasOf(double gap) const {
        return std::max(double(soft_.biasRate) * gap, -double(before_.pushSpeed[lane_]));
    }
    /// True for a point that pushes its bodies apart: at more than 1/32 of the push speed.
    bool pushes(std::size_t k) const { return biasOf(gapAt(k)) < -pushSpeed_ / 32; }
    double massOf(std::size_t k, bool apart) const {
        const double scale = apart && gapAt(k) <= 0 ? double(soft_.massScale) : 1.0;
        return scale * double(before_.points[k].mass[lane_]);
    }
    double sumOf(std::size_t k) const { return double(before_.points[k].impulse[lane_]); }
    /// Change of the speed at one point per impulse at the other.
    double coupling() const {
        const Line first = lineOf(0);
        const Line second = lineOf(1);
        return a_.invMass + b_.invMass + a_.invInertia * first.leverA * second.leverA +
               b_.invInertia * first.leverB * second.leverB;
    }
    /// Impulses of both points, so that both get the speed they want; one that would pull lets go.
    std::array<double, 2> together(bool apart) const {
        const double mass1 = massOf(0, apart);
        const double mass2 = massOf(1, apart);
        const double e1 = wanted(0, apart) - sumOf(0);
        const double e2 = wanted(1, apart) - sumOf(1);
        const double c12 = mass2 * coupling();
        const double c21 = mass1 * coupling();
        const double determinant = 1 - c12 * c21;
        double first = wanted(0, apart); // of bodies that hardly rotate: one after the other
        if (determinant >= 1e-3) {
            const double second = sumOf(1) + (e2 - c12 * e1) / determinant;
            first = wanted(0, apart) + c21 * (sumOf(1) - std::max(second, 0.0));
        }
        first = std::max(first, 0.0);
        return {first, std::max(wanted(1, apart) - c12 * (first - sumOf(0)), 0.0)};
    }
    void pushPoint(std::size_t k, double next) {
        EXPECT_NEAR(double(after_.points[k].impulse[lane_]), next, kRounding) << "point " << k;
        push(lineOf(k), next - sumOf(k));
        pressed_ += next;
    }
    void pushPoints(bool apart) {
        for (std::size_t k = 0; k < points_; ++k) {
            pushPoint(k, std::max(wanted(k, apart), 0.0));
        }
    }
    void pushTogether(bool apart) {
        if (points_ == 1) {
            return pushPoints(apart);
        }
        const std::array<double, 2> both = together(apart);
        pushPoint(0, both[0]);
        pushPoint(1, both[1]);
    }
    void applyFriction() {
        const double sum = double(before_.friction[lane_]);
        const double belt = surface_ != nullptr ? double(surface_->speed[lane_]) : 0.0;
        const double stick =
            sum - double(before_.tangentMass[lane_]) * (speedAlong(tangent()) + belt);
        const double slip = double(before_.kineticFriction[lane_]) * pressed_;
        const bool holds = std::abs(stick) <= double(before_.staticFriction[lane_]) * pressed_;
        const double next = holds ? stick : std::clamp(stick, -slip, slip);
        EXPECT_NEAR(double(after_.friction[lane_]), next, kRounding);
        push(tangent(), next - sum);
    }
    void roll() {
        if (surface_ != nullptr) {
            const double sum = double(before_.rolling[lane_]);
            const double most = double(surface_->rollingLever[lane_]) * pressed_;
            const double stop = sum - double(surface_->rollingMass[lane_]) * (b_.spin - a_.spin);
            turn(std::clamp(stop, -most, most) - sum);
        }
    }

    const ContactBlock& before_;
    const ContactBlock& after_;
    std::size_t lane_;
    std::size_t points_;
    const SurfaceBlock* surface_;
    Softness soft_;
    double invH_;
    double pushSpeed_;
    DoubleVec normal_;
    Side a_;
    Side b_;
    double pressed_ = 0; // N s, along the normal, of all points
};

/// Runs a pass, and calls pushInTurn(contact) for each of its contacts.
template <typename PushInTurn>
void compare(ContactPasses::Pass run, bool friction, PushInTurn pushInTurn) {
    const RandomBlocks before(23);
    RandomBlocks after(23);
    ContactPassArguments pass = after.pass();
    pass.settings.friction = friction;
    run(pass);
    for (std::size_t i = 0; i < kBlocks; ++i) {
        if (RandomBlocks::hasStiction(i)) {
            continue; // solved with friction at once; see static_friction_test.cpp
        }
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            SCOPED_TRACE("block " + std::to_string(i) + ", lane " + std::to_string(lane));
            InTurn contact(before, after, pass.settings, i, lane);
            pushInTurn(contact);
            contact.expectBodies(after);
        }
    }
}

// The passes compute the mutual effect of impulses from the coupling of their directions, before
// applying any.
TEST(ContactPasses, AgreeWithSequentialImpulses) {
    const ContactPasses& passes = ContactPasses::best();
    compare(passes.warmStart, true, [](InTurn& contact) { contact.warmStart(); });
    compare(passes.solve, true, [](InTurn& contact) { contact.solve(); });
    compare(passes.relax, true, [](InTurn& contact) { contact.relax(true); });
    compare(passes.relax, false, [](InTurn& contact) { contact.relax(false); });
}

// Another thread may be solving the locked bodies, so they are never written, not even with their
// old value.
TEST(ContactPasses, WriteOnlyBodiesThatAreNotLocked) {
    const RandomBlocks before(25);
    RandomBlocks all(25);
    RandomBlocks some(25);
    for (std::size_t i = 0; i < kBlocks; ++i) {
        some.use[i].movesA = static_cast<std::uint8_t>(37 * i);
        some.use[i].movesB = static_cast<std::uint8_t>(91 * i + 5);
        all.use[i].movesA = all.use[i].movesB = 0xff;
    }
    ContactPasses::best().relax(all.pass());
    ContactPasses::best().relax(some.pass());
    for (std::size_t i = 0; i < kBlocks; ++i) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const auto expectBody = [&](std::uint32_t place, std::uint8_t moves) {
                const std::uint32_t body = bodyOfPlace(place);
                const BodyVelocity& wanted = ((moves >> lane & 1) != 0 ? all : before).motion[body];
                EXPECT_EQ(some.motion[body].velocity, wanted.velocity) << i << ", " << lane;
                EXPECT_EQ(some.motion[body].angularVelocity, wanted.angularVelocity);
            };
            expectBody(some.blocks[i].a[lane], some.use[i].movesA);
            expectBody(some.blocks[i].b[lane], some.use[i].movesB);
        }
    }
}

} // namespace
} // namespace kodo
