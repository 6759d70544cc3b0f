// SPDX-License-Identifier: MIT
#include <kodo/contacts/part_bounds.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

/// Bounds of a part moved by the motion of its body within this step.
Aabb boundsAfter(const Convex& convex, const Transform& pose, const Motion& motion) {
    return boundsOf(convex, {pose.position + motion.move, turned(pose.rotation, motion.turn)});
}

} // namespace

void PartBounds::number(const Bodies& bodies) {
    parts_.clear();
    firstPart_.assign(bodies.size(), 0);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        if (!bodies.ids.aliveAt(body)) {
            continue;
        }
        firstPart_[body] = static_cast<std::uint32_t>(parts_.size());
        const std::size_t parts = bodies.form(body).parts.size();
        for (std::size_t part = 0; part < parts; ++part) {
            parts_.push_back({static_cast<std::uint32_t>(body), static_cast<std::uint16_t>(part)});
        }
    }
    tight_.resize(parts_.size());
    grown_.resize(parts_.size());
    isChanged_.assign(parts_.size(), 0);
    changed_.clear();
}

void PartBounds::renew(const Bodies& bodies, const Tolerances& tolerances) {
    number(bodies);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const auto& [body, part] = parts_[i];
        tight_[i] = boundsOf(bodies.form(body).parts[part].convex, bodies.pose[body]);
        grown_[i] = tight_[i].grown(tolerances.margin);
    }
    listAll();
}

void PartBounds::listAll() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        list(i, changed_);
    }
}

void PartBounds::list(std::size_t i, std::vector<std::uint32_t>& changed) {
    if (isChanged_[i] == 0) {
        isChanged_[i] = 1;
        changed.push_back(static_cast<std::uint32_t>(i));
    }
}

void PartBounds::clearChanged() {
    for (const std::uint32_t i : changed_) {
        isChanged_[i] = 0;
    }
    changed_.clear();
}

/// Lists the parts of awake bodies for which outgrow(body, convex, i) is true, since it
/// gave them new bounds; several threads call it at once.
template <typename Outgrow>
void PartBounds::listOutgrown(const Bodies& bodies, Crew& crew, Outgrow outgrow) {
    outgrown_.gather(crew, bodies.awake.size(), kBodiesAPiece, changed_,
                     [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& changed) {
                         for (std::size_t k = first; k < last; ++k) {
                             const std::uint32_t body = bodies.awake[k];
                             std::size_t i = firstPart_[body];
                             for (const auto& part : bodies.form(body).parts) {
                                 if (outgrow(body, part.convex, i)) {
                                     list(i, changed);
                                 }
                                 ++i;
                             }
                         }
                     });
}

void PartBounds::foresee(const Bodies& bodies, const Tolerances& tolerances, Real dt, Crew& crew) {
    listOutgrown(bodies, crew, [&](std::uint32_t body, const Convex& convex, std::size_t i) {
        const Motion& motion = bodies.motion[body];
        const Extent& extent = bodies.extent[body];
        const Vec2 ahead = dt * motion.velocity;
        const Real swing = dt * std::abs(motion.angularVelocity) * extent.reach;
        tight_[i] = boundsOf(convex, bodies.pose[body]);
        const Aabb needed =
            unite(tight_[i], moved(tight_[i], ahead)).grown(tolerances.margin + swing);
        if (grown_[i].contains(needed)) {
            return false;
        }
        const Real slack = std::min(tolerances.grown, extent.inside / 4);
        grown_[i] = unite(needed, moved(needed, ahead)).grown(slack);
        return true;
    });
}

void PartBounds::coverMoves(const Bodies& bodies, const Tolerances& tolerances, Crew& crew) {
    listOutgrown(bodies, crew, [&](std::uint32_t body, const Convex& convex, std::size_t i) {
        const Motion& motion = bodies.motion[body];
        const Real swing = std::abs(motion.turn) * bodies.extent[body].reach;
        const Real way = std::max(std::abs(motion.move.x), std::abs(motion.move.y)) + swing;
        if (way < tolerances.margin / 2) {
            return false; // as most of a pile: the bounds are grown by the margin, at least
        }
        if (grown_[i].contains(moved(tight_[i], motion.move).grown(swing)) ||
            !isSound(motion, tolerances.unit())) {
            return false; // as foreseen; or it is about to be stopped where it is
        }
        const Aabb after = boundsAfter(convex, bodies.pose[body], motion);
        if (grown_[i].contains(after)) {
            return false;
        }
        grown_[i] = unite(tight_[i], after).grown(tolerances.margin);
        return true;
    });
}

} // namespace kodo::inline KODO_PRECISION
