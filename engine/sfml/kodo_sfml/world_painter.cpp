// SPDX-License-Identifier: MIT
#include <kodo_sfml/world_painter.hpp>

#include <kodo_draw/circle.hpp>

#include <array>
#include <cmath>

namespace kodo_sfml {

namespace {

constexpr float kLineWidth = 1.5f;                    // pixels
constexpr float kPointRadius = 3;                     // pixels
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

void paintBody(Painter& painter, const Camera& camera, const kodo::BodyView& body) {
    const bool locked = body.type() != kodo::BodyType::Dynamic;
    const Rgba edge = locked ? kLockedColor : colorOf(body.id());
    const bool resting = (body.flags() & kodo::kAsleep) != 0;
    const Rgba fill{edge.r, edge.g, edge.b, resting ? kHollow : kFilled};
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const std::vector<Pixel> corners = cornersOf(body.part(i).convex, body.massFrame(), camera);
        painter.polygon(corners, fill);
        painter.outline(corners, kLineWidth, edge);
    }
    const kodo::Vec2 center = body.center();
    const kodo::Real spoke = kodo::Real(0.35) * std::sqrt(body.area());
    painter.line(camera.toPixels(center), camera.toPixels(center + spoke * body.rotation().xAxis()),
                 kLineWidth, edge);
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

std::vector<Pixel> cornersOf(const kodo::ConvexShape& convex, const kodo::Transform& massFrame,
                             const Camera& camera) {
    std::vector<Pixel> corners;
    if (!convex.isRound()) {
        for (const kodo::Vec2 vertex : convex.vertices) {
            corners.push_back(camera.toPixels(massFrame * vertex));
        }
        return corners;
    }
    constexpr int kSides = 24;
    const Pixel center = camera.toPixels(massFrame * convex.vertices[0]);
    const float radius = camera.toPixels(convex.radius);
    for (int i = 0; i < kSides; ++i) {
        corners.push_back(kodo_draw::onCircle(center, radius, i, kSides));
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
    if (look.contacts || look.impulses) {
        for (const kodo::CollisionRecord& record : world.collisions()) {
            paintRecord(painter, camera, record, look);
        }
    }
}

} // namespace kodo_sfml
