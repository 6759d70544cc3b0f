// SPDX-License-Identifier: MIT
#include "contacts/part_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Pose at the end of the displacement of this step.
Transform poseAfter(const Transform& pose, const BodyVelocity& motion) {
    return {pose.position + motion.deltaPosition, turned(pose.rotation, motion.deltaAngle)};
}

} // namespace

void PartBounds::number(const Bodies& bodies) {
    parts_.clear();
    footprints_.clear();
    corners_.clear();
    unusedCorners_ = 0;
    firstPart_.resize(bodies.size() + 1);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        firstPart_[body] = static_cast<std::uint32_t>(parts_.size());
        if (!bodies.ids.aliveAt(body)) {
            continue;
        }
        std::uint16_t number = 0;
        for (const auto& part : bodies.geometry(body).parts) {
            parts_.push_back({static_cast<std::uint32_t>(body), number++});
            addConvex(part.convex);
        }
    }
    firstPart_[bodies.size()] = static_cast<std::uint32_t>(parts_.size());
    tight_.resize(parts_.size());
    grown_.resize(parts_.size());
    isChanged_.assign(parts_.size(), 0);
    changed_.clear();
}

void PartBounds::addConvex(const ConvexShape& convex) {
    footprints_.push_back({});
    setConvex(footprints_.size() - 1, convex);
}

void PartBounds::setConvex(std::size_t i, const ConvexShape& convex) {
    const std::size_t corners = convex.isPlane() ? 0 : convex.vertices.size();
    Footprint& footprint = footprints_[i];
    if (footprint.count != corners) {
        unusedCorners_ += footprint.count;
        footprint.first = static_cast<std::uint32_t>(corners_.size());
        footprint.count = static_cast<std::uint32_t>(corners);
        corners_.resize(corners_.size() + corners);
    }
    footprint.radius = convex.radius;
    for (std::size_t k = 0; k < corners; ++k) {
        corners_[footprint.first + k] = convex.vertices[k];
    }
}

Octagon PartBounds::boundsAt(const Bodies& bodies, std::size_t i, const Transform& pose) const {
    const Footprint& convex = footprints_[i];
    if (convex.count == 0) {
        return Octagon::of(boundsOf(bodies.convex(parts_[i].body, parts_[i].part), pose));
    }
    const Vec2* const corners = &corners_[convex.first];
    if (convex.count == 1) {
        return Octagon::of(pose * corners[0], convex.radius);
    }
    return Octagon::of({corners, convex.count}, pose).grown(convex.radius);
}

void PartBounds::renew(const Bodies& bodies, const Tolerances& tolerances) {
    number(bodies);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        tight_[i] = boundsAt(bodies, i, bodies.pose[parts_[i].body]);
        grown_[i] = tight_[i].grown(tolerances.margin);
    }
    listAll();
}

/// Replaces the parts of bodies whose number of parts has changed by empty ones; keeps the others.
bool PartBounds::renumber(const Bodies& bodies, std::span<const std::uint32_t> changed) {
    const auto partsNow = [&](std::uint32_t body) {
        return bodies.ids.aliveAt(body) ? bodies.geometry(body).parts.size() : 0;
    };
    firstPart_.resize(bodies.size() + 1, static_cast<std::uint32_t>(parts_.size()));
    firstBefore_ = firstPart_;
    replaced_.clear();
    for (const std::uint32_t body : changed) {
        const Replaced parts{firstPart_[body], firstPart_[body + 1], partsNow(body)};
        if (parts.last - parts.first == parts.count) {
            continue;
        }
        replaced_.push_back(parts);
        for (std::size_t i = parts.first; i < parts.last; ++i) {
            unusedCorners_ += footprints_[i].count;
        }
    }
    if (replaced_.empty()) {
        return false;
    }
    replace(parts_);
    replace(tight_);
    replace(grown_);
    replace(isChanged_);
    replace(footprints_);
    firstPart_[0] = 0;
    auto next = changed.begin();
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        std::size_t parts = firstBefore_[body + 1] - firstBefore_[body];
        if (next != changed.end() && *next == body) {
            ++next;
            parts = partsNow(body);
        }
        firstPart_[body + 1] = firstPart_[body] + static_cast<std::uint32_t>(parts);
    }
    changed_.clear();
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        if (isChanged_[i] != 0) {
            changed_.push_back(i);
        }
    }
    return true;
}

/// Replaces the elements of each range in replaced_ by `count` default ones.
template <typename T>
void PartBounds::replace(std::vector<T>& list) const {
    std::vector<T> next;
    next.reserve(list.capacity());
    const auto copy = [&](std::size_t first, std::size_t last) {
        next.insert(next.end(), list.begin() + static_cast<std::ptrdiff_t>(first),
                    list.begin() + static_cast<std::ptrdiff_t>(last));
    };
    std::size_t from = 0;
    for (const Replaced& parts : replaced_) {
        copy(from, parts.first);
        next.resize(next.size() + parts.count);
        from = parts.last;
    }
    copy(from, list.size());
    list = std::move(next);
}

bool PartBounds::renew(const Bodies& bodies, const Tolerances& tolerances,
                       std::span<const std::uint32_t> changed) {
    const bool renumbered = renumber(bodies, changed);
    for (const std::uint32_t body : changed) {
        const std::uint32_t first = firstPart_[body];
        for (std::uint32_t i = first; i < firstPart_[body + 1]; ++i) {
            parts_[i] = {body, static_cast<std::uint16_t>(i - first)};
            setConvex(i, bodies.convex(body, i - first));
            tight_[i] = boundsAt(bodies, i, bodies.pose[body]);
            grown_[i] = tight_[i].grown(tolerances.margin);
            list(i, changed_);
        }
    }
    if (unusedCorners_ > corners_.size() / 2) {
        unusedCorners_ = 0;
        corners_.clear();
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            footprints_[i] = {};
            setConvex(i, bodies.convex(parts_[i].body, parts_[i].part));
        }
    }
    return renumbered;
}

void PartBounds::listBody(std::uint32_t body) {
    for (std::uint32_t i = firstPart_[body]; i < firstPart_[body + 1]; ++i) {
        list(i, changed_);
    }
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

/// Lists the parts of awake bodies for which outgrow(body, i) has set new bounds and returned true.
/// Called from several threads.
template <typename Outgrow>
void PartBounds::listOutgrown(const Bodies& bodies, WorkerTeam& team, Outgrow outgrow) {
    outgrown_.gather(team, bodies.awake.size(), kBodiesPerPiece, changed_,
                     [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& changed) {
                         for (std::size_t k = first; k < last; ++k) {
                             const std::uint32_t body = bodies.awake[k];
                             const std::uint32_t end = firstPart_[body + 1];
                             for (std::uint32_t i = firstPart_[body]; i < end; ++i) {
                                 if (outgrow(body, i)) {
                                     list(i, changed);
                                 }
                             }
                         }
                     });
}

void PartBounds::foresee(const Bodies& bodies, const Tolerances& tolerances, Real dt,
                         WorkerTeam& team) {
    listOutgrown(bodies, team, [&](std::uint32_t body, std::size_t i) {
        const BodyVelocity& motion = bodies.motion[body];
        const Extent& extent = bodies.extent[body];
        const Vec2 ahead = dt * motion.velocity;
        const Real rotationReach = dt * std::abs(motion.angularVelocity) * extent.rotationReach;
        tight_[i] = boundsAt(bodies, i, bodies.pose[body]);
        const Octagon needed =
            unite(tight_[i], tight_[i].moved(ahead)).grown(tolerances.margin + rotationReach);
        if (grown_[i].contains(needed)) {
            return false;
        }
        const Real slack = std::min(tolerances.grown, extent.coreRadius / 8);
        grown_[i] = unite(needed, needed.moved(ahead)).grown(slack);
        return true;
    });
}

void PartBounds::coverDisplacements(const Bodies& bodies, const Tolerances& tolerances,
                                    WorkerTeam& team) {
    listOutgrown(bodies, team, [&](std::uint32_t body, std::size_t i) {
        const BodyVelocity& motion = bodies.motion[body];
        const Real rotationReach = std::abs(motion.deltaAngle) * bodies.extent[body].rotationReach;
        const Real way =
            std::max(std::abs(motion.deltaPosition.x), std::abs(motion.deltaPosition.y)) +
            rotationReach;
        if (way < tolerances.margin / 2) {
            return false; // the bounds are grown by the margin, at least
        }
        if (grown_[i].contains(tight_[i].moved(motion.deltaPosition).grown(rotationReach)) ||
            !isSound(motion, tolerances.unit())) {
            return false; // within the prediction, or about to be frozen
        }
        const Octagon after = boundsAt(bodies, i, poseAfter(bodies.pose[body], motion));
        if (grown_[i].contains(after)) {
            return false;
        }
        grown_[i] = unite(tight_[i], after).grown(tolerances.margin);
        return true;
    });
}

} // namespace KODO_PRECISION
} // namespace kodo
