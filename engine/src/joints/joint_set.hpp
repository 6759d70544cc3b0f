// SPDX-License-Identifier: MIT
#pragma once

#include "base/id_pool.hpp"
#include "bodies/joint_lists.hpp"
#include "contacts/contact_set.hpp"
#include "joints/articulated_trees.hpp"
#include "joints/body_rotations.hpp"
#include "joints/inertia_bounds.hpp"
#include "joints/spring_rates.hpp"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// All joints of a World.
class JointSet {
public:
    /// A joint with its accumulated impulses and its load.
    struct Joint {
        JointDef def;
        Vec2 point;                 // N s, of one substep
        std::array<Real, 6> axes{}; // N s or N m s, of one substep; the meaning depends on the kind
        Real counted = 0;      // rad with turns, or slip of a gear, at the end of the last step
        Vec2 linearImpulseSum; // N s, on b, over the step
        Real angularImpulseSum = 0; // N m s, on b, over the step, from angular constraints
        Vec2 force;                 // N, on b, mean of the last step that solved the joint
        Real torque = 0;            // N m, on b, mean of that step
        bool atLimit = false;       // a row along an axis pressed on a limit in the last step
        bool solved = false;        // in this step; false if both bodies are inactive
        Real springBound = 0;       // 1/s^2, of this step, see SpringRates
        Real stiffness = 0;         // N/m, of a spring, of this step
        Real load = 0;              // 1/s^2, of this step, see addLoad()
        Real held = 0;              // 1/s^2, recent load that still counts, see endStep()
        Real mostBias = kNoBound;   // m/s or rad/s, see boundBias()

        static constexpr Real kNoBound = std::numeric_limits<Real>::infinity();

        /// Slot of an impulse: 0 and 1 are the coordinates of point, the axes follow.
        std::size_t slotOf(const Vec2&) const { return 0; }
        std::size_t slotOf(const Real& axis) const {
            return 2 + static_cast<std::size_t>(&axis - axes.data());
        }
        Real& impulseAt(std::size_t slot) {
            return slot == 0 ? point.x : slot == 1 ? point.y : axes[slot - 2];
        }
        void visitState(StateStream& stream);

        static constexpr Real kMostTurn = Real(0.0125), kMost = Real(1e12); // rad; 1/s^2
        /// Counts the load of a row. `apart`: acceleration (m/s^2 or rad/s^2) to which it drives
        /// the bodies; `gap` (m or rad): how far it may open it at the usual jointGap.
        void addLoad(Real apart, Real gap) { load = std::min(std::max(load, apart / gap), kMost); }
    };

    JointId add(const JointDef& def);
    void remove(JointId id);
    bool contains(JointId id) const {
        return ids_.alive(id.index, id.generation) &&
               (id.world == stamp_ || id.world == 0 || stamp_ == 0);
    }
    /// Stamp of the World in all new ids; 0 matches every World.
    void setStamp(std::uint32_t stamp) { stamp_ = stamp; }
    /// Removes the joints of one body.
    void dropBody(std::uint32_t body);
    void setDef(JointId id, const JointDef& def);
    const Joint& operator[](JointId id) const { return joints_[id.index]; }
    std::vector<JointId> ids() const;
    std::vector<JointId> ids(std::uint32_t body) const;
    std::size_t size() const { return lists_.size(); }

    /// The reason why transfer() would give a joint that check() refuses.
    std::optional<Problem> checkTransfer(BodyId part, BodyId into, const Transform& place,
                                         Real lengthUnit) const;
    /// After a weld of `part` into `into`: moves the joints of `part` to `into` and removes joints
    /// between the two. `place` maps the shape frame of `part` to that of `into`.
    void transfer(BodyId part, BodyId into, const Transform& place);

    const JointLists& lists() const { return lists_; }
    /// Calls visit(body) for the bodies of excluded pairs, those whose joint forbids a contact,
    /// that were added or removed since the last call.
    template <typename Visit>
    void takePairChanges(Visit visit) {
        std::for_each(pairChanges_.begin(), pairChanges_.end(), visit);
        pairChanges_.clear();
    }

    /// Lists the joints with an active body; a step works on these alone. Must be called after each
    /// update of Bodies::awake; `changed`: that list has changed.
    void findBusy(const Bodies& bodies, bool changed);
    std::size_t awakeCount() const { return awake_.size(); }
    /// True if a pass changes no velocity: all joints belong to trees that leave it to the next.
    bool leaves(const JointPass& pass) const {
        return own_.empty() && !pass.biased && !pass.settle && trees_.allLazy();
    }

    /// Bounds the speed at which a joint removes its error while its bodies touch or are near. A
    /// joint and a contact that exclude each other would store energy without end. `pushSpeed` (m/s
    /// or rad/s): the largest at which contacts part.
    void boundBias(const ContactSet& contactSet, Real slop, Real pushSpeed);
    void beginStep();
    /// Selects the joints of one level for the functions below, up to the next call: of the busy
    /// joints those with that level. A joint has the higher level of its two bodies; without
    /// `levels`, which is by body, all have level 0. `jointGap`: see ArticulatedTrees::find().
    void beginGroup(Bodies& bodies, Real jointGap, std::span<const std::uint8_t> levels = {},
                    std::uint32_t level = 0);
    /// Revolute joints that belong to no tree, of bodies that can be moved or are locked. The
    /// caller solves them in this step. Those of bodies that can only rotate need InertiaBounds.
    std::span<const std::uint32_t> takeRevolutes(const Bodies& bodies);
    /// Scales the accumulated impulses; `by`: new length of the substep divided by the old one.
    void scaleImpulses(Real by);
    void warmStart(Bodies& bodies, const JointPass& pass);
    void solve(Bodies& bodies, const JointPass& pass);
    /// After the displacements: removes the errors that a pass with ErrorRemoval::ByDisplacement
    /// leaves, and what limits exceed by more than `allowed` (m or rad). Each pass removes the
    /// share that `pass.stiff` would remove in a substep.
    void correct(Bodies& bodies, const JointPass& pass, int passes, Real allowed);
    /// Counts turns of the bodies, before the displacements of the step become poses.
    void count(Bodies& bodies);
    /// Resets joints whose impulses are not finite.
    void forgetUnsound();
    /// Computes the loads of a step of dt. Removes and returns the overloaded joints.
    std::span<const BrokenJoint> endStep(Real dt);

    Joint& at(std::uint32_t index) { return joints_[index]; }

    /// Visits all joints in order.
    template <typename Visit>
    void forEach(Visit visit) const {
        ids_.forEach([&](std::uint32_t index) { visit(joints_[index]); });
    }
    /// Visits the joints of a body, in no particular order.
    template <typename Visit>
    void visitOf(std::uint32_t body, Visit visit) const {
        lists_.forEach(body, [&](std::uint32_t index) { visit(joints_[index]); });
    }
    /// Lists the joints of a body in order.
    void listOf(std::uint32_t body, std::vector<std::uint32_t>& joints) const {
        lists_.list(body, joints);
    }
    const JointDef& defAt(std::uint32_t index) const { return joints_[index].def; }
    /// Visits the joints that findBusy has listed.
    template <typename Visit>
    void forEachBusy(Visit visit) const {
        for (const std::uint32_t index : awake_) {
            visit(joints_[index]);
        }
    }
    /// Visits the joints that this class solves itself: busy, and not taken by takeRevolutes.
    template <typename Visit>
    void forEachOwn(Visit visit) const {
        for (const std::uint32_t index : own_) {
            visit(joints_[index]);
        }
        for (const Hinge& hinge : hinges_) {
            visit(joints_[hinge.joint]);
        }
    }
    void visitState(StateStream& stream, const Bodies& bodies, Real lengthUnit);

private:
    enum class LastPass : std::uint8_t { WarmStart, Biased, Relax };

    /// A revolute joint of a tree without motor and limits.
    struct Hinge {
        std::uint32_t joint;
        std::uint32_t a; // bodies
        std::uint32_t b;
        Vec2 anchorA; // m, from the centre of mass, in the frame of the body
        Vec2 anchorB;
        HeldRows* rows;
    };

    JointId idAt(std::uint32_t index) const { return {index, ids_.generationAt(index), stamp_}; }

    IdPool ids_;
    std::uint32_t stamp_ = 0;
    std::vector<Joint> joints_;
    JointLists lists_;                       // of live joints
    std::vector<std::uint32_t> pairChanges_; // see takePairChanges()
    std::vector<BrokenJoint> broken_;
    ArticulatedTrees trees_;                             // of this step
    std::vector<ArticulatedTrees::Edge> treeCandidates_; // joints that may belong to a tree
    std::vector<Hinge> hinges_;                          // of this step
    SpringRates springs_;                                // of this step
    InertiaBounds inertias_;                             // of a pass
    BodyRotations turned_;
    std::vector<std::uint32_t> own_;            // of this step, in order: see forEachOwn
    std::vector<std::uint32_t> takenRevolutes_; // of this step, in order: result of takeRevolutes
    std::vector<std::uint32_t> awake_; // in order; may contain joints that have become idle since
    bool awakeStale_ = true;
    LastPass lastPass_ = LastPass::Relax;

    void refreshLists();
    void list(std::uint32_t index);
    void unlist(std::uint32_t index);
    void notePairChange(const JointDef& def);
    void listHinges(const Bodies& bodies);
    void measureHinges(Bodies& bodies, const JointPass& pass);
    void raiseInertias(Bodies& bodies, const JointPass& pass);
    void solveStiffSprings(Bodies& bodies, const JointPass& pass);
    bool releasePulls(Bodies& bodies);
    void solveTrees(Bodies& bodies, const JointPass& pass);
};

/// rad/s, of b relative to a.
inline Real spinOf(const JointSet::Joint& joint, const Bodies& bodies) {
    return bodies.motion[secondBody(joint.def).index].angularVelocity -
           bodies.motion[firstBody(joint.def).index].angularVelocity;
}

/// Where a joint is, and how it moves.
JointState stateOf(const JointSet::Joint& joint, const Bodies& bodies);

} // namespace KODO_PRECISION
} // namespace kodo
