// SPDX-License-Identifier: MIT
#include <kodo_sfml/joint_painter.hpp>

#include <array>
#include <cmath>
#include <variant>
#include <vector>

namespace kodo_sfml {

namespace {

constexpr float kArmWidth = 1;   // pixels
constexpr float kJointWidth = 2; // pixels
constexpr float kJointMark = 5;  // pixels, half the size of a mark
constexpr kodo::Real kShownAxis =
    kodo::Real(0.5); // m, shown to both sides of a slider without limits

const Rgba kJointColor{120, 220, 230};
const Rgba kArmColor{120, 220, 230, 110};

/// Scaled to a length in pixels; {0, 0} has no direction and stays.
Pixel scaled(Pixel way, float pixels) {
    const float length = std::hypot(way.x, way.y);
    return length > 0 ? (pixels / length) * way : Pixel{};
}

Pixel turned(Pixel way) {
    return {-way.y, way.x};
}

/// Draws each kind of joint; a kind without a function does not compile.
class JointPainter {
public:
    JointPainter(Painter& painter, const Camera& camera, const kodo::World& world)
        : painter_(painter), camera_(camera), world_(world) {}

    void operator()(const kodo::RevoluteJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        line(a, b);
        painter_.ring(b, kJointMark, kJointWidth, kJointColor);
    }

    void operator()(const kodo::FixedJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        line(a, b);
        const std::array<Pixel, 4> square = {
            b + Pixel{-kJointMark, -kJointMark}, b + Pixel{kJointMark, -kJointMark},
            b + Pixel{kJointMark, kJointMark}, b + Pixel{-kJointMark, kJointMark}};
        painter_.outline(square, kJointWidth, kJointColor);
    }

    void operator()(const kodo::DistanceJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        if (joint.hertz > 0) {
            zigzag(a, b);
        } else {
            line(a, b);
        }
        dot(a);
        dot(b);
    }

    void operator()(const kodo::PrismaticJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        const kodo::Range range = joint.limits.value_or(kodo::Range{-kShownAxis, kShownAxis});
        const kodo::Transform frame = world_[joint.ends.a].transform();
        const auto place = [&](kodo::Real along) {
            return camera_.toPixels(frame * (joint.ends.anchorA + along * joint.axis));
        };
        const std::array<Pixel, 2> stops = {place(range.lower), place(range.upper)};
        line(stops[0], stops[1]);
        if (joint.limits) {
            const kodo::Vec2 axis = frame.rotation * joint.axis;
            const Pixel bar = turned(
                scaled({static_cast<float>(axis.x), static_cast<float>(-axis.y)}, 2 * kJointMark));
            line(stops[0] - bar, stops[0] + bar);
            line(stops[1] - bar, stops[1] + bar);
        }
        dot(b);
    }

    void operator()(const kodo::MotorJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        line(b, a);
        dot(b);
        const Pixel back = scaled(b - a, 2 * kJointMark);
        line(a, a + back + turned(back) / 2);
        line(a, a + back - turned(back) / 2);
        painter_.ring(a, kJointMark, kArmWidth, kJointColor);
    }

    void operator()(const kodo::MouseJoint& joint) const {
        const Pixel grip = camera_.toPixels(world_[joint.body].transform() * joint.anchor);
        const Pixel target = camera_.toPixels(joint.target);
        line(grip, target);
        dot(grip);
        line(target - Pixel{kJointMark, kJointMark}, target + Pixel{kJointMark, kJointMark});
        line(target - Pixel{kJointMark, -kJointMark}, target + Pixel{kJointMark, -kJointMark});
    }

private:
    struct Anchors {
        Pixel a, b; // pixels
    };

    /// The anchors, with thin lines from the centres of the dynamic bodies.
    Anchors arms(const kodo::JointEnds& ends) const {
        const auto arm = [&](kodo::BodyId id, kodo::Vec2 anchor) {
            const kodo::BodyView body = world_[id];
            const Pixel place = camera_.toPixels(body.transform() * anchor);
            if (body.type() == kodo::BodyType::Dynamic) {
                painter_.line(camera_.toPixels(body.center()), place, kArmWidth, kArmColor);
            }
            return place;
        };
        return {arm(ends.a, ends.anchorA), arm(ends.b, ends.anchorB)};
    }

    void line(Pixel from, Pixel to) const { painter_.line(from, to, kJointWidth, kJointColor); }

    void dot(Pixel place) const { painter_.disc(place, kJointMark / 2, kJointColor, kJointColor); }

    void zigzag(Pixel from, Pixel to) const {
        constexpr int kTeeth = 12;
        const Pixel side = turned(scaled(to - from, kJointMark));
        Pixel last = from;
        for (int i = 0; i < kTeeth; ++i) {
            const float share = (static_cast<float>(i) + 0.5f) / kTeeth;
            const Pixel next = from + share * (to - from) + (i % 2 == 0 ? 1.0f : -1.0f) * side;
            line(last, next);
            last = next;
        }
        line(last, to);
    }

    Painter& painter_;
    const Camera& camera_;
    const kodo::World& world_;
};

} // namespace

void paintJoint(Painter& painter, const Camera& camera, const kodo::World& world,
                const kodo::JointDef& joint) {
    std::visit(JointPainter(painter, camera, world), joint);
}

} // namespace kodo_sfml
