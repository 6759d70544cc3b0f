// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/effects/cracks.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Real kStep = Real(0.16);    // m, length of a segment
constexpr Real kWidest = Real(0.055); // m, at the impact
constexpr Real kBend = Real(0.55);    // rad, maximum between two segments

/// Share of the segment from a to b that lies inside a convex shape; a lies inside.
Real insideShare(const kodo::ConvexShape& outline, Vec2 a, Vec2 b) {
    Real share = 1;
    for (std::size_t i = 0; i < outline.normals.size(); ++i) {
        const Real here = dot(outline.normals[i], outline.vertices[i] - a);
        const Real way = dot(outline.normals[i], b - a);
        if (way > here && way > 0) {
            share = std::min(share, std::max(here / way, Real(0)));
        }
    }
    return share;
}

/// Projects a point into the convex shape: recorded contact points may lie slightly outside.
Vec2 pulledInside(const kodo::ConvexShape& outline, Vec2 point) {
    for (std::size_t i = 0; i < outline.normals.size(); ++i) {
        const Real out = dot(outline.normals[i], point - outline.vertices[i]);
        if (out > 0) {
            point += -out * outline.normals[i];
        }
    }
    return point;
}

struct Branch {
    Vec2 start;
    Real angle = 0;
    Real length = 0;
    Real width = 0;
};

void growBranch(const kodo::ConvexShape& outline, const Branch& branch, Dice& dice,
                std::vector<CrackLine>& lines) {
    Vec2 here = branch.start;
    Real angle = branch.angle;
    for (Real done = 0; done < branch.length; done += kStep) {
        const Vec2 there = here + kStep * towards(angle);
        const Real share = insideShare(outline, here, there);
        const Vec2 end = here + share * (there - here);
        const Real width = branch.width * (1 - Real(0.8) * done / branch.length);
        lines.push_back({here, end, width});
        if (share < 1) {
            return; // reached the boundary
        }
        here = end;
        angle += dice.between(-kBend, kBend);
    }
}

} // namespace

std::vector<CrackLine> growCracks(const kodo::ConvexShape& outline, Vec2 point, Real damage,
                                  std::uint32_t seed) {
    std::vector<CrackLine> lines;
    if (outline.isRound() || outline.vertices.empty()) {
        return lines;
    }
    Dice dice(seed);
    const Vec2 size = kodo::aabbOf(std::span<const Vec2>(outline.vertices)).extent();
    const Real share = std::clamp(damage, Real(0.1), Real(1));
    const Vec2 start = pulledInside(outline, point);
    const Vec2 inwards = outline.middle - start;
    const Real middle = std::atan2(inwards.y, inwards.x);
    const int branches = 3 + static_cast<int>(4 * share);
    for (int i = 0; i < branches; ++i) {
        const Real place = (static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(branches);
        const Real fan = (place - Real(0.5)) * Real(0.5) * kTurn;
        growBranch(outline,
                   {start, middle + fan + dice.between(Real(-0.25), Real(0.25)),
                    Real(0.5) * length(size) * share * dice.between(Real(0.5), Real(1.2)),
                    kWidest * (Real(0.5) + Real(0.5) * share)},
                   dice, lines);
    }
    for (CrackLine& line : lines) {
        line.from -= outline.middle;
        line.to -= outline.middle;
    }
    return lines;
}

void Cracks::add(std::uint32_t block, const kodo::ConvexShape& outline, Vec2 point, Real damage) {
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& e) { return e.block == block; });
    if (entry == entries_.end()) {
        entries_.push_back({block, {}});
        entry = entries_.end() - 1;
    }
    const auto seed = static_cast<std::uint32_t>(block * 97u + entry->lines.size());
    const std::vector<CrackLine> grown = growCracks(outline, point, damage, seed);
    entry->lines.insert(entry->lines.end(), grown.begin(), grown.end());
}

void Cracks::forget(std::uint32_t block) {
    std::erase_if(entries_, [&](const Entry& e) { return e.block == block; });
}

std::span<const CrackLine> Cracks::of(std::uint32_t block) const {
    for (const Entry& entry : entries_) {
        if (entry.block == block) {
            return entry.lines;
        }
    }
    return {};
}

} // namespace apart
