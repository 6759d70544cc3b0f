// SPDX-License-Identifier: MIT
#include "contacts/one_way.hpp"

#include "base/vector_reuse.hpp"

#include <algorithm>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// True for a one-sided segment without neighbours. Chains and heightmaps are ground: a body that
/// is partly below it must not fall through, so the side is determined for each part there.
bool isLedge(const ConvexShape& shape) {
    return shape.oneSided && shape.before == Vec2{} && shape.after == Vec2{};
}

/// A contact as seen from its one-sided line.
struct Sides {
    std::uint32_t line; // body
    std::uint16_t linePart;
    std::uint32_t other; // body
    std::uint16_t otherPart;
};

Sides sidesOf(const Bodies& bodies, const ContactKey& key) {
    if (isLedge(bodies.convex(key.bodyA, key.partA))) {
        return {key.bodyA, key.partA, key.bodyB, key.partB};
    }
    return {key.bodyB, key.partB, key.bodyA, key.partA};
}

/// True if the middle of another part of the body is behind the line, between its ends.
bool anyOtherBehind(const Bodies& bodies, const Sides& sides) {
    const ConvexShape& line = bodies.convex(sides.line, sides.linePart);
    const Vec2 along = -perp(line.normals[1]);
    const Transform toLine = between(bodies.pose[sides.line], bodies.pose[sides.other]);
    const std::size_t parts = bodies.geometry(sides.other).parts.size();
    for (std::size_t part = 0; part < parts; ++part) {
        if (part == sides.otherPart) {
            continue;
        }
        const Vec2 middle = toLine * bodies.convex(sides.other, part).middle;
        if (dot(line.normals[1], middle - line.vertices[0]) < 0 &&
            dot(along, middle - line.vertices[0]) >= 0 &&
            dot(along, middle - line.vertices[1]) <= 0) {
            return true;
        }
    }
    return false;
}

bool samePair(const ContactKey& a, const ContactKey& b) {
    return a.bodyA == b.bodyA && a.bodyB == b.bodyB;
}

} // namespace

void OneWayBodies::link(const Bodies& bodies, std::span<const Contact> contacts,
                        std::span<const ContactSummary> summaries) {
    slots_.clear();
    for (std::uint32_t slot = 0; slot < summaries.size(); ++slot) {
        const ContactSummary& summary = summaries[slot];
        const auto mayBeLine = [&](std::uint32_t body) {
            return !(bodies.extent[body].coreRadius > 0);
        };
        const auto isCompound = [&](std::uint32_t body) {
            return bodies.geometry(body).parts.size() > 1;
        };
        if (summary.sensor || summary.gone ||
            !(mayBeLine(summary.bodyA) || mayBeLine(summary.bodyB)) ||
            !(isCompound(summary.bodyA) || isCompound(summary.bodyB))) {
            continue;
        }
        const ContactKey& key = contacts[slot].key;
        const bool lineA = isLedge(bodies.convex(key.bodyA, key.partA));
        const bool lineB = isLedge(bodies.convex(key.bodyB, key.partB));
        if (lineA != lineB && isCompound(lineA ? key.bodyB : key.bodyA)) {
            reserveReusing(slots_, summaries.size());
            slots_.push_back(slot);
        }
    }
    const auto order = [&](std::uint32_t slot) {
        const ContactKey& key = contacts[slot].key;
        return std::tuple(key.bodyA, key.bodyB, key.partA, key.partB);
    };
    std::sort(slots_.begin(), slots_.end(), // total order: keys are unique
              [&](std::uint32_t a, std::uint32_t b) { return order(a) < order(b); });
}

void OneWayBodies::hide(const HidingStep& step) const {
    const Bodies& bodies = step.bodies;
    for (std::size_t first = 0; first < slots_.size();) {
        std::size_t end = first;
        while (end < slots_.size() &&
               samePair(step.contact(slots_[end]).key, step.contact(slots_[first]).key)) {
            ++end;
        }
        const std::span<const std::uint32_t> own(slots_.data() + first, end - first);
        first = end;
        for (const std::uint32_t slot : own) {
            const Contact& contact = step.contact(slot);
            if (contact.wasTouching || contact.passing || contact.hidden) {
                continue;
            }
            const Sides sides = sidesOf(bodies, contact.key);
            const auto passes = [&](std::uint32_t other) {
                return step.contact(other).passing &&
                       sidesOf(bodies, step.contact(other).key).otherPart != sides.otherPart;
            };
            if (std::any_of(own.begin(), own.end(), passes) || anyOtherBehind(bodies, sides)) {
                step.hide(slot, {});
            }
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
