// SPDX-License-Identifier: MIT
// The direct solve of articulated trees.
#include "joints/anchor.hpp"
#include "joints/articulated_trees.hpp"

#include <algorithm>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Compliance of a joint that closes a loop through an immovable body, as a fraction of the inverse
// mass of its row. Without compliance the loop is over-determined and S is singular.
constexpr Real kLeastGive = Real(1) / 1024;
// Fraction of the usual compliance for such a joint. It is solved together with its tree, so it may
// be stiffer than joints that are solved one by one.
constexpr Real kLoopGive = Real(0.4);

// Largest relative rise of the inertia of a body above the one that a solution has used.
constexpr Real kMostRise = Real(1) / 8;
// Largest change of an arc between two solutions, relative to the arms. A coarser one would decide
// the number of solutions by the step, and errors would not fall with the square of the step.
constexpr Real kSameArc = sizeof(Real) == 4 ? Real(0x1p-24) : Real(0x1p-48);
// Largest relative gain of kinetic energy with arcs in the velocities, beyond that of the rotation
// of the tree as a whole: a quarter of the square of its rotation (rad per substep), which the
// relax pass takes away again. The second is for stiff trees.
constexpr Real kMostGain = Real(1) / 256;
constexpr Real kMostStiffGain = Real(1) / 4096;
// Solutions of one substep. Loads of 1e5 links need up to eight.
constexpr int kMostSolutions = 8;

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

/// True if the solution adds much kinetic energy.
bool ArticulatedTrees::addsEnergy(const Bodies& bodies, const Tree& tree, Real h) {
    Real before = 0; // J, twice the energy
    Real after = 0;
    for (const Member& member : membersOf(tree)) {
        const BodyVelocity& motion = bodies.motion[member.body];
        const Vec2 change{member.change[0], member.change[1]};
        before += lengthSquared(motion.velocity) / motion.invMass;
        after += lengthSquared(motion.velocity + change) / motion.invMass;
        if (motion.invInertia > 0) {
            const Real spin = member.spin + member.change[2];
            before += motion.angularVelocity * motion.angularVelocity / motion.invInertia;
            after += spin * spin / motion.invInertia;
        }
    }
    const Real rotation = h * tree.spin;
    const Real most = (tree.stiff ? kMostStiffGain : kMostGain) + rotation * rotation / 2;
    return after > (1 + most) * before;
}

/// Initialises A and c of every body. Forces at the anchors exert a restoring torque on a body. The
/// step is unstable if its angular frequency exceeds 1 rad per substep. So the inertia has a lower
/// bound, for any direction of the arms:
///
///   I >= h^2 sum of |force| |arm|
///
/// What the bound adds rotates with the tree as a whole, so that it damps vibrations alone. In the
/// relax pass the inertia is the true one, so that the pass adds no energy.
void ArticulatedTrees::begin(const Bodies& bodies, const JointPass& pass, Tree& tree) {
    for (Member& member : membersOf(tree)) {
        const BodyVelocity& motion = bodies.motion[member.body];
        const Real mass = 1 / motion.invMass;
        member.push = {};
        member.driftPush = {};
        member.inertia = {mass, 0, mass, 0, 0, 1};
        member.spin = motion.angularVelocity;
        member.ownInertia = std::numeric_limits<Real>::infinity();
        if (motion.invInertia > 0) {
            const Real least = pass.biased ? pass.h * pass.h * member.pull : 0;
            tree.stiff = tree.stiff || least * motion.invInertia > 1;
            member.ownInertia = std::max(1 / motion.invInertia, least);
            member.inertia.zz = member.ownInertia;
            const Real share = 1 / (member.ownInertia * motion.invInertia);
            member.spin = share < 1 ? share * member.spin + (1 - share) * tree.spin : member.spin;
        }
    }
}

/// Sets q from the velocities before the solve.
void ArticulatedTrees::measure(const Bodies& bodies, const JointPass& pass, const Tree& tree,
                               Node& node) {
    HeldRows& rows = node.rows;
    const BodyVelocity& a = bodies.motion[node.a];
    const BodyVelocity& b = bodies.motion[node.b];
    const auto velocityOf = [&](const BodyVelocity& motion, std::uint32_t member) {
        return Triple{motion.velocity.x, motion.velocity.y,
                      member == kNone ? motion.angularVelocity : members_[member].spin};
    };
    const Triple speedA = velocityOf(a, node.childIsB ? node.parent : node.child);
    const Triple speedB = velocityOf(b, node.childIsB ? node.child : node.parent);
    for (std::size_t r = 0; r < rows.count; ++r) {
        node.wanted[r] = -dot(rows.a[r], speedA) - dot(rows.b[r], speedB);
        node.wantedDrift[r] = 0;
        if (pass.biased) {
            const bool errorInVelocity = tree.arcsInVelocity && !tree.stiff;
            (errorInVelocity ? node.wanted : node.wantedDrift)[r] -=
                pass.stiff.biasRate * rows.error[r];
            (tree.arcsInVelocity ? node.wanted : node.wantedDrift)[r] -= rows.arc[r];
        }
        if (a.invMass > 0 && a.invInertia == 0) {
            rows.a[r][2] = 0; // the body moves without rotation
        }
        if (b.invMass > 0 && b.invInertia == 0) {
            rows.b[r][2] = 0;
        }
    }
}

/// S of a joint with a child. Subtracts J_c A_c^-1 c_c from q.
Symmetric3 ArticulatedTrees::carry(Node& node) {
    Member& child = members_[node.child];
    child.factors = Symmetric3::Factors(child.inertia);
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.b : rows.a;
    Real s[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t r = 0; r < rows.count; ++r) {
        const Triple answer = child.factors.solve(j[r]);
        node.wanted[r] -= dot(answer, child.push);
        node.wantedDrift[r] -= dot(answer, child.driftPush);
        for (std::size_t k = 0; k <= r; ++k) {
            s[r][k] = dot(answer, j[k]);
        }
    }
    return {s[0][0], s[1][0], s[1][1], s[2][0], s[2][1], s[2][2]};
}

/// S of a joint to an immovable body that closes a loop: its own compliance alone, that of a spring
/// on the mass of its body; see Softness. A spring needs its error in the velocity.
Symmetric3 ArticulatedTrees::giving(const Bodies& bodies, Node& node, const JointPass& pass) const {
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
    const BodyVelocity& motion = bodies.motion[members_[node.parent].body];
    Real give[3] = {1, 1, 1};
    for (std::size_t r = 0; r < rows.count; ++r) {
        const Triple& row = j[r];
        const Real inverseMass = motion.invMass * (row[0] * row[0] + row[1] * row[1]) +
                                 motion.invInertia * row[2] * row[2];
        give[r] = kLeastGive * inverseMass;
        if (pass.biased && pass.stiff.impulseScale > 0) {
            give[r] = kLoopGive * pass.stiff.impulseScale / pass.stiff.massScale * inverseMass;
            node.wanted[r] += node.wantedDrift[r] - give[r] * rows.impulse[r];
            node.wantedDrift[r] = 0;
        }
    }
    return {give[0], 0, give[1], 0, 0, give[2]};
}

/// Eliminates a joint with its child: adds their terms to A and c of the parent.
void ArticulatedTrees::eliminate(const Bodies& bodies, Node& node, const JointPass& pass) {
    node.factors =
        Symmetric3::Factors(node.child == kNone ? giving(bodies, node, pass) : carry(node));
    if (node.parent == kNone) {
        return;
    }
    Member& parent = members_[node.parent];
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
    Triple columns[3] = {}; // of S^-1 J_p
    for (std::size_t k = 0; k < 3; ++k) {
        Triple column{};
        for (std::size_t r = 0; r < rows.count; ++r) {
            column[r] = j[r][k];
        }
        columns[k] = node.factors.solve(column);
        for (std::size_t r = 0; r < rows.count; ++r) {
            parent.push[k] += columns[k][r] * node.wanted[r];
            parent.driftPush[k] += columns[k][r] * node.wantedDrift[r];
        }
    }
    const auto entry = [&](std::size_t k, std::size_t l) {
        Real sum = 0;
        for (std::size_t r = 0; r < rows.count; ++r) {
            sum += columns[k][r] * j[r][l];
        }
        return sum;
    };
    Symmetric3& m = parent.inertia;
    m.xx += entry(0, 0);
    m.yx += entry(1, 0);
    m.yy += entry(1, 1);
    m.zx += entry(2, 0);
    m.zy += entry(2, 1);
    m.zz += entry(2, 2);
}

/// Back substitution: the impulse l from the change of the parent, then the change of the child.
void ArticulatedTrees::backSubstitute(Node& node) {
    const HeldRows& rows = node.rows;
    if (node.parent != kNone) {
        const Member& parent = members_[node.parent];
        const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
        for (std::size_t r = 0; r < rows.count; ++r) {
            node.wanted[r] -= dot(j[r], parent.change);
            node.wantedDrift[r] -= dot(j[r], parent.drift);
        }
    }
    node.impulse = node.factors.solve(node.wanted);
    if (node.child == kNone) {
        return;
    }
    const Triple drift = node.factors.solve(node.wantedDrift);
    Member& child = members_[node.child];
    const std::array<Triple, 3>& j = node.childIsB ? rows.b : rows.a;
    Triple push = child.push;
    Triple driftPush = child.driftPush;
    for (std::size_t r = 0; r < rows.count; ++r) {
        for (std::size_t k = 0; k < 3; ++k) {
            push[k] += node.impulse[r] * j[r][k];
            driftPush[k] += drift[r] * j[r][k];
        }
    }
    child.change = child.factors.solve(push);
    child.drift = child.factors.solve(driftPush);
}

/// Solves the linear system for the present arcs and estimates of forces.
void ArticulatedTrees::solveLinear(const Bodies& bodies, const JointPass& pass, Tree& tree) {
    begin(bodies, pass, tree);
    const std::span<Node> nodes = nodesOf(tree);
    for (Node& node : nodes) {
        measure(bodies, pass, tree, node);
    }
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        eliminate(bodies, *node, pass);
    }
    if (!tree.anchored) {
        Member& root = members_[tree.firstMember];
        root.factors = Symmetric3::Factors(root.inertia);
        root.change = root.factors.solve(root.push);
        root.drift = root.factors.solve(root.driftPush);
    }
    for (Node& node : nodes) {
        backSubstitute(node);
    }
}

/// Applies the changes of velocities, the displacements and the impulses.
void ArticulatedTrees::apply(Bodies& bodies, const JointPass& pass, const Tree& tree) {
    for (const Member& member : membersOf(tree)) {
        BodyVelocity& motion = bodies.motion[member.body];
        motion.velocity += Vec2{member.change[0], member.change[1]};
        motion.angularVelocity = member.spin + member.change[2];
        motion.deltaPosition += pass.h * Vec2{member.drift[0], member.drift[1]};
        motion.deltaAngle += pass.h * member.drift[2];
    }
    for (Node& node : nodesOf(tree)) {
        for (std::size_t r = 0; r < node.rows.count; ++r) {
            node.rows.impulse[r] += node.impulse[r];
        }
    }
}

/// Updates what the system depends on by its solution. True if that differs much.
bool ArticulatedTrees::improve(const Bodies& bodies, const JointPass& pass, Tree& tree) {
    const bool raised = raisePulls(tree, pass.h);
    const bool bent = updateArcs(bodies, tree, pass.h);
    const bool gains = tree.arcsInVelocity && addsEnergy(bodies, tree, pass.h);
    tree.arcsInVelocity = tree.arcsInVelocity && !gains;
    return raised || bent || gains;
}

void ArticulatedTrees::solveTree(Bodies& bodies, const JointPass& pass, Tree& tree) {
    addPulls(tree);
    tree.arcsInVelocity = true;
    tree.stiff = false;
    tree.spin = pass.biased ? spinOf(bodies, tree) : 0;
    solveLinear(bodies, pass, tree);
    for (int solution = 1; pass.biased && solution < kMostSolutions && improve(bodies, pass, tree);
         ++solution) {
        solveLinear(bodies, pass, tree);
    }
    apply(bodies, pass, tree);
}

void ArticulatedTrees::solve(Bodies& bodies, const JointPass& pass) {
    for (Tree& tree : trees_) {
        solveTree(bodies, pass, tree);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
