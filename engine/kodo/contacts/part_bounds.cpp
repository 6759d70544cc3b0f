// SPDX-License-Identifier: MIT
#include <kodo/contacts/part_bounds.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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
    grew_.assign(parts_.size(), 0);
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
        list(i);
    }
}

void PartBounds::list(std::size_t i) {
    if (isChanged_[i] == 0) {
        isChanged_[i] = 1;
        changed_.push_back(static_cast<std::uint32_t>(i));
    }
}

void PartBounds::clearChanged() {
    for (const std::uint32_t i : changed_) {
        isChanged_[i] = 0;
    }
    changed_.clear();
}

/// Gives new bounds to those parts of awake bodies for which outgrown(body, convex, i) tells some;
/// several threads call it at once.
template <typename Outgrown>
void PartBounds::outgrow(const Bodies& bodies, Crew& crew, Outgrown outgrown) {
    std::uint8_t any = 0;
    crew.forEach(bodies.awake.size(), kBodiesAPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const std::uint32_t body = bodies.awake[k];
            std::size_t i = firstPart_[body];
            for (const auto& part : bodies.form(body).parts) {
                if (const std::optional<Aabb> bounds = outgrown(body, part.convex, i)) {
                    grown_[i] = *bounds;
                    grew_[i] = 1;
                    Crew::mark(any);
                }
                ++i;
            }
        }
    });
    if (any == 0) {
        return;
    }
    for (const std::uint32_t body : bodies.awake) {
        for (std::size_t i = firstPart_[body]; i < parts_.size() && parts_[i].body == body; ++i) {
            if (std::exchange(grew_[i], std::uint8_t{0}) != 0) {
                list(i);
            }
        }
    }
}

void PartBounds::foresee(const Bodies& bodies, const Tolerances& tolerances, Real dt, Crew& crew) {
    outgrow(bodies, crew,
            [&](std::uint32_t body, const Convex& convex, std::size_t i) -> std::optional<Aabb> {
                const Motion& motion = bodies.motion[body];
                const Extent& extent = bodies.extent[body];
                const Vec2 ahead = dt * motion.velocity;
                const Real swing = dt * std::abs(motion.angularVelocity) * extent.reach;
                tight_[i] = boundsOf(convex, bodies.pose[body]);
                const Aabb needed =
                    unite(tight_[i], moved(tight_[i], ahead)).grown(tolerances.margin + swing);
                if (grown_[i].contains(needed)) {
                    return std::nullopt;
                }
                const Real slack = std::min(tolerances.grown, extent.inside / 4);
                return unite(needed, moved(needed, ahead)).grown(slack);
            });
}

void PartBounds::coverMoves(const Bodies& bodies, const Tolerances& tolerances, Crew& crew) {
    outgrow(bodies, crew,
            [&](std::uint32_t body, const Convex& convex, std::size_t i) -> std::optional<Aabb> {
                const Motion& motion = bodies.motion[body];
                if (!isSound(motion, tolerances.unit())) {
                    return std::nullopt; // it is about to be stopped where it is
                }
                const Real way =
                    length(motion.move) + std::abs(motion.turn) * bodies.extent[body].reach;
                if (grown_[i].contains(tight_[i].grown(way))) {
                    return std::nullopt;
                }
                const Aabb after = boundsAfter(convex, bodies.pose[body], motion);
                if (grown_[i].contains(after)) {
                    return std::nullopt;
                }
                return unite(tight_[i], after).grown(tolerances.margin);
            });
}

} // namespace kodo::inline KODO_PRECISION
