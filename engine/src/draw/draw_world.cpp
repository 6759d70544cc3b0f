// SPDX-License-Identifier: MIT
#include <kodo/debug_draw.hpp>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

namespace {

constexpr std::uint8_t kFilled = 110; // opacity, of 255
constexpr std::uint8_t kFaint = 35;   // opacity of sleeping bodies
constexpr DrawColor kClear{0, 0, 0, 0};
constexpr DrawStyle kContact{{255, 210, 70}};
constexpr DrawStyle kImpulse{{255, 90, 90}, kClear, 2};
constexpr DrawStyle kBounds{{90, 200, 120, 150}, kClear, 1};
constexpr DrawStyle kVelocity{{130, 230, 130}};
constexpr DrawStyle kNote{{235, 235, 235}};
constexpr DrawStyle kJoint{{120, 220, 230}, kClear, 2};
constexpr DrawStyle kArm{{120, 220, 230, 110}, kClear, 1};

/// Neighbouring numbers get clearly different colours.
DrawColor colorOf(std::uint32_t number) {
    static constexpr std::array<DrawColor, 6> kColors = {{{86, 156, 214},
                                                          {206, 145, 120},
                                                          {181, 206, 168},
                                                          {197, 134, 192},
                                                          {220, 205, 140},
                                                          {78, 201, 176}}};
    return kColors[number % kColors.size()];
}

Real markOf(const DebugDraw& target) { // m, half the size of a mark
    return 5 * target.pixel();
}

void drawCross(Vec2 place, DebugDraw& target, const DrawStyle& style) {
    const Vec2 half{markOf(target), markOf(target)};
    target.line(place - half, place + half, style);
    target.line(place - perp(half), place + perp(half), style);
}

/// Draws each kind of joint; a kind without a function does not compile.
class JointDrawing {
public:
    JointDrawing(const World& world, DebugDraw& target) : world_(world), target_(target) {}

    void operator()(const RevoluteJoint& joint) const {
        target_.circle(connect(joint.ends).b, markOf(target_), kJoint);
    }

    void operator()(const FixedJoint& joint) const {
        const Vec2 b = connect(joint.ends).b;
        const Vec2 half{markOf(target_), markOf(target_)};
        target_.polygon(std::array{b - half, b - perp(half), b + half, b + perp(half)}, kJoint);
    }

    void operator()(const DistanceJoint& joint) const {
        const Anchors anchors = joint.hertz > 0 ? arms(joint.ends) : connect(joint.ends);
        if (joint.hertz > 0) {
            target_.spring(anchors.a, anchors.b, kJoint);
        }
        target_.point(anchors.a, kJoint);
        target_.point(anchors.b, kJoint);
    }

    void operator()(const PrismaticJoint& joint) const {
        target_.point(arms(joint.ends).b, kJoint);
        slider(joint);
    }

    void operator()(const WheelJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        slider(joint);
        if (joint.hertz > 0) {
            target_.spring(a, b, kJoint);
        }
        target_.circle(b, markOf(target_), kJoint);
    }

    void operator()(const PulleyJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        target_.line(a, joint.groundA, kJoint);
        target_.line(joint.groundA, joint.groundB, kJoint);
        target_.line(joint.groundB, b, kJoint);
        target_.circle(joint.groundA, markOf(target_), kJoint);
        target_.circle(joint.groundB, markOf(target_), kJoint);
    }

    void operator()(const GearJoint& joint) const {
        const auto [a, b] = connect(joint.ends);
        target_.circle(b, 2 * markOf(target_), kJoint);
        if (!joint.rack) {
            target_.circle(a, 2 * markOf(target_), kJoint);
        }
    }

    void operator()(const FilterJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        target_.line(a, b, kArm);
    }

    void operator()(const MotorJoint& joint) const {
        const auto [a, b] = arms(joint.ends);
        target_.point(b, kJoint);
        target_.arrow(b, a, kJoint);
        target_.circle(a, markOf(target_), kArm);
    }

    void operator()(const MouseJoint& joint) const {
        const Vec2 grip = world_[joint.body].transform() * joint.anchor;
        target_.point(grip, kJoint);
        target_.line(grip, joint.target, kJoint);
        drawCross(joint.target, target_, kJoint);
    }

private:
    struct Anchors {
        Vec2 a, b; // m, world
    };

    /// The anchors, with thin lines from the centres of the dynamic bodies.
    Anchors arms(const JointEnds& ends) const {
        const auto arm = [&](BodyId id, Vec2 anchor) {
            const BodyView body = world_[id];
            const Vec2 place = body.transform() * anchor;
            if (body.type() == BodyType::Dynamic) {
                target_.line(body.center(), place, kArm);
            }
            return place;
        };
        return {arm(ends.a, ends.anchorA), arm(ends.b, ends.anchorB)};
    }

    /// The line of a slider or an axle, with bars at its limits.
    template <typename Joint>
    void slider(const Joint& joint) const {
        const Transform frame = world_[joint.ends.a].transform();
        const Real shown = world_.tolerances().unit() / 2; // of an axis without limits
        const Range range = joint.limits.value_or(Range{-shown, shown});
        const Vec2 lower = frame * (joint.ends.anchorA + range.lower * joint.axis);
        const Vec2 upper = frame * (joint.ends.anchorA + range.upper * joint.axis);
        target_.line(lower, upper, kJoint);
        if (joint.limits) {
            const Vec2 bar = 2 * markOf(target_) * perp(frame.rotation * joint.axis);
            target_.line(lower - bar, lower + bar, kJoint);
            target_.line(upper - bar, upper + bar, kJoint);
        }
    }

    /// The anchors, with a line between them.
    Anchors connect(const JointEnds& ends) const {
        const Anchors anchors = arms(ends);
        target_.line(anchors.a, anchors.b, kJoint);
        return anchors;
    }

    const World& world_;
    DebugDraw& target_;
};

/// For the index of each body, the lowest index in its island: dynamic bodies that contacts and
/// joints connect.
std::vector<std::uint32_t> islandsOf(const World& world, std::span<const BodyId> bodies) {
    std::vector<std::uint32_t> lower(bodies.empty() ? 0 : bodies.back().index + 1);
    std::iota(lower.begin(), lower.end(), 0u);
    const auto firstOf = [&](BodyId id) {
        std::uint32_t index = id.index;
        while (lower[index] != index) {
            index = lower[index] = lower[lower[index]]; // halves the path for the next call
        }
        return index;
    };
    const auto isMoved = [&](BodyId id) {
        return world.contains(id) && world[id].type() == BodyType::Dynamic;
    };
    const auto isSensor = [&](BodyId id, std::size_t part) {
        return world.contains(id) && part < world[id].partCount() &&
               (world[id].filter(part).flags & kSensor) != 0;
    };
    const auto connect = [&](BodyId a, BodyId b) {
        if (isMoved(a) && isMoved(b)) {
            const auto [first, second] = std::minmax({firstOf(a), firstOf(b)});
            lower[second] = first;
        }
    };
    for (const CollisionRecord& record : world.collisions()) {
        if (record.phase != TouchPhase::End && !isSensor(record.a, record.partA) &&
            !isSensor(record.b, record.partB)) {
            connect(record.a, record.b);
        }
    }
    for (const JointId id : world.joints()) {
        connect(firstBody(world.joint(id)), secondBody(world.joint(id)));
    }
    for (const BodyId id : bodies) {
        lower[id.index] = firstOf(id);
    }
    return lower;
}

/// `island`: index of the first body of its island, or its own.
DrawStyle styleOf(const BodyView& body, std::uint32_t island) {
    DrawStyle style{colorOf(island)};
    if (body.type() != BodyType::Dynamic) {
        const bool still = body.type() == BodyType::Static;
        style.line = still ? DrawColor{110, 118, 130} : DrawColor{150, 135, 235};
    }
    if ((body.flags() & kFrozen) != 0) {
        style.line = {255, 60, 60};
    }
    if ((body.flags() & (kDisabled | kOutside)) != 0) {
        style.line.a = kFaint;
    } else if ((body.flags() & kSensor) == 0) {
        style.fill = style.line;
        style.fill.a = body.isAsleep() ? kFaint : kFilled;
    }
    return style;
}

void drawShapes(const BodyView& body, DrawStyle style, DebugDraw& target) {
    target.begin(body, style);
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const ConvexShape& shape = body.part(i).convex;
        if (overlap(boundsOf(shape, body.massFrame()), target.view())) {
            DrawStyle own = style;
            if ((body.filter(i).flags & kSensor) != 0) {
                own.fill.a = 0; // hollow
            }
            draw(shape, body.massFrame(), target, own);
        }
    }
    if (body.area() > 0 && std::isfinite(body.area())) {
        const Vec2 spoke = Real(0.35) * std::sqrt(body.area()) * body.rotation().xAxis();
        target.line(body.center(), body.center() + spoke, style);
    }
}

/// What options ask for beside the shapes.
void drawNotes(const BodyView& body, DebugDraw& target, const DrawOptions& options) {
    if (options.bounds) {
        const auto [lower, upper] = body.bounds();
        target.polygon(std::array{lower, Vec2{upper.x, lower.y}, upper, Vec2{lower.x, upper.y}},
                       kBounds);
    }
    const Vec2 center = body.center();
    if (options.velocities && body.velocity() != Vec2{}) {
        target.arrow(center, center + options.secondsOfVelocity * body.velocity(), kVelocity);
    }
    if (options.centers && body.type() == BodyType::Dynamic) {
        drawCross(center, target, kNote);
    }
    if (options.labels) {
        target.text(center, target.label(body), kNote);
    }
}

void drawRecord(const CollisionRecord& record, Real normalLength, DebugDraw& target,
                const DrawOptions& options) {
    for (std::size_t i = 0; options.contacts && i < record.pointCount; ++i) {
        const Vec2 place = record.points[i].position;
        target.point(place, kContact);
        target.line(place, place + normalLength * record.normal, kContact);
    }
    if (options.impulses && record.totalImpulse > 0) {
        const Real length = options.metresPerImpulse * record.totalImpulse;
        target.arrow(record.point, record.point + length * record.normal, kImpulse);
    }
}

} // namespace

void draw(const World& world, DebugDraw& target, const DrawOptions& options) {
    const std::vector<BodyId> bodies = world.bodies();
    std::vector<std::uint32_t> islands;
    if (options.islands) {
        islands = islandsOf(world, bodies);
    }
    for (const BodyId id : bodies) {
        const BodyView body = world[id];
        if (!overlap(body.bounds(), target.view())) {
            continue;
        }
        if (options.shapes) {
            drawShapes(body, styleOf(body, islands.empty() ? id.index : islands[id.index]), target);
        }
        drawNotes(body, target, options);
    }
    for (const JointId id : options.joints ? world.joints() : std::vector<JointId>{}) {
        std::visit(JointDrawing(world, target), world.joint(id));
    }
    if (options.contacts || options.impulses) {
        for (const CollisionRecord& record : world.collisions()) {
            drawRecord(record, world.tolerances().unit() / 5, target, options);
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
