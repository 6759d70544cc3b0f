// SPDX-License-Identifier: MIT
// The linear system of an articulated tree.
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

} // namespace

/// Initialises A of every body. Forces at the anchors exert a restoring torque on a body. The
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
            if (node.child == kNone && pass.stiff.impulseScale > 0) { // a spring, see giving()
                node.wanted[r] += node.wantedDrift[r] - node.give[r] * rows.impulse[r];
                node.wantedDrift[r] = 0;
            }
        }
    }
}

/// S of a joint with a child: J_c A_c^-1 J_c^T.
Symmetric3 ArticulatedTrees::carry(Node& node) {
    Member& child = members_[node.child];
    child.factors = Symmetric3::Factors(child.inertia);
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.b : rows.a;
    Real s[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t r = 0; r < rows.count; ++r) {
        const Triple answer = child.factors.solve(j[r]);
        for (std::size_t k = 0; k <= r; ++k) {
            s[r][k] = dot(answer, j[k]);
        }
    }
    return {s[0][0], s[1][0], s[1][1], s[2][0], s[2][1], s[2][2]};
}

/// Diagonal of S of a joint to an immovable body that closes a loop: its own compliance alone, that
/// of a spring on the mass of its body; see Softness.
Triple ArticulatedTrees::giving(const Bodies& bodies, const Node& node,
                                const JointPass& pass) const {
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
    const BodyVelocity& motion = bodies.motion[members_[node.parent].body];
    const bool spring = pass.biased && pass.stiff.impulseScale > 0;
    const Real share =
        spring ? kLoopGive * pass.stiff.impulseScale / pass.stiff.massScale : kLeastGive;
    Triple give{1, 1, 1};
    for (std::size_t r = 0; r < rows.count; ++r) {
        const Triple& row = j[r];
        give[r] = share * (motion.invMass * (row[0] * row[0] + row[1] * row[1]) +
                           motion.invInertia * row[2] * row[2]);
    }
    return give;
}

/// Factorizes S of a joint and adds its term to A of the parent.
void ArticulatedTrees::factorize(const Bodies& bodies, Node& node, const JointPass& pass) {
    const auto clearLevers = [&](std::uint32_t body, std::array<Triple, 3>& rows) {
        if (bodies.motion[body].invMass > 0 && bodies.motion[body].invInertia == 0) {
            rows[0][2] = rows[1][2] = rows[2][2] = 0; // the body moves without rotation
        }
    };
    clearLevers(node.a, node.rows.a);
    clearLevers(node.b, node.rows.b);
    if (node.child == kNone) {
        node.give = giving(bodies, node, pass);
        node.factors = Symmetric3::Factors({node.give[0], 0, node.give[1], 0, 0, node.give[2]});
    } else {
        node.factors = Symmetric3::Factors(carry(node));
    }
    if (node.parent == kNone) {
        return;
    }
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
    Triple columns[3] = {}; // of S^-1 J_p
    for (std::size_t k = 0; k < 3; ++k) {
        Triple column{};
        for (std::size_t r = 0; r < rows.count; ++r) {
            column[r] = j[r][k];
        }
        columns[k] = node.factors.solve(column);
    }
    const auto entry = [&](std::size_t k, std::size_t l) {
        Real sum = 0;
        for (std::size_t r = 0; r < rows.count; ++r) {
            sum += columns[k][r] * j[r][l];
        }
        return sum;
    };
    Symmetric3& m = members_[node.parent].inertia;
    m.xx += entry(0, 0);
    m.yx += entry(1, 0);
    m.yy += entry(1, 1);
    m.zx += entry(2, 0);
    m.zy += entry(2, 1);
    m.zz += entry(2, 2);
}

/// Subtracts J_c A_c^-1 c_c from q, then adds J_p^T S^-1 q to c of the parent. `c` is Member::push
/// with Node::wanted, or the same of the displacement.
void ArticulatedTrees::reduce(Node& node, Triple Member::*c, Triple Node::*q) {
    const HeldRows& rows = node.rows;
    Triple& wanted = node.*q;
    if (node.child != kNone) {
        const Member& child = members_[node.child];
        const std::array<Triple, 3>& j = node.childIsB ? rows.b : rows.a;
        const Triple answer = child.factors.solve(child.*c);
        for (std::size_t r = 0; r < rows.count; ++r) {
            wanted[r] -= dot(j[r], answer);
        }
    }
    if (node.parent == kNone) {
        return;
    }
    Triple& push = members_[node.parent].*c;
    const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
    const Triple impulse = node.factors.solve(wanted);
    for (std::size_t r = 0; r < rows.count; ++r) {
        for (std::size_t k = 0; k < 3; ++k) {
            push[k] += impulse[r] * j[r][k];
        }
    }
}

/// Back substitution: the impulse l from the change of the parent, then the change of the child,
/// as `c` with `dx`.
Triple ArticulatedTrees::backSubstitute(Node& node, Triple Member::*c, Triple Member::*dx,
                                        Triple Node::*q) {
    const HeldRows& rows = node.rows;
    Triple& wanted = node.*q;
    if (node.parent != kNone) {
        const Triple& change = members_[node.parent].*dx;
        const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
        for (std::size_t r = 0; r < rows.count; ++r) {
            wanted[r] -= dot(j[r], change);
        }
    }
    const Triple impulse = node.factors.solve(wanted);
    if (node.child == kNone) {
        return impulse;
    }
    Member& child = members_[node.child];
    const std::array<Triple, 3>& j = node.childIsB ? rows.b : rows.a;
    Triple push = child.*c;
    for (std::size_t r = 0; r < rows.count; ++r) {
        for (std::size_t k = 0; k < 3; ++k) {
            push[k] += impulse[r] * j[r][k];
        }
    }
    child.*dx = child.factors.solve(push);
    return impulse;
}

/// Factorizes the linear system for the present estimates of forces.
void ArticulatedTrees::factorizeTree(const Bodies& bodies, const JointPass& pass, Tree& tree) {
    begin(bodies, pass, tree);
    const std::span<Node> nodes = nodesOf(tree);
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        factorize(bodies, *node, pass);
    }
    if (!tree.anchored) {
        Member& root = members_[tree.firstMember];
        root.factors = Symmetric3::Factors(root.inertia);
    }
}

/// Solves the linear system for the present arcs.
void ArticulatedTrees::solveLinear(const Bodies& bodies, const JointPass& pass, const Tree& tree) {
    const std::span<Node> nodes = nodesOf(tree);
    Member& root = members_[tree.firstMember];
    const bool drifts = pass.biased && (tree.stiff || !tree.arcsInVelocity);
    for (Member& member : membersOf(tree)) {
        member.push = member.driftPush = member.drift = {};
    }
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        measure(bodies, pass, tree, *node);
        reduce(*node, &Member::push, &Node::wanted);
        if (drifts) {
            reduce(*node, &Member::driftPush, &Node::wantedDrift);
        }
    }
    if (!tree.anchored) {
        root.change = root.factors.solve(root.push);
        root.drift = drifts ? root.factors.solve(root.driftPush) : Triple{};
    }
    for (Node& node : nodes) {
        node.impulse = backSubstitute(node, &Member::push, &Member::change, &Node::wanted);
        if (drifts) {
            backSubstitute(node, &Member::driftPush, &Member::drift, &Node::wantedDrift);
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
