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
// be stiffer than joints that are solved one by one. A bridge of 50 planks opens by 0.4 % of a
// plank; with a third of it, one that carries cars opens by 2.5 % instead of 1.1 %.
constexpr Real kLoopGive = Real(1) / 64;
// Largest relative rise of the inertia of a body above the one that a solution has used.
constexpr Real kMostRise = Real(1) / 8;
// Largest change of an arc between two solutions, relative to the arms. What remains opens a joint
// of a swinging chain by 1e-4 of a link. With four times as much, two bars let go level lose 2 % of
// their energy in half a minute; with a thousandth, chains take 1.3 times as long.
constexpr Real kSameArc = Real(0x1p-15);
// The same for one or two bodies, which cost little: down to rounding, so that the errors of a
// pendulum fall with the square of the step.
constexpr std::size_t kFewBodies = 2;
constexpr Real kRoundedArc = sizeof(Real) == 4 ? Real(0x1p-24) : Real(0x1p-48);
// Solutions of one substep. Chains of discs under loads of 1e4 links need more than eight: a
// substep that is left before its arcs agree adds energy.
constexpr int kMostSolutions = 16;
constexpr std::size_t kSideBySide = 4; // trees
// Share of JointPass::mostBias for a tree that touches something. A ball of 50 kg on links of 0.2
// kg that hits a tower gains nothing; with all of it, up to 0.8 of its energy.
constexpr Real kTouchedShare = Real(1) / 4;

/// a + factor b
Triple sum(const Triple& a, Real factor, const Triple& b) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// The motion of a body at a point that is `arm` (m) from where it is given.
Triple motionAt(const Triple& motion, Vec2 arm) {
    return {motion[0] - motion[2] * arm.y, motion[1] + motion[2] * arm.x, motion[2]};
}

/// The same of an impulse and its moment.
Triple wrenchAt(const Triple& wrench, Vec2 arm) {
    return {wrench[0], wrench[1], wrench[2] - cross(arm, Vec2{wrench[0], wrench[1]})};
}

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
    bool known = false; // tree.spin
    tree.lazy = tree.light;
    for (Member& member : membersOf(tree)) {
        const BodyVelocity& motion = bodies.motion[member.body];
        member.spin = motion.angularVelocity;
        member.ownInertia = std::numeric_limits<Real>::infinity();
        if (motion.invInertia > 0) {
            const Real least = pass.biased ? pass.h * pass.h * member.pull : 0;
            member.ownInertia = member.moment;
            if (least > member.moment) {
                tree.spin = known ? tree.spin : spinOf(bodies, tree);
                known = true;
                tree.lazy = false;
                const Real share = member.moment / least;
                member.ownInertia = least;
                member.spin = share * member.spin + (1 - share) * tree.spin;
            }
        }
        member.inertia = {member.mass, 0, member.mass,
                          0,           0, motion.invInertia > 0 ? member.ownInertia : Real(1)};
    }
}

/// The motion that the joint leaves free, at anchor b.
Triple ArticulatedTrees::Node::freeAxis() const {
    return rows.across != Vec2{} ? Triple{rows.across.y, -rows.across.x, 0} : Triple{0, 0, 1};
}

/// Sets w without the arc, from the velocities before the solve.
void ArticulatedTrees::measure(const Bodies& bodies, const JointPass& pass, Node& node) {
    HeldRows& rows = node.rows;
    const BodyVelocity& a = bodies.motion[node.a];
    const BodyVelocity& b = bodies.motion[node.b];
    const auto stays = [](const BodyVelocity& m) { return m.invMass > 0 && m.invInertia == 0; };
    rows.armA = stays(a) ? Vec2{} : rows.armA; // the body moves without rotation
    rows.armB = stays(b) ? Vec2{} : rows.armB;
    const auto spinOf = [&](const BodyVelocity& motion, std::uint32_t member) {
        return member == kNone ? motion.angularVelocity : members_[member].spin;
    };
    const Real spinA = spinOf(a, node.childIsB ? node.parent : node.child);
    const Real spinB = spinOf(b, node.childIsB ? node.child : node.parent);
    const Vec2 speed =
        (b.velocity - a.velocity) + (spinB * perp(rows.armB) - spinA * perp(rows.armA));
    Triple q{-speed.x, -speed.y, rows.angle ? spinA - spinB : Real(0)};
    if (pass.biased) {
        // A gap that contacts keep open would be closed with the mass of the whole tree, at a speed
        // that grows with the gap: a wrecking ball gained a thousandfold energy.
        const Real wanted = pass.stiff.biasRate * length(Vec2{rows.error[0], rows.error[1]});
        const Real most = node.touched ? kTouchedShare * pass.mostBias : pass.mostBias;
        const Real share = wanted > most ? most / wanted : Real(1);
        q = sum(q, -share * pass.stiff.biasRate, rows.error);
    }
    if (rows.across != Vec2{}) {
        const Vec2 held = dot(rows.across, Vec2{q[0], q[1]}) * rows.across;
        q = {held.x, held.y, q[2]};
    }
    const Real sign = node.childIsB ? Real(1) : Real(-1);
    node.base = {sign * q[0], sign * q[1], sign * q[2]};
    eliminate(bodies, pass, node);
}

/// Inertia that stands for an immovable body at a joint that closes a loop: so large that the joint
/// gives like a spring on the mass of its body; see Softness.
Symmetric3 ArticulatedTrees::closing(const Bodies& bodies, const Node& node,
                                     const JointPass& pass) const {
    const BodyVelocity& motion = bodies.motion[members_[node.parent].body];
    const Real spring = pass.stiff.impulseScale / pass.stiff.massScale;
    const Real share = pass.biased && spring > 0 ? kLoopGive * spring : kLeastGive;
    const Real m = 1 / (share * motion.invMass);
    const Real turn = share * (node.rows.angle ? motion.invInertia : Real(0));
    const Vec2 n = node.rows.across;
    const Real all = n == Vec2{} ? m : Real(0);
    return {all + m * n.x * n.x,          m * n.x * n.y, all + m * n.y * n.y, 0, 0,
            turn > 0 ? 1 / turn : Real(0)};
}

/// Sets A', u and d of a joint, and adds A' to A of the parent.
void ArticulatedTrees::eliminate(const Bodies& bodies, const JointPass& pass, Node& node) {
    const HeldRows& rows = node.rows;
    Symmetric3& m = node.carried;
    node.perAnswer = 0;
    node.answer = {};
    if (node.child == kNone) {
        m = closing(bodies, node, pass);
    } else {
        const Symmetric3& own = members_[node.child].inertia;
        m = own.seenFrom(node.childArm());
        if (node.movesFreely()) {
            const Triple free = node.freeAxis();
            node.answer = m.times(free);
            node.perAnswer = 1 / dot(free, node.answer);
            if (rows.across != Vec2{}) {
                m.subtract(node.answer, node.perAnswer);
            } else {
                m = own.hinged(node.childArm());
            }
        }
    }
    if (node.parent != kNone) {
        members_[node.parent].inertia.add(m.seenFrom(-node.parentArm()));
    }
}

/// Sets c' of a joint, and adds c' - A' w to c of the parent.
void ArticulatedTrees::reduce(Node& node) {
    Triple c{};
    if (node.child != kNone) {
        c = wrenchAt(members_[node.child].push, node.childArm());
        node.freely = node.perAnswer * dot(node.freeAxis(), c);
    }
    node.load = sum(c, -node.freely, node.answer);
    if (node.parent != kNone) {
        Triple& push = members_[node.parent].push;
        const Triple passed = sum(node.load, -1, node.carried.times(node.wanted));
        push = sum(push, 1, wrenchAt(passed, -node.parentArm()));
    }
}

/// Sets the impulse of a joint, and the change of its child.
void ArticulatedTrees::backSubstitute(Node& node) {
    Triple m = node.wanted;
    if (node.parent != kNone) {
        m = sum(m, 1, motionAt(members_[node.parent].change, node.parentArm()));
    }
    const Triple onChild = sum(node.carried.times(m), -1, node.load);
    node.impulse = sum({}, node.childIsB ? Real(1) : Real(-1), onChild);
    if (node.child != kNone) {
        const Real free = node.freely - node.perAnswer * dot(node.answer, m);
        members_[node.child].change = motionAt(sum(m, free, node.freeAxis()), -node.childArm());
    }
}

/// Visits all nodes, those of each tree from the leaves to the root or back, tree by tree in turn.
template <typename Visit>
void ArticulatedTrees::forNodes(std::span<Tree* const> trees, bool fromLeaves, Visit visit) {
    std::size_t most = 0;
    for (const Tree* tree : trees) {
        most = std::max(most, tree->nodes);
    }
    for (std::size_t i = 0; i < most; ++i) {
        const std::size_t k = fromLeaves ? most - 1 - i : i;
        for (const Tree* tree : trees) {
            if (k < tree->nodes) {
                visit(nodes_[tree->firstNode + k]);
            }
        }
    }
}

/// Eliminates all joints, for the present estimates of forces.
void ArticulatedTrees::factorizeTrees(const Bodies& bodies, const JointPass& pass,
                                      std::span<Tree* const> trees) {
    for (Tree* const tree : trees) {
        begin(bodies, pass, *tree);
    }
    forNodes(trees, true, [&](Node& node) { measure(bodies, pass, node); });
}

/// Solves the linear systems for the present arcs.
void ArticulatedTrees::solveLinear(std::span<Tree* const> trees) {
    for (const Tree* tree : trees) {
        for (Member& member : membersOf(*tree)) {
            member.push = {};
        }
        for (Node& node : nodesOf(*tree)) {
            const Vec2 arc = node.childIsB ? node.rows.arc : -node.rows.arc;
            node.wanted = {node.base[0] - arc.x, node.base[1] - arc.y, node.base[2]};
        }
    }
    forNodes(trees, true, [&](Node& node) { reduce(node); });
    for (const Tree* tree : trees) {
        if (!tree->anchored) {
            Member& root = members_[tree->firstMember];
            root.change = root.inertia.solve(root.push);
        }
    }
    forNodes(trees, false, [&](Node& node) { backSubstitute(node); });
}

/// Angular velocity (rad/s) of the tree as a whole about its anchor, or about its centre of mass:
/// its angular momentum over its moment of inertia. The velocity of the centre of mass adds nothing
/// to the momentum about it.
Real ArticulatedTrees::spinOf(const Bodies& bodies, const Tree& tree) {
    const std::span<const Member> members = membersOf(tree);
    const auto placeOf = [&](const Member& member) {
        return bodies.pose[member.body].position + bodies.motion[member.body].deltaPosition;
    };
    Vec2 center{};
    if (tree.anchored) {
        const Node& root = nodesOf(tree).front();
        center = placeOf(members_[root.child]) + (root.childIsB ? root.rows.armB : root.rows.armA);
    } else {
        Real mass = 0;
        for (const Member& member : members) {
            const Real invMass = bodies.motion[member.body].invMass;
            mass += 1 / invMass;
            center += placeOf(member) / invMass;
        }
        center = center / mass;
    }
    Real momentum = 0;
    Real inertia = 0;
    for (const Member& member : members) {
        const BodyVelocity& motion = bodies.motion[member.body];
        const Vec2 arm = placeOf(member) - center;
        const Real own = motion.invInertia > 0 ? 1 / motion.invInertia : 0;
        momentum += cross(arm, motion.velocity) / motion.invMass + own * motion.angularVelocity;
        inertia += lengthSquared(arm) / motion.invMass + own;
    }
    return inertia > 0 ? momentum / inertia : 0;
}

/// Sums force times arm for every body. What keeps a single body on its circle exerts no torque,
/// however the body turns.
void ArticulatedTrees::addPulls(const Bodies& bodies, const JointPass& pass, const Tree& tree) {
    for (Member& member : membersOf(tree)) {
        const Vec2 way = bodies.motion[member.body].angularVelocity * nodesOf(tree)[0].childArm();
        const bool single = tree.anchored && tree.members == 1;
        member.pull = single && pass.errors == ErrorRemoval::ByDisplacement
                          ? -member.mass * lengthSquared(way)
                          : Real(0);
    }
    const auto add = [&](std::uint32_t member, Real amount) {
        if (member != kNone) {
            members_[member].pull += amount;
        }
    };
    for (const Node& node : nodesOf(tree)) {
        const HeldRows& rows = node.rows;
        add(node.child, rows.pull * (node.childIsB ? rows.reachB : rows.reachA));
        add(node.parent, rows.pull * (node.childIsB ? rows.reachA : rows.reachB));
    }
}

/// Raises the estimates of forces to those of the solution. True if they raise the inertia of a
/// body much.
bool ArticulatedTrees::raisePulls(const Bodies& bodies, const JointPass& pass, const Tree& tree) {
    for (Node& node : nodesOf(tree)) {
        HeldRows& rows = node.rows;
        if (rows.point) {
            rows.pull =
                std::max(rows.pull, length(Vec2{node.impulse[0], node.impulse[1]}) / pass.h);
        }
    }
    addPulls(bodies, pass, tree);
    const std::span<const Member> members = membersOf(tree);
    return std::any_of(members.begin(), members.end(), [&](const Member& member) {
        return pass.h * pass.h * member.pull > (1 + kMostRise) * member.ownInertia;
    });
}

/// Finds the arcs for the angular velocities of the solution. True if they differ much from those
/// that the solution has used.
bool ArticulatedTrees::updateArcs(const Bodies& bodies, const Tree& tree, Real h) {
    bool differ = false;
    const Real same = tree.members <= kFewBodies ? kRoundedArc : kSameArc;
    const auto angleOf = [&](std::uint32_t body, std::uint32_t index) {
        return h * (index == kNone ? bodies.motion[body].angularVelocity
                                   : members_[index].spin + members_[index].change[2]);
    };
    for (Node& node : nodesOf(tree)) {
        HeldRows& rows = node.rows;
        if (!rows.point) {
            continue;
        }
        const Real angleA = angleOf(node.a, node.childIsB ? node.parent : node.child);
        const Real angleB = angleOf(node.b, node.childIsB ? node.child : node.parent);
        const Vec2 arc = fromTangentToArc(angleB, rows.armB) - fromTangentToArc(angleA, rows.armA);
        const Real arms = lengthSquared(rows.armA) + lengthSquared(rows.armB);
        differ = differ || lengthSquared(arc - h * rows.arc) > same * same * arms;
        rows.arc = arc / h;
    }
    return differ;
}

/// Applies the changes of velocities, and the impulses.
void ArticulatedTrees::apply(Bodies& bodies, const Tree& tree) {
    for (const Member& member : membersOf(tree)) {
        BodyVelocity& motion = bodies.motion[member.body];
        motion.velocity += Vec2{member.change[0], member.change[1]};
        motion.angularVelocity = motion.invInertia > 0 ? member.spin + member.change[2] : Real(0);
    }
    for (Node& node : nodesOf(tree)) {
        node.rows.impulse = sum(node.rows.impulse, 1, node.impulse);
    }
}

void ArticulatedTrees::solveBatch(Bodies& bodies, const JointPass& pass) {
    for (Tree* const tree : batch_) {
        if (pass.biased) {
            addPulls(bodies, pass, *tree);
        }
    }
    unsolved_ = batch_;
    factorizeTrees(bodies, pass, unsolved_);
    solveLinear(unsolved_);
    for (int solution = 1; pass.biased && solution < kMostSolutions; ++solution) {
        raised_.clear();
        std::erase_if(unsolved_, [&](Tree* tree) {
            const bool raised = raisePulls(bodies, pass, *tree);
            const bool bent = updateArcs(bodies, *tree, pass.h);
            if (raised) {
                raised_.push_back(tree);
            }
            return !raised && !bent;
        });
        factorizeTrees(bodies, pass, raised_);
        solveLinear(unsolved_);
    }
    for (const Tree* const tree : batch_) {
        apply(bodies, *tree);
        for (Node& node : nodesOf(*tree)) {
            node.rows.lazy = tree->lazy;
        }
    }
}

void ArticulatedTrees::solve(Bodies& bodies, const JointPass& pass) {
    batch_.clear();
    for (Tree& tree : trees_) {
        if (pass.biased || pass.settle || !tree.lazy) {
            batch_.push_back(&tree);
        }
        if (batch_.size() == kSideBySide) {
            solveBatch(bodies, pass);
            batch_.clear();
        }
    }
    solveBatch(bodies, pass);
}

} // namespace KODO_PRECISION
} // namespace kodo
