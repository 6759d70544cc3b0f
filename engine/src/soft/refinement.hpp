// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "joints/step_input.hpp"

#include <span>
#include <utility>
#include <vector>

#include "lanes/block_bins.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Number of parts of each substep of the soft solver, by island: above 1 where a heavy body
/// presses on a much lighter one, or where forces are very large. The level of a body is the
/// logarithm of that number. Islands here are bodies connected by rows of contacts or by joints in
/// this step, so no other island changes the level of one.
///
/// A contact is a spring as stiff as the lighter of its bodies allows. A body whose acceleration
/// points into the contact compresses it by
///
///   s = m_a a_a (1/m_a + 1/m_b) / omega^2
///
/// and by a quarter of that against a body of infinite mass. Many contacts share the load. Stiffer
/// contacts need shorter substeps. Joints of the island become stiffer with them. A limit of a
/// rope, rod or prismatic joint that a heavy body loads counts like a contact. Pins and their
/// limits count by the load that they carried; see JointSet::Joint::addLoad(). A blow counts from a
/// ratio of masses of 16 on; up to that the passes of a step transmit it.
class Refinement {
public:
    static constexpr std::uint32_t kLevels = BlockBins::kLevels;

    struct Step : StepInput {
        Real hertz;      // of contacts in a whole substep
        Real jointHertz; // likewise, of joints
        Real h;          // s, of a whole substep
    };
    /// Sizes the array by body.
    void makeRoom(const Bodies& bodies) { resizeByBody(levels_, bodies); }
    /// Finds the levels of a step. True if any has changed since the last step.
    bool find(const Step& step);
    /// By body; empty if all are 0.
    std::span<const std::uint8_t> levels() const {
        return refined_.empty() ? std::span<const std::uint8_t>() : levels_;
    }
    std::size_t size() const { return refined_.size(); } // bodies with a level above 0
    /// Contacts that approach by a slop in a whole substep, and slower ones.
    std::span<const std::uint32_t> arriving() const { return arriving_; }
    std::uint32_t levelOf(std::uint32_t body) const { return refined_.empty() ? 0 : levels_[body]; }
    /// Level of a contact or joint. Only a movable body has a level above 0.
    std::uint32_t levelOf(std::uint32_t a, std::uint32_t b) const {
        return std::max(levelOf(a), levelOf(b));
    }

private:
    void findArrivals(const Step& step, Real most);
    void findSeeds(const Step& step, Real most);
    void addSeed(std::uint32_t body, Real excess);
    void spread(const Step& step, std::uint32_t body, std::uint8_t level);

    std::vector<std::uint8_t> levels_;     // by body
    std::vector<std::uint32_t> refined_;   // bodies with a level above 0, in order
    std::vector<std::uint32_t> before_;    // those of the last step
    std::vector<std::uint8_t> levelsThen_; // of before_
    std::vector<std::pair<std::uint8_t, std::uint32_t>> seeds_; // level and body
    std::vector<std::uint32_t> queue_;
    std::vector<std::uint32_t> arriving_; // slots
};

/// For a contact that responds: true once its bodies may touch within the step, so that it needs a
/// row. A contact with restitution gets none before it touches: braking would reduce its rebound.
inline bool needsRow(const Bodies& bodies, const ContactStore& store, std::uint32_t slot,
                     bool restitution, Real slop) {
    const ContactSummary& summary = store.summaries()[slot];
    // A touch wakes a sleeping body, proximity does not.
    if (bodies.anySleeping && (bodies.asleep(summary.bodyA) || bodies.asleep(summary.bodyB))) {
        return false;
    }
    return !(summary.bounces && restitution) || store.separation(slot) <= slop;
}

} // namespace KODO_PRECISION
} // namespace kodo
