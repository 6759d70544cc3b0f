// SPDX-License-Identifier: MIT
#include "contacts/part_bounds.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kFewUnused = 64; // indices; up to so many are kept
// A sort of the bodies with parts costs as much as a visit of so many slots of bodies for each.
constexpr std::size_t kSlots = 16;
// New indices for all parts cost as much as so many comparisons of contacts by rank for each part.
constexpr std::uint64_t kComparisons = 4;
// Largest size of stored bounds relative to the needed ones. A body that was fast for one step
// would otherwise be a candidate for contacts on all of that way, as long as it stays there.
constexpr Real kMostExcess = 16;
constexpr Real kMostPredicted = 4; // at the end of a step

/// True if the size of the stored bounds exceeds `factor` times that of the needed ones.
bool isFarLarger(const Octagon& stored, const Octagon& needed, Real factor) {
    const Vec2 own = stored.box().extent();
    const Vec2 least = needed.box().extent();
    return own.x + own.y > factor * (least.x + least.y);
}

} // namespace

void PartBounds::number(const Bodies& bodies) {
    parts_.clear();
    inOrder_ = true;
    compared_ = 0;
    resizeByBody(firstPart_, bodies);
    resizeByBody(room_, bodies);
    resizeByBody(count_, bodies);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        firstPart_[body] = static_cast<std::uint32_t>(parts_.size());
        const std::size_t parts = bodies.ids.aliveAt(body) ? bodies.geometry(body).parts.size() : 0;
        room_[body] = count_[body] = static_cast<std::uint32_t>(parts);
        for (std::uint16_t part = 0; part < parts; ++part) {
            parts_.push_back({static_cast<std::uint32_t>(body), part});
        }
    }
    usedCount_ = parts_.size();
    const std::size_t room = parts_.capacity(); // so that the next body moves no array
    tight_.reserve(room);
    grown_.reserve(room);
    isChanged_.reserve(room);
    tight_.resize(parts_.size());
    grown_.resize(parts_.size());
    isChanged_.assign(parts_.size(), 0);
    changed_.clear();
}

Octagon PartBounds::at(const Bodies& bodies, std::size_t i, const Transform& pose) const {
    const ConvexShape& convex = bodies.convex(parts_[i].body, parts_[i].part);
    const auto& corners = convex.vertices;
    if (convex.isPlane()) {
        return Octagon::of(boundsOf(convex, pose));
    }
    if (corners.size() == 1) {
        return Octagon::of(pose * corners[0], convex.radius);
    }
    return Octagon::of(corners, pose).grown(convex.radius);
}

void PartBounds::renew(const Bodies& bodies, const Tolerances& tolerances) {
    number(bodies);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        tight_[i] = at(bodies, i, bodies.pose[parts_[i].body]);
        grown_[i] = tight_[i].grown(tolerances.margin);
    }
    listAll();
}

/// Gives a body new indices at the end.
void PartBounds::addRange(std::uint32_t body, std::uint32_t room) {
    firstPart_[body] = static_cast<std::uint32_t>(parts_.size());
    room_[body] = room;
    for (std::uint32_t part = 0; part < room; ++part) {
        parts_.push_back({body, static_cast<std::uint16_t>(part)});
    }
    tight_.resize(parts_.size());
    grown_.resize(parts_.size());
    isChanged_.resize(parts_.size(), 0);
}

/// Changes the number of parts of a body. If its range is too small, it gets one of twice the
/// length at the end.
void PartBounds::resize(std::uint32_t body, std::uint32_t parts) {
    const std::uint32_t first = firstPart_[body];
    const std::uint32_t room = room_[body];
    const bool fits = parts <= room;
    count_[body] = parts;
    if (fits) {
        return;
    }
    for (std::uint32_t i = first; i < first + room; ++i) {
        parts_[i].part = kNoPart;
    }
    addRange(body, std::max(parts, std::min(2 * room, std::uint32_t{kMaxParts})));
    if (room > 0 || body + 1 < count_.size()) { // not that of a new body
        moves_ += room_[body];
        inOrder_ = false;
        hasMoved_ = true;
    }
}

bool PartBounds::renumberIfDue(std::size_t contacts) {
    compared_ += inOrder_ ? 0 : contacts + 1;
    const std::size_t unused = parts_.size() - usedCount_;
    const bool mostUnused = unused > kFewUnused && unused > usedCount_;
    if (!mostUnused && compared_ <= kComparisons * parts_.size()) {
        return false;
    }
    renumber();
    return true;
}

std::size_t PartBounds::listBodies(std::vector<std::uint32_t>& bodies) const {
    bodies.clear();
    if (count_.size() <= kSlots * parts_.size()) {
        for (std::uint32_t body = 0; body < count_.size(); ++body) {
            if (count_[body] > 0) {
                bodies.push_back(body);
            }
        }
        return count_.size();
    }
    for (const Part& part : parts_) {
        if (part.part == 0 && count_[part.body] > 0) {
            bodies.push_back(part.body);
        }
    }
    if (!inOrder_) {
        std::sort(bodies.begin(), bodies.end()); // total order: bodies are unique
    }
    return parts_.size();
}

/// Gives each body the range that it needs, in order.
void PartBounds::renumber() {
    moves_ += listBodies(bodies_);
    for (const Part& part : parts_) {
        if (part.part == 0) {
            room_[part.body] = count_[part.body];
        }
    }
    firstBefore_.resize(firstPart_.size());
    parts_.clear();
    from_.clear();
    for (const std::uint32_t body : bodies_) {
        const std::uint32_t before = firstBefore_[body] = firstPart_[body];
        firstPart_[body] = static_cast<std::uint32_t>(from_.size());
        for (std::uint32_t k = 0; k < count_[body]; ++k) {
            parts_.push_back({body, static_cast<std::uint16_t>(k)});
            from_.push_back(before + k);
        }
    }
    inOrder_ = true;
    compared_ = 0;
    moves_ += from_.size();
    pick(tight_);
    pick(grown_);
    pick(isChanged_);
    changed_.clear();
    for (std::uint32_t i = 0; i < isChanged_.size(); ++i) {
        if (isChanged_[i] != 0) {
            changed_.push_back(i);
        }
    }
}

/// Moves the elements of a list to their new indices. Keeps room for as many again.
template <typename T>
void PartBounds::pick(std::vector<T>& list) const {
    std::vector<T> next;
    next.reserve(std::max(std::min(list.capacity(), 2 * from_.size() + kFewUnused), from_.size()));
    for (const std::uint32_t i : from_) {
        next.push_back(list[i]);
    }
    list = std::move(next);
}

void PartBounds::renew(const Bodies& bodies, const Tolerances& tolerances, std::uint32_t body) {
    const bool alive = body < bodies.size() && bodies.ids.aliveAt(body);
    const auto parts =
        alive ? static_cast<std::uint32_t>(bodies.geometry(body).parts.size()) : std::uint32_t{0};
    if (body >= count_.size()) {
        firstPart_.resize(body + std::size_t{1}, 0);
        room_.resize(body + std::size_t{1}, 0);
        count_.resize(body + std::size_t{1}, 0);
    }
    usedCount_ += parts;
    usedCount_ -= count_[body];
    resize(body, parts);
    const std::uint32_t first = firstPart_[body];
    for (std::uint32_t i = first; i < first + parts; ++i) {
        tight_[i] = at(bodies, i, bodies.pose[body]);
        grown_[i] = tight_[i].grown(tolerances.margin);
        list(i, changed_);
    }
}

void PartBounds::listBody(std::uint32_t body) {
    for (std::uint32_t i = firstPart_[body]; i < firstPart_[body] + count_[body]; ++i) {
        list(i, changed_);
    }
}

void PartBounds::listAll() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (isUsed(i)) {
            list(i, changed_);
        }
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
                             const std::uint32_t end = firstPart_[body] + count_[body];
                             for (std::uint32_t i = firstPart_[body]; i < end; ++i) {
                                 if (outgrow(body, i)) {
                                     list(i, changed);
                                 }
                             }
                         }
                     });
}

void PartBounds::coverPrediction(const Bodies& bodies, const Tolerances& tolerances, Real dt,
                                 WorkerTeam& team) {
    listOutgrown(bodies, team, [&](std::uint32_t body, std::size_t i) {
        const BodyVelocity& motion = bodies.motion[body];
        const Extent& extent = bodies.extent[body];
        const Vec2 ahead = dt * motion.velocity;
        const Real rotationReach = extent.reachOfTurn(dt * motion.angularVelocity);
        tight_[i] = at(bodies, i, bodies.pose[body]);
        const Octagon needed =
            unite(tight_[i], tight_[i].moved(ahead)).grown(tolerances.margin + rotationReach);
        if (grown_[i].contains(needed) && !isFarLarger(grown_[i], needed, kMostExcess)) {
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
        const Real rotationReach = bodies.extent[body].reachOfTurn(motion.deltaAngle);
        if (axialWay(motion, rotationReach) < tolerances.margin / 2) {
            return false; // the bounds are grown by the margin, at least
        }
        if (grown_[i].contains(tight_[i].moved(motion.deltaPosition).grown(rotationReach)) ||
            !isSound(motion, tolerances.unit())) {
            return false; // within the prediction, or about to be frozen
        }
        const Octagon after = at(bodies, i, bodies.endPose(body));
        if (grown_[i].contains(after)) {
            return false;
        }
        // With the prediction, so that a pair that has just collided keeps its contact and record.
        const Octagon needed = unite(tight_[i], after).grown(tolerances.margin);
        const bool far = isFarLarger(grown_[i], needed, kMostPredicted);
        grown_[i] = far ? needed : unite(needed, grown_[i]);
        return true;
    });
}

} // namespace KODO_PRECISION
} // namespace kodo
