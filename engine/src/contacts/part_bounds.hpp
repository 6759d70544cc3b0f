// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"
#include "broad/bounds_pair.hpp"
#include "math/octagon.hpp"

#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// m; upper bound of the way of a body's points along one axis, in this step.
inline Real axialWay(const BodyVelocity& motion, Real rotationReach) {
    return std::max(std::abs(motion.deltaPosition.x), std::abs(motion.deltaPosition.y)) +
           rotationReach;
}

/// Bounds of every part of every body: tight ones, and grown ones that stay valid until the next
/// search of its pairs. Parts whose grown bounds have changed are listed.
///
/// Each body has a range of indices. A body with fewer parts than before, or a removed one, keeps
/// its range. A body that outgrows its range gets a new one at the end. So the indices of other
/// parts stay. The indices without a part are unused. Results depend on rank(), not on the indices.
class PartBounds {
public:
    struct Part {
        std::uint32_t body;
        std::uint16_t part;
    };

    const Part& part(std::size_t i) const { return parts_[i]; }
    std::uint32_t indexOf(std::uint32_t body, std::uint16_t part) const {
        return firstPart_[body] + part;
    }
    /// Number of indices, used and unused.
    std::size_t size() const { return parts_.size(); }
    /// Number of indices for which there is room.
    std::size_t capacity() const { return parts_.capacity(); }
    std::size_t usedCount() const { return usedCount_; }
    bool hasUnused() const { return usedCount_ < parts_.size(); }
    bool isUsed(std::size_t i) const { return parts_[i].part < count_[parts_[i].body]; }
    /// True if all indices are in the order of bodies and their parts, which is that of the keys of
    /// contacts.
    bool isInOrder() const { return inOrder_; }
    /// Place of a used index in that order. Not comparable with ranks before the next change.
    std::uint64_t rank(std::uint32_t i) const {
        return inOrder_ ? i : std::uint64_t{parts_[i].body} << 16 | parts_[i].part;
    }
    /// Whether a pair comes before another one in the order of keys.
    bool isBefore(BoundsPair a, BoundsPair b) const {
        if (inOrder_) {
            return a < b;
        }
        return a.first != b.first ? rank(a.first) < rank(b.first) : rank(a.second) < rank(b.second);
    }
    /// Lists the bodies with parts, in order, and returns the number of visits. These are linear in
    /// the number of parts, however many bodies there once were.
    std::size_t listBodies(std::vector<std::uint32_t>& bodies) const;
    /// Index of the first part of a body, and the number of its parts. 0 for an unknown body.
    std::uint32_t firstOf(std::uint32_t body) const {
        return body < firstPart_.size() ? firstPart_[body] : 0;
    }
    std::uint32_t countOf(std::uint32_t body) const {
        return body < count_.size() ? count_[body] : 0;
    }
    /// Number of bodies, with the removed ones.
    std::uint32_t bodyCount() const { return static_cast<std::uint32_t>(count_.size()); }
    /// True for a part of a plane, which has no bounds.
    bool isPlane(std::size_t i) const {
        const Vec2 size = tight_[i].box().extent();
        return isUsed(i) && std::max(size.x, size.y) >= kPlaneExtent;
    }
    /// Bounds of a part at another pose of its body.
    Octagon at(const Bodies& bodies, std::size_t i, const Transform& pose) const;
    const Octagon& tight(std::size_t i) const { return tight_[i]; }
    std::span<const Octagon> grown() const { return grown_; }
    std::span<const std::uint32_t> changed() const { return changed_; }
    std::span<const std::uint8_t> isChanged() const { return isChanged_; }

    /// Numbers the parts after any change of bodies. The bounds are undefined afterwards.
    void number(const Bodies& bodies);
    /// Numbers the parts, computes their bounds, and lists all parts.
    void renew(const Bodies& bodies, const Tolerances& tolerances);
    /// The same if only this body was added, removed or changed: the bounds of the others stay.
    void renew(const Bodies& bodies, const Tolerances& tolerances, std::uint32_t body);
    /// Gives all parts new indices, in order and none unused, once most are unused or this costs
    /// less than further steps that compare so many contacts by rank. Counts a step.
    bool renumberIfDue(std::size_t contacts);
    /// True once after the indices of a body moved to the end.
    bool takeMoved() { return std::exchange(hasMoved_, false); }
    /// Present index of a part, from its index before the last renumbering.
    std::uint32_t indexNow(std::uint32_t before, std::uint32_t body) const {
        return before - firstBefore_[body] + firstPart_[body];
    }
    /// Number of indices that were assigned again and of visits for it, of all calls so far.
    std::uint64_t moves() const { return moves_; }
    /// Lists all parts.
    void listAll();
    /// Lists the parts of one body.
    void listBody(std::uint32_t body);
    /// Before a step of dt: grows bounds that the predicted motion will leave.
    void coverPrediction(const Bodies& bodies, const Tolerances& tolerances, Real dt,
                         WorkerTeam& team);
    /// After the solver: grows bounds that the actual displacement will leave.
    void coverDisplacements(const Bodies& bodies, const Tolerances& tolerances, WorkerTeam& team);
    /// Empties the list of changed parts, after their pairs have been found.
    void clearChanged();
    void visitState(StateStream& stream, const Bodies& bodies);

private:
    static constexpr std::size_t kBodiesPerPiece = 128;

    static constexpr std::uint16_t kNoPart = kMaxParts; // of an index that no body has

    void addRange(std::uint32_t body, std::uint32_t room);
    void resize(std::uint32_t body, std::uint32_t parts);
    void renumber();
    template <typename T>
    void pick(std::vector<T>& list) const;
    void list(std::size_t i, std::vector<std::uint32_t>& changed);
    template <typename Outgrow>
    void listOutgrown(const Bodies& bodies, WorkerTeam& team, Outgrow outgrow);

    std::vector<Part> parts_;
    std::vector<std::uint32_t> firstPart_;   // by body
    std::vector<std::uint32_t> room_;        // by body: length of its range
    std::vector<std::uint32_t> count_;       // by body: its parts
    std::vector<std::uint32_t> firstBefore_; // firstPart_ before the last renumber(), if any part
    std::vector<std::uint32_t> from_;        // scratch: by new index the old one
    std::vector<std::uint32_t> bodies_;      // scratch: bodies with parts
    std::size_t usedCount_ = 0;
    bool inOrder_ = true;
    bool hasMoved_ = false;
    std::uint64_t compared_ = 0; // contacts by rank, since the order was lost
    std::uint64_t moves_ = 0;
    std::vector<Octagon> tight_;
    std::vector<Octagon> grown_;
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint8_t> isChanged_;
    ParallelCollector<std::uint32_t> outgrown_;
};

} // namespace KODO_PRECISION
} // namespace kodo
