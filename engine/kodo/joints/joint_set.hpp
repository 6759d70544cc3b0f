// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/id_pool.hpp>
#include <kodo/joints/joint_trees.hpp>
#include <kodo/joints/turned_bodies.hpp>

#include <array>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// A joint that its load broke in the last step. Its id is dead.
struct BrokenJoint {
    JointId id;
    BodyId a;
    BodyId b;
    Real force = 0;  // N, averaged over the step
    Real torque = 0; // N m
};

/// All joints of a World.
class JointSet {
public:
    /// A joint as it is held, with what it has learned.
    struct Joint {
        JointDef def;
        Vec2 point;                 // N s, of one substep
        std::array<Real, 5> axes{}; // N s or N m s; what each stands for depends on the kind
        Vec2 pushSum;               // N s, on b, over the step
        Real turnSum = 0;           // N m s, on b, from angular constraints
        Vec2 force;                 // N, on b, the mean of the last step that solved it
        Real torque = 0;            // N m
        bool solved = false;        // in this step; not if both bodies rest, stand or wait

        /// Impulses by number: 0 and 1 are those of the point, then come the axes.
        std::size_t slotOf(const Vec2&) const { return 0; }
        std::size_t slotOf(const Real& axis) const {
            return 2 + static_cast<std::size_t>(&axis - axes.data());
        }
        Real& impulseAt(std::size_t slot) {
            return slot == 0 ? point.x : slot == 1 ? point.y : axes[slot - 2];
        }
    };

    JointId add(const JointDef& def);
    void remove(JointId id);
    bool contains(JointId id) const { return ids_.alive(id.index, id.generation); }
    /// Removes the joints of one body.
    void dropBody(BodyId body);
    const JointDef& def(JointId id) const { return joints_[id.index].def; }
    void setDef(JointId id, const JointDef& def);
    Vec2 force(JointId id) const { return joints_[id.index].force; }   // N, on b
    Real torque(JointId id) const { return joints_[id.index].torque; } // N m, on b
    std::vector<JointId> ids() const;
    std::size_t size() const { return live_.size(); }

    /// `part` became a part of `into`: its joints hold `into` now, and those between them are gone.
    /// `place` takes a point of the frame of `part`'s shape to that of `into`'s.
    void transfer(BodyId part, BodyId into, const Transform& place);

    /// Pairs of bodies that a joint forbids to touch, in order.
    std::span<const std::pair<std::uint32_t, std::uint32_t>> apart() const { return apart_; }

    /// Lists the joints that a step works on: those of which a body takes part in it. To be called
    /// when the list of these bodies was made, and told if it has changed; else it costs nothing.
    void findBusy(const Bodies& bodies, bool changed);
    std::size_t busyCount() const { return busy_.size(); }

    void beginStep(const Bodies& bodies);
    /// Pins without motor and limits that belong to no tree: whoever asks solves them in this step.
    std::span<const std::uint32_t> lendPins();
    /// Joints start from the impulses of a substep that was so many times as long.
    void scaleImpulses(Real by);
    void warmStart(Bodies& bodies, const JointPass& pass);
    void solve(Bodies& bodies, const JointPass& pass);
    /// Joints with an impulse that is not finite start anew.
    void forgetUnsound();
    /// Finds the loads of a step of dt and breaks what is overloaded.
    std::span<const BrokenJoint> endStep(Real dt);

    Joint& at(std::uint32_t index) { return joints_[index]; }

    /// Visits each joint in order.
    template <typename Visit>
    void forEach(Visit visit) const {
        for (const std::uint32_t index : live_) {
            visit(joints_[index]);
        }
    }
    /// The same of those that findBusy has listed.
    template <typename Visit>
    void forEachBusy(Visit visit) const {
        for (const std::uint32_t index : busy_) {
            visit(joints_[index]);
        }
    }
    /// And of those among them that are not lent.
    template <typename Visit>
    void forEachOwn(Visit visit) const {
        for (const std::uint32_t index : own_) {
            visit(joints_[index]);
        }
    }

private:
    friend class SnapshotFields;

    IdPool ids_;
    std::vector<Joint> joints_;
    std::vector<std::uint32_t> live_;                            // in order
    std::vector<std::pair<std::uint32_t, std::uint32_t>> apart_; // bodies that must not touch
    std::vector<BrokenJoint> broken_;
    JointTrees trees_;                   // of this step
    std::vector<JointTrees::Edge> held_; // joints that may belong to one
    TurnedBodies turned_;
    std::vector<std::uint32_t> own_;  // of this step, in order: all that are busy and not lent
    std::vector<std::uint32_t> lent_; // likewise
    std::vector<std::uint32_t> busy_; // in order; may have some that have become idle since
    bool busyStale_ = true;

    void refreshLists();
    void solveTrees(Bodies& bodies, const JointPass& pass);
};

} // namespace kodo::inline KODO_PRECISION
