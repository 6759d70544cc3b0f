// SPDX-License-Identifier: MIT
// The direct solve of articulated trees.
#include "joints/anchor.hpp"
#include "joints/articulated_trees.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Largest relative rise of the inertia of a body above the one that a solution has used.
constexpr Real kMostRise = Real(1) / 8;
// Largest change of an arc between two solutions, relative to the arms. A coarser one would decide
// the number of solutions by the step, and errors would not fall with the square of the step.
constexpr Real kSameArc = sizeof(Real) == 4 ? Real(0x1p-24) : Real(0x1p-48);
// Solutions of one substep; loads of 1e5 links need up to eight.
constexpr int kMostSolutions = 8;
constexpr std::size_t kSideBySide = 4; // trees

} // namespace

std::span<ArticulatedTrees::Node> ArticulatedTrees::nodesOf(const Tree& tree) {
    return std::span(nodes_).subspan(tree.firstNode, tree.nodes);
}

std::span<ArticulatedTrees::Member> ArticulatedTrees::membersOf(const Tree& tree) {
    return std::span(members_).subspan(tree.firstMember, tree.members);
}

/// Angular velocity (rad/s) of the tree as a whole about its anchor, or about its centre of mass:
/// its angular momentum over its moment of inertia.
Real ArticulatedTrees::spinOf(const Bodies& bodies, const Tree& tree) {
    const std::span<const Member> members = membersOf(tree);
    const auto placeOf = [&](const Member& member) {
        return bodies.pose[member.body].position + bodies.motion[member.body].deltaPosition;
    };
    Vec2 center{};
    Vec2 velocity{};
    if (tree.anchored) {
        const Node& root = nodesOf(tree).front();
        center = placeOf(members_[root.child]) + (root.childIsB ? root.rows.armB : root.rows.armA);
    } else {
        Real mass = 0;
        for (const Member& member : members) {
            const BodyVelocity& motion = bodies.motion[member.body];
            mass += 1 / motion.invMass;
            center += placeOf(member) / motion.invMass;
            velocity += motion.velocity / motion.invMass;
        }
        center = center / mass;
        velocity = velocity / mass;
    }
    Real momentum = 0;
    Real inertia = 0;
    for (const Member& member : members) {
        const BodyVelocity& motion = bodies.motion[member.body];
        const Vec2 arm = placeOf(member) - center;
        const Real own = motion.invInertia > 0 ? 1 / motion.invInertia : 0;
        momentum +=
            cross(arm, motion.velocity - velocity) / motion.invMass + own * motion.angularVelocity;
        inertia += lengthSquared(arm) / motion.invMass + own;
    }
    return inertia > 0 ? momentum / inertia : 0;
}

/// Sums force times arm for every body.
void ArticulatedTrees::addPulls(const Tree& tree) {
    for (Member& member : membersOf(tree)) {
        member.pull = 0;
    }
    const auto add = [&](std::uint32_t member, Real amount) {
        if (member != kNone) {
            members_[member].pull += amount;
        }
    };
    for (const Node& node : nodesOf(tree)) {
        const HeldRows& rows = node.rows;
        add(node.child, rows.pull * length(node.childIsB ? rows.armB : rows.armA));
        add(node.parent, rows.pull * length(node.childIsB ? rows.armA : rows.armB));
    }
}

/// Raises the estimates of forces to those of the solution. True if they raise the inertia of a
/// body much.
bool ArticulatedTrees::raisePulls(const Tree& tree, Real h) {
    for (Node& node : nodesOf(tree)) {
        HeldRows& rows = node.rows;
        if (rows.hasPoint()) {
            const Vec2 impulse{node.impulse[rows.point], node.impulse[rows.point + 1]};
            rows.pull = std::max(rows.pull, length(impulse) / h);
        }
    }
    addPulls(tree);
    const std::span<const Member> members = membersOf(tree);
    return std::any_of(members.begin(), members.end(), [h](const Member& member) {
        return h * h * member.pull > (1 + kMostRise) * member.ownInertia;
    });
}

/// Finds the arcs for the angular velocities of the solution. True if they differ much from those
/// that the solution has used.
bool ArticulatedTrees::updateArcs(const Bodies& bodies, const Tree& tree, Real h) {
    bool differ = false;
    const auto angleOf = [&](std::uint32_t body, std::uint32_t index) {
        return h * (index == kNone ? bodies.motion[body].angularVelocity
                                   : members_[index].spin + members_[index].change[2]);
    };
    for (Node& node : nodesOf(tree)) {
        HeldRows& rows = node.rows;
        if (!rows.hasPoint()) {
            continue;
        }
        const Real angleA = angleOf(node.a, node.childIsB ? node.parent : node.child);
        const Real angleB = angleOf(node.b, node.childIsB ? node.child : node.parent);
        const Vec2 arc = fromTangentToArc(angleB, rows.armB) - fromTangentToArc(angleA, rows.armA);
        const Vec2 before{rows.arc[rows.point], rows.arc[rows.point + 1]};
        const Real arms = lengthSquared(rows.armA) + lengthSquared(rows.armB);
        differ = differ || lengthSquared(arc - h * before) > kSameArc * kSameArc * arms;
        rows.arc[rows.point] = arc.x / h;
        rows.arc[rows.point + 1] = arc.y / h;
    }
    return differ;
}

/// Applies the changes of velocities, and the impulses.
void ArticulatedTrees::apply(Bodies& bodies, const Tree& tree) {
    for (const Member& member : membersOf(tree)) {
        BodyVelocity& motion = bodies.motion[member.body];
        motion.velocity += Vec2{member.change[0], member.change[1]};
        motion.angularVelocity = member.spin + member.change[2];
    }
    for (Node& node : nodesOf(tree)) {
        for (std::size_t r = 0; r < node.rows.count; ++r) {
            node.rows.impulse[r] += node.impulse[r];
        }
    }
}

/// Updates what a tree depends on by its solution. True if the tree is to be solved again; it is
/// factorized first if `raised`.
ArticulatedTrees::Next ArticulatedTrees::nextOf(const Bodies& bodies, const Tree& tree, Real h) {
    const bool raised = raisePulls(tree, h);
    const bool bent = updateArcs(bodies, tree, h);
    return raised ? Next::Factorize : bent ? Next::Solve : Next::Done;
}

void ArticulatedTrees::solveBatch(Bodies& bodies, const JointPass& pass, std::span<Tree> trees) {
    unsolved_.clear();
    for (Tree& tree : trees) {
        if (pass.biased) {
            addPulls(tree);
        }
        tree.stiff = false;
        tree.spin = pass.biased ? spinOf(bodies, tree) : 0;
        unsolved_.push_back(&tree);
    }
    factorizeTrees(bodies, pass, unsolved_);
    solveLinear(bodies, pass, unsolved_);
    for (int solution = 1; pass.biased && solution < kMostSolutions; ++solution) {
        raised_.clear();
        std::erase_if(unsolved_, [&](Tree* tree) {
            const Next next = nextOf(bodies, *tree, pass.h);
            if (next == Next::Factorize) {
                raised_.push_back(tree);
            }
            return next == Next::Done;
        });
        factorizeTrees(bodies, pass, raised_);
        solveLinear(bodies, pass, unsolved_);
    }
    for (const Tree& tree : trees) {
        apply(bodies, tree);
    }
}

void ArticulatedTrees::solve(Bodies& bodies, const JointPass& pass) {
    for (std::size_t first = 0; first < trees_.size(); first += kSideBySide) {
        const std::size_t count = std::min(kSideBySide, trees_.size() - first);
        solveBatch(bodies, pass, std::span(trees_).subspan(first, count));
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
