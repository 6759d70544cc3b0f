// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "joints/step_input.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Finds manifolds again within the step. A blow may turn a body so far that its next corner comes
/// down before the step ends; contact points that were found when the step began do not hold it.
///
/// A picture is wrong by a way of an eighth of the core radius of the body that turned. Before a
/// substep, the contacts of a body are found again at the present poses once its farthest point has
/// moved so far since its last look: along its arc where a further point may come, from its tangent
/// where the manifold has all its points. So are contacts that may gain a point and approach by as
/// much in one substep. The margin of such a manifold covers the way of the substep, since the blow
/// turns what comes next. Impulses stay with their features.
///
/// A contact depends on its own two bodies alone. A disc has one point at any rotation, so two
/// discs need no look. A step without fast bodies costs a comparison per body and substep.
class ManifoldRefresh {
public:
    struct Step : StepInput {
        Real h;                                  // s, of the substep
        std::span<const std::uint32_t> arriving; // Refinement::arriving()
        bool first; // substep: sums but those of impacts are still of the last step
    };
    /// Reserves room for all bodies.
    void makeRoom(const Bodies& bodies) { turning_.reserve(bodies.record.capacity()); }
    /// Before the first substep of a step of dt (s).
    void begin(Real dt) { spin_ = kLeastTurn / dt; }
    /// For each body with its angular velocity (rad/s), in each substep. On any thread.
    void note(Real angularVelocity) {
        if (std::abs(angularVelocity) > spin_) {
            WorkerTeam::mark(anySpins_);
        }
    }
    /// Lists the contacts to be found again before a substep. `list`: the bodies that are solved;
    /// `isSolved(summary)` is true for a contact that may have a row among them.
    template <typename IsSolved>
    std::span<const std::uint32_t> list(const Step& step, std::span<const std::uint32_t> bodies,
                                        IsSolved isSolved) {
        slots_.clear();
        if (step.first) {
            listed_ = false;
            findFast(step);
        }
        findTurned(step, bodies);
        std::erase_if(slots_, [&](std::uint32_t slot) {
            const ContactSummary& summary = step.contactSet.summaries()[slot];
            const Real thicker = std::max(step.bodies.extent[summary.bodyA].coreRadius,
                                          step.bodies.extent[summary.bodyB].coreRadius);
            return thicker < step.tolerances.slop || !isSolved(summary); // thin: no inside
        });
        step.contactSet.store().sortByKey(slots_);
        slots_.erase(std::unique(slots_.begin(), slots_.end()), slots_.end());
        return slots_;
    }
    /// Finds the manifold of a contact that is not in the passes at the present poses. Its
    /// separations become those from which the displacements so far lead to the present ones.
    static void find(const Step& step, std::uint32_t slot);
    /// Applies the impulses of a contact in the passes to its bodies, `times` 1 or -1.
    static void apply(const Step& step, std::uint32_t slot, Real times);

private:
    static constexpr Real kLeastTurn = Real(1) / 64; // rad, in a step
    /// A body of the group that a rotation moves.
    struct Turning {
        std::uint32_t body;
        Real allowed;   // rad, rotation that needs no look
        Real atGaining; // rad, deltaAngle at the last look at contacts that may gain a point
        Real atAll;     // rad, the same for all contacts
    };
    void findTurned(const Step& step, std::span<const std::uint32_t> bodies);
    void findFast(const Step& step);

    std::vector<Turning> turning_;
    bool listed_ = false; // turning_ has the bodies of this group
    std::vector<std::uint32_t> slots_;
    Real spin_ = 0; // rad/s, below which a body cannot turn far enough
    std::uint8_t anySpins_ = 0;
};

} // namespace KODO_PRECISION
} // namespace kodo
