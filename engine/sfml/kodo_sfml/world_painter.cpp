// SPDX-License-Identifier: MIT
#include <kodo_sfml/joint_painter.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kodo_sfml {

namespace {

constexpr float kLineWidth = 1.5f;                    // pixels
constexpr float kPointRadius = 3;                     // pixels
constexpr float kFrontLength = 7;                     // pixels, mark of a one-sided segment
constexpr kodo::Real kNormalLength = kodo::Real(0.2); // m
constexpr std::uint8_t kFilled = 110;                 // opacity, of 255
constexpr std::uint8_t kHollow = 35;                  // opacity of sleeping bodies

const Rgba kLockedColor{110, 118, 130};
const Rgba kContactColor{255, 210, 70};
const Rgba kImpulseColor{255, 90, 90};
const Rgba kBoundsColor{90, 200, 120, 150};

/// Neighbouring ids get clearly different colours.
Rgba colorOf(kodo::BodyId id) {
    static const std::array<Rgba, 6> kColors = {Rgba{86, 156, 214},  Rgba{206, 145, 120},
                                                Rgba{181, 206, 168}, Rgba{197, 134, 192},
                                                Rgba{220, 205, 140}, Rgba{78, 201, 176}};
    return kColors[id.index % kColors.size()];
}

/// Where the surface of a plane is shown, and what lies behind it there.
std::vector<Pixel> halfPlane(const kodo::ConvexShape& plane, const kodo::Transform& frame,
                             const Camera& camera) {
    const kodo::Vec2 normal = frame.rotation * plane.normals[0];
    const kodo::Aabb shown = camera.shown();
    const kodo::Vec2 middle = (shown.lower + shown.upper) / 2;
    const kodo::Real above = dot(normal, middle - frame * plane.vertices[0]) - plane.radius;
    const kodo::Vec2 surface = middle - above * normal;
    const kodo::Real reach = length(shown.upper - shown.lower) + std::abs(above);
    const kodo::Vec2 along = reach * perp(normal);
    const kodo::Vec2 depth = reach * normal;
    return {camera.toPixels(surface - along), camera.toPixels(surface + along),
            camera.toPixels(surface + along - depth), camera.toPixels(surface - along - depth)};
}

/// The arc around a corner, from the normal of the edge before it to that of the edge behind it.
void appendArc(std::vector<Pixel>& corners, const kodo::ConvexShape& convex, std::size_t i,
               const kodo::Transform& frame, const Camera& camera) {
    constexpr float kTurn = 2 * std::numbers::pi_v<float>;
    constexpr float kSides = 24; // of a circle
    const std::size_t count = convex.vertices.size();
    const kodo::Vec2 corner = convex.vertices[i];
    const auto angleOf = [](kodo::Vec2 edge) { return std::atan2(-edge.x, edge.y); };
    float from = 0;
    float sweep = kTurn;
    if (count > 1) {
        const kodo::Vec2 before = corner - convex.vertices[(i + count - 1) % count];
        const kodo::Vec2 after = convex.vertices[(i + 1) % count] - corner;
        from = static_cast<float>(angleOf(before));
        sweep = static_cast<float>(angleOf(after)) - from;
        sweep += sweep < 0 ? kTurn : 0;
    }
    const int steps = std::max(1, static_cast<int>(std::ceil(kSides * sweep / kTurn)));
    for (int k = count > 1 ? 0 : 1; k <= steps; ++k) {
        const float angle = from + sweep * static_cast<float>(k) / static_cast<float>(steps);
        const kodo::Vec2 out{kodo::Real(std::cos(angle)), kodo::Real(std::sin(angle))};
        corners.push_back(camera.toPixels(frame * (corner + convex.radius * out)));
    }
}

void paintPart(Painter& painter, const Camera& camera, const kodo::ConvexShape& convex,
               const kodo::Transform& frame, Rgba edge, Rgba fill) {
    const std::vector<Pixel> corners = outlineOf(convex, frame, camera);
    if (corners.size() == 1) {
        painter.disc(corners[0], kPointRadius, edge, edge);
    } else if (corners.size() == 2) {
        painter.line(corners[0], corners[1], kLineWidth, edge);
    } else {
        painter.polygon(corners, fill);
        painter.outline(corners, kLineWidth, edge);
    }
    if (convex.oneSided) {
        const Pixel middle =
            camera.toPixels(frame * ((convex.vertices[0] + convex.vertices[1]) / 2));
        const kodo::Vec2 front =
            frame.rotation * normalize(perp(convex.vertices[1] - convex.vertices[0]));
        painter.line(middle,
                     middle + kFrontLength *
                                  Pixel(static_cast<float>(front.x), static_cast<float>(-front.y)),
                     kLineWidth, edge);
    }
}

void paintBody(Painter& painter, const Camera& camera, const kodo::BodyView& body) {
    const bool locked = body.type() != kodo::BodyType::Dynamic;
    const Rgba edge = locked ? kLockedColor : colorOf(body.id());
    const bool resting = (body.flags() & kodo::kAsleep) != 0;
    const Rgba fill{edge.r, edge.g, edge.b, resting ? kHollow : kFilled};
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        paintPart(painter, camera, body.part(i).convex, body.massFrame(), edge, fill);
    }
    const kodo::Real area = body.area();
    if (area > 0 && std::isfinite(area)) {
        const kodo::Vec2 center = body.center();
        const kodo::Real spoke = kodo::Real(0.35) * std::sqrt(area);
        painter.line(camera.toPixels(center),
                     camera.toPixels(center + spoke * body.rotation().xAxis()), kLineWidth, edge);
    }
}

void paintBounds(Painter& painter, const Camera& camera, const kodo::Aabb& box) {
    const Pixel lower = camera.toPixels(box.lower);
    const Pixel upper = camera.toPixels(box.upper);
    const std::array<Pixel, 4> corners = {lower, Pixel{upper.x, lower.y}, upper,
                                          Pixel{lower.x, upper.y}};
    painter.outline(corners, 1, kBoundsColor);
}

void paintRecord(Painter& painter, const Camera& camera, const kodo::CollisionRecord& record,
                 const WorldLook& look) {
    if (record.phase == kodo::TouchPhase::End) {
        return;
    }
    const Pixel point = camera.toPixels(record.point);
    if (look.contacts) {
        painter.disc(point, kPointRadius, kContactColor, kContactColor);
        painter.line(point, camera.toPixels(record.point + kNormalLength * record.normal),
                     kLineWidth, kContactColor);
    }
    if (look.impulses) {
        const kodo::Real length = look.metresPerImpulse * record.totalImpulse;
        painter.line(point, camera.toPixels(record.point + length * record.normal), 2 * kLineWidth,
                     kImpulseColor);
    }
}

} // namespace

std::vector<Pixel> outlineOf(const kodo::ConvexShape& convex, const kodo::Transform& massFrame,
                             const Camera& camera) {
    if (convex.isPlane()) {
        return halfPlane(convex, massFrame, camera);
    }
    std::vector<Pixel> corners;
    for (std::size_t i = 0; i < convex.vertices.size(); ++i) {
        if (convex.radius > 0) {
            appendArc(corners, convex, i, massFrame, camera);
        } else {
            corners.push_back(camera.toPixels(massFrame * convex.vertices[i]));
        }
    }
    return corners;
}

void paintWorld(Painter& painter, const Camera& camera, const kodo::World& world,
                const WorldLook& look) {
    for (const kodo::BodyId id : world.bodies()) {
        const kodo::BodyView body = world[id];
        if (look.shapes) {
            paintBody(painter, camera, body);
        }
        if (look.bounds) {
            paintBounds(painter, camera, body.bounds());
        }
    }
    if (look.joints) {
        for (const kodo::JointId id : world.joints()) {
            paintJoint(painter, camera, world, world.joint(id));
        }
    }
    if (look.contacts || look.impulses) {
        for (const kodo::CollisionRecord& record : world.collisions()) {
            paintRecord(painter, camera, record, look);
        }
    }
}

} // namespace kodo_sfml
