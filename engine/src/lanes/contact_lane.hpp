// SPDX-License-Identifier: MIT
#pragma once

#include "collide/manifold.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lanes/block_bins.hpp"
#include "lanes/contact.hpp"
#include "lanes/contact_block.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// The lane of a contact: the home of its ContactNumbers. A lane of the passes stores impulses of
/// the parts into which Refinement divides a substep.
class ContactLane {
public:
    explicit ContactLane(ContactBlock& block, std::size_t lane = 0, Real parts = 1)
        : block_(&block), lane_(lane), parts_(parts) {}

    Real& separation(std::size_t point) const { return block_->points[point].separation[lane_]; }
    Real& approachSpeed() const { return block_->approachSpeed[lane_]; }
    Real& relativeDisplacement() const { return block_->relativeDisplacement[lane_]; }
    Real& impact(std::size_t point) const { return block_->impact[point][lane_]; }
    Real& friction() const { return block_->friction[lane_]; }
    Real& rolling() const { return block_->rolling[lane_]; }
    Real& total(std::size_t axis) const { return block_->total[axis][lane_]; }
    /// N s, of a part of a substep.
    Real& impulse(std::size_t point) const { return block_->points[point].impulse[lane_]; }
    Real& largest(std::size_t point) const { return block_->points[point].largest[lane_]; }
    /// Sum of the impacts at both points in this step.
    Real impacts() const { return impact(0) + impact(1); }
    bool sliding() const { return block_->staticFriction[lane_] < 0; }
    void stopSliding() const {
        block_->staticFriction[lane_] = std::abs(block_->staticFriction[lane_]);
    }
    void setSeparations(const Manifold& manifold) const {
        for (std::size_t i = 0; i < 2; ++i) {
            separation(i) = manifold.points[i].separation;
        }
    }
    /// The separations of a manifold that was found earlier are brought up to date.
    void updateSeparations(Manifold& manifold) const {
        for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
            manifold.points[i].separation = separation(i);
        }
    }
    /// The next step finds the manifold again.
    void expire() const { relativeDisplacement() = kExpired; }
    /// True for a manifold that was found within the step, or whose bodies were stopped: its
    /// separations are not those at the start of the step.
    bool expired() const { return relativeDisplacement() >= kExpired; }
    static constexpr Real kExpired = std::numeric_limits<Real>::max() / 4; // m
    /// Removes what warm starts the next step.
    void clearImpulses() const {
        impulse(0) = impulse(1) = 0;
        friction() = rolling() = 0;
    }
    /// Resets the impulses that belong to the record of one step.
    void clearStep() const {
        for (std::size_t i = 0; i < 2; ++i) {
            impact(i) = largest(i) = total(i) = 0;
        }
    }

    ContactNumbers numbers() const {
        ContactNumbers all{.separation = {separation(0), separation(1)},
                           .approachSpeed = approachSpeed(),
                           .relativeDisplacement = relativeDisplacement(),
                           .impulse = {},
                           .friction = parts_ * friction(),
                           .rolling = parts_ * rolling(),
                           .total = {total(0), total(1)},
                           .sliding = sliding()};
        for (std::size_t i = 0; i < 2; ++i) {
            all.impulse[i] = {parts_ * impulse(i), impact(i), parts_ * largest(i)};
        }
        return all;
    }
    /// Moves a contact into this lane.
    void operator=(const ContactNumbers& all) const {
        separation(0) = all.separation[0];
        separation(1) = all.separation[1];
        approachSpeed() = all.approachSpeed;
        relativeDisplacement() = all.relativeDisplacement;
        for (std::size_t i = 0; i < 2; ++i) {
            impulse(i) = all.impulse[i].normal / parts_;
            impact(i) = all.impulse[i].impact;
            largest(i) = all.impulse[i].largest / parts_;
            total(i) = all.total[i];
        }
        friction() = all.friction / parts_;
        rolling() = all.rolling / parts_;
        block_->staticFriction[lane_] = all.sliding ? -1 : 1; // until the lane is filled
    }

private:
    ContactBlock* block_;
    std::size_t lane_;
    Real parts_;
};

/// The lanes of all contacts of a list. A contact in the passes has a row; any other one has a
/// waiting lane, which no pass visits, at the index of its slot.
class ContactLanes {
public:
    ContactLane lane(std::uint32_t slot, const ContactSummary& summary) {
        const std::uint32_t row = summary.row.index;
        return summary.inPasses() ? ContactLane(blocks_[blockOf(row)], laneOf(row),
                                                BlockBins::partsOf(states_[blockOf(row)].bin))
                                  : waiting(slot);
    }
    /// The same, to be read alone.
    ContactLane read(std::uint32_t slot, const ContactSummary& summary) const {
        return const_cast<ContactLanes*>(this)->lane(slot, summary);
    }
    /// m, of all points; of a contact in the passes.
    Real leastSeparation(std::uint32_t row) const {
        const auto& points = blocks_[blockOf(row)].points;
        return leastOf({points[0].separation[laneOf(row)], points[1].separation[laneOf(row)]},
                       BlockBins::pointsOf(states_[blockOf(row)].bin));
    }
    /// m; of a contact in the passes.
    const Real& relativeDisplacement(std::uint32_t row) const {
        return blocks_[blockOf(row)].relativeDisplacement[laneOf(row)];
    }

    /// Coefficients and impulses of a contact in the passes.
    struct Place {
        ContactBlock& block;
        std::size_t lane;
    };
    Place placeOf(std::uint32_t row) { return {blocks_[blockOf(row)], laneOf(row)}; }

    /// Waiting lanes for so many slots. New ones are empty.
    void resize(std::size_t slots) {
        waiting_.resize((slots + ContactBlock::kContacts - 1) / ContactBlock::kContacts);
    }
    ContactLane waiting(std::uint32_t slot) {
        return ContactLane(waiting_[blockOf(slot)], laneOf(slot));
    }
    /// Moves a contact to its waiting lane. On any thread.
    void leave(const ContactEntry& entry) {
        if (entry.summary.inPasses()) {
            const ContactNumbers numbers = lane(entry.slot, entry.summary).numbers();
            entry.summary.row.index = ContactRow::kNone;
            waiting(entry.slot) = numbers;
        }
    }

protected:
    std::vector<ContactBlock> blocks_;
    std::vector<BlockState> states_; // by block

private:
    std::vector<ContactBlock> waiting_;
};

} // namespace KODO_PRECISION
} // namespace kodo
