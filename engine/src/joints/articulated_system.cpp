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

/// Finds inertia and angular velocity of every body. Forces at the anchors exert a restoring torque
/// on a body. The step is unstable if its angular frequency exceeds 1 rad per substep. So the
/// inertia has a lower bound, for any direction of the arms:
///
///   I >= h^2 sum of |force| |arm|
///
/// What the bound adds rotates with the tree as a whole, so that it damps vibrations alone. In the
/// relax pass the inertia is the true one, so that the pass adds no energy.
void ArticulatedTrees::begin(const Bodies& bodies, const JointPass& pass, Tree& tree) {
    for (Member& member : membersOf(tree)) {
        const BodyVelocity& motion = bodies.motion[member.body];
        member.spin = motion.angularVelocity;
        member.ownInertia = std::numeric_limits<Real>::infinity();
        if (motion.invInertia > 0) {
            const Real least = pass.biased ? pass.h * pass.h * member.pull : 0;
            tree.stiff = tree.stiff || least * motion.invInertia > 1;
            member.ownInertia = std::max(1 / motion.invInertia, least);
            const Real share = 1 / (member.ownInertia * motion.invInertia);
            member.spin = share < 1 ? share * member.spin + (1 - share) * tree.spin : member.spin;
        }
    }
}

/// Sets q from the velocities before the solve.
void ArticulatedTrees::measure(const Bodies& bodies, const JointPass& pass, Node& node) {
    HeldRows& rows = node.rows;
    const BodyVelocity& a = bodies.motion[node.a];
    const BodyVelocity& b = bodies.motion[node.b];
    const auto velocityOf = [&](const BodyVelocity& motion, std::uint32_t member) {
        return Triple{motion.velocity.x, motion.velocity.y,
                      member == kNone ? motion.angularVelocity : members_[member].spin};
    };
    const Triple speedA = velocityOf(a, node.childIsB ? node.parent : node.child);
    const Triple speedB = velocityOf(b, node.childIsB ? node.child : node.parent);
    const bool spring = node.child == kNone && pass.stiff.impulseScale > 0; // see giving()
    for (std::size_t r = 0; r < rows.count; ++r) {
        node.wanted[r] = -dot(rows.a[r], speedA) - dot(rows.b[r], speedB);
        if (pass.biased) {
            node.wanted[r] -= pass.stiff.biasRate * rows.error[r];
            node.wanted[r] -= rows.arc[r];
            if (spring) {
                node.wanted[r] -= node.give[r] * rows.impulse[r];
            }
        }
    }
}

/// S of a joint with a child: J_c A_c^-1 J_c^T. N: number of rows.
template <std::size_t N>
Symmetric3 ArticulatedTrees::carry(Node& node) {
    Member& child = members_[node.child];
    child.factors = Symmetric3::Factors(child.inertia);
    const std::array<Triple, 3>& j = node.childIsB ? node.rows.b : node.rows.a;
    Real s[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t r = 0; r < N; ++r) {
        node.answer[r] = child.factors.solve(j[r]);
        for (std::size_t k = 0; k <= r; ++k) {
            s[r][k] = dot(node.answer[r], j[k]);
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
    const bool two = node.rows.count == 2;
    if (node.child == kNone) {
        node.give = giving(bodies, node, pass);
        node.factors = Symmetric3::Factors({node.give[0], 0, node.give[1], 0, 0, node.give[2]});
    } else {
        node.factors = Symmetric3::Factors(two ? carry<2>(node) : carry<3>(node));
    }
    if (node.parent != kNone) {
        two ? addToParent<2>(node) : addToParent<3>(node);
    }
}

/// Adds J_p^T S^-1 J_p to A of the parent.
template <std::size_t N>
void ArticulatedTrees::addToParent(Node& node) {
    const std::array<Triple, 3>& j = node.childIsB ? node.rows.a : node.rows.b;
    for (std::size_t k = 0; k < 3; ++k) {
        Triple column{};
        for (std::size_t r = 0; r < N; ++r) {
            column[r] = j[r][k];
        }
        node.columns[k] = node.factors.solveFirst<N>(column);
    }
    const auto entry = [&](std::size_t k, std::size_t l) {
        Real sum = 0;
        for (std::size_t r = 0; r < N; ++r) {
            sum += node.columns[k][r] * j[r][l];
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

/// Subtracts J_c A_c^-1 c_c from q, then adds J_p^T S^-1 q to c of the parent.
template <std::size_t N>
void ArticulatedTrees::reduce(Node& node) {
    Triple& wanted = node.wanted;
    if (node.child != kNone) {
        const Triple& push = members_[node.child].push;
        for (std::size_t r = 0; r < N; ++r) {
            wanted[r] -= dot(node.answer[r], push);
        }
    }
    const Triple impulse = node.factors.solveFirst<N>(wanted);
    node.impulse = impulse;
    if (node.parent == kNone) {
        return;
    }
    Triple& push = members_[node.parent].push;
    const std::array<Triple, 3>& j = node.childIsB ? node.rows.a : node.rows.b;
    for (std::size_t r = 0; r < N; ++r) {
        for (std::size_t k = 0; k < 3; ++k) {
            push[k] += impulse[r] * j[r][k];
        }
    }
}

/// Back substitution: the impulse l from the change of the parent, then the change of the child.
template <std::size_t N>
void ArticulatedTrees::backSubstitute(Node& node) {
    Triple& impulse = node.impulse;
    if (node.parent != kNone) {
        const Triple& change = members_[node.parent].change;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t r = 0; r < N; ++r) {
                impulse[r] -= node.columns[k][r] * change[k];
            }
        }
    }
    if (node.child == kNone) {
        return;
    }
    Member& child = members_[node.child];
    Triple change = child.factors.solve(child.push);
    for (std::size_t r = 0; r < N; ++r) {
        for (std::size_t k = 0; k < 3; ++k) {
            change[k] += impulse[r] * node.answer[r][k];
        }
    }
    child.change = change;
}

/// Visits all nodes, those of each tree from the leaves to the root, tree by tree in turn.
template <typename Visit>
void ArticulatedTrees::fromLeaves(std::span<Tree* const> trees, Visit visit) {
    std::size_t most = 0;
    for (const Tree* tree : trees) {
        most = std::max(most, tree->nodes);
    }
    for (std::size_t k = most; k-- > 0;) {
        for (const Tree* tree : trees) {
            if (k < tree->nodes) {
                visit(nodes_[tree->firstNode + k]);
            }
        }
    }
}

/// The same from the roots to the leaves.
template <typename Visit>
void ArticulatedTrees::fromRoots(std::span<Tree* const> trees, Visit visit) {
    std::size_t most = 0;
    for (const Tree* tree : trees) {
        most = std::max(most, tree->nodes);
    }
    for (std::size_t k = 0; k < most; ++k) {
        for (const Tree* tree : trees) {
            if (k < tree->nodes) {
                visit(nodes_[tree->firstNode + k]);
            }
        }
    }
}

/// Initialises A of every body.
void ArticulatedTrees::resetInertia(const Bodies& bodies, const Tree& tree) {
    for (Member& member : membersOf(tree)) {
        const BodyVelocity& motion = bodies.motion[member.body];
        const Real mass = 1 / motion.invMass;
        const Real inertia = motion.invInertia > 0 ? member.ownInertia : Real(1);
        member.inertia = {mass, 0, mass, 0, 0, inertia};
    }
}

/// Factorizes the linear systems for the present estimates of forces. The factors of the relax pass
/// serve the next substep too, since it begins at the same positions.
void ArticulatedTrees::factorizeTrees(const Bodies& bodies, const JointPass& pass,
                                      std::span<Tree* const> trees) {
    changed_.clear();
    for (Tree* const tree : trees) {
        begin(bodies, pass, *tree);
        if (pass.biased && tree->factorized && tree->reusable && !tree->stiff) {
            continue;
        }
        tree->factorized = !tree->stiff;
        resetInertia(bodies, *tree);
        changed_.push_back(tree);
    }
    fromLeaves(changed_, [&](Node& node) { factorize(bodies, node, pass); });
    for (const Tree* tree : changed_) {
        if (!tree->anchored) {
            Member& root = members_[tree->firstMember];
            root.factors = Symmetric3::Factors(root.inertia);
        }
    }
}

/// Solves the linear systems for the present arcs.
void ArticulatedTrees::solveLinear(const Bodies& bodies, const JointPass& pass,
                                   std::span<Tree* const> trees) {
    for (const Tree* tree : trees) {
        for (Member& member : membersOf(*tree)) {
            member.push = {};
        }
        for (Node& node : nodesOf(*tree)) {
            measure(bodies, pass, node);
        }
    }
    fromLeaves(trees,
               [&](Node& node) { node.rows.count == 2 ? reduce<2>(node) : reduce<3>(node); });
    for (const Tree* tree : trees) {
        if (!tree->anchored) {
            Member& root = members_[tree->firstMember];
            root.change = root.factors.solve(root.push);
        }
    }
    fromRoots(trees, [&](Node& node) {
        node.rows.count == 2 ? backSubstitute<2>(node) : backSubstitute<3>(node);
    });
}

} // namespace KODO_PRECISION
} // namespace kodo
