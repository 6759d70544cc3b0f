// SPDX-License-Identifier: MIT
#include "joints/articulated_trees.hpp"

#include "base/vector_reuse.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Largest mass that a soft joint carries, relative to the reduced mass of its bodies and to the gap
// that is permitted: 16 at the usual gap of 0.04. Ragdolls have 4 to 10, a chain of n equal links
// 2 n - 2. At 60 Hz a ratio of 16 opens a joint by 1 mm under the earth's gravity. A swinging chain
// of that ratio opens by 3 % of a link.
constexpr Real kMostCarried = 400;
// Sum of the reduced masses of the joints of a body, relative to its own, up to which springs can
// hold them: 33 bars pinned to a hub, each of an eighth of its mass, explode.
constexpr Real kMostJoined = 3;
// An anchored tree of few joints, 10 at the usual gap, is solved directly without a load, too: a
// pendulum then has the period and the energy of the exact solution.
constexpr Real kFewJoints = Real(0.42);

/// Reduced mass of a joint of a body and another one, relative to the mass of the body; the same of
/// the inertias, if the joint holds the angle.
Real shareOf(const Bodies& bodies, const ArticulatedTrees::Edge& edge, std::uint32_t body,
             std::uint32_t other) {
    const BodyVelocity& own = bodies.motion[body];
    const BodyVelocity& its = bodies.motion[other];
    const Real share = own.invMass / (own.invMass + its.invMass);
    if (!edge.direct || !(own.invInertia > 0)) {
        return share;
    }
    const Vec2 between = bodies.pose[body].position - bodies.pose[other].position;
    return std::max(share, own.invInertia / (own.invInertia + inverseAbout(its, between)));
}

} // namespace

void HeldRows::add(const PointConstraint& anchors, Vec2 soFar, std::size_t) {
    point = true;
    armA = anchors.armA;
    armB = anchors.armB;
    reachA = length(armA);
    reachB = length(armB);
    error = {anchors.error.x, anchors.error.y, error[2]};
    arc = anchors.arc;
    impulse = {soFar.x, soFar.y, impulse[2]};
}

void HeldRows::add(const AxisConstraint& axis, Real soFar, std::size_t slot) {
    if (axis.axis == Vec2{}) {
        angle = true;
        angleAt = slot;
        error[2] = axis.leverB * (side == 0 ? axis.error : std::min(axis.error, Real(0)));
        impulse[2] = axis.leverB * soFar;
        return;
    }
    across = axis.axis;
    acrossAt = slot;
    error = {axis.error * across.x, axis.error * across.y, error[2]};
    impulse = {soFar * across.x, soFar * across.y, impulse[2]};
}

bool HeldRows::hold(const AxisConstraint& limit, Real soFar, Real pressed, std::size_t slot) {
    const bool presses = soFar > 0 || pressed * limit.leverB > 0 || limit.error < -kNear;
    if (limit.axis != Vec2{} || (presses ? angle : side != 0)) {
        return false;
    }
    side = limit.leverB;
    angleAt = slot;
    if (presses) {
        add(limit, soFar, slot);
    }
    return true;
}

HeldRows* ArticulatedTrees::rowsOf(std::uint32_t joint) {
    const std::uint32_t node = joint < nodeOf_.size() ? nodeOf_[joint] : kNone;
    return node == kNone ? nullptr : &nodes_[node].rows;
}

/// Adds a body to reached_. Returns its future index in members_, valid if the component is a tree.
std::uint32_t ArticulatedTrees::join(std::uint32_t body) {
    memberOf_[body] = static_cast<std::uint32_t>(members_.size() + reached_.size());
    reached_.push_back(body);
    return memberOf_[body];
}

/// Links the edges of each body, in order. Entry 2 i of next_ continues the list of the first body
/// of edge i, entry 2 i + 1 that of the second one. Other bodies are not visited.
void ArticulatedTrees::listEdges(const Bodies& bodies, std::span<const Edge> edges) {
    if (first_.size() < bodies.size()) {
        first_.resize(bodies.size(), kNone);
        memberOf_.resize(bodies.size(), kNone);
    }
    assignReusing(next_, 2 * edges.size(), kNone);
    for (std::size_t i = edges.size(); i-- > 0;) {
        const auto link = static_cast<std::uint32_t>(2 * i);
        next_[link] = std::exchange(first_[edges[i].a], link);
        next_[link + 1] = std::exchange(first_[edges[i].b], link + 1);
    }
}

/// Clears what listEdges() and join() have set.
void ArticulatedTrees::unlistEdges(std::span<const Edge> edges) {
    for (const Edge& edge : edges) {
        first_[edge.a] = first_[edge.b] = kNone;
        memberOf_[edge.a] = memberOf_[edge.b] = kNone;
    }
}

void ArticulatedTrees::find(const Bodies& bodies, std::span<const Edge> edges, Real gap) {
    gap_ = gap;
    nodes_.clear();
    members_.clear();
    trees_.clear();
    nodeOf_.clear();
    if (edges.empty()) {
        return;
    }
    listEdges(bodies, edges);
    assignReusing(used_, edges.size(), std::uint8_t{0});
    for (const bool anchored : {true, false}) {
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            if (used_[i] != 0) {
                continue;
            }
            const Edge& edge = edges[i];
            if ((bodies.locked(edge.a) || bodies.locked(edge.b)) == anchored) {
                grow(bodies, edges, i);
            }
        }
    }
    unlistEdges(edges);
    if (nodes_.empty()) {
        return;
    }
    std::uint32_t most = 0;
    for (const Edge& edge : edges) {
        most = std::max(most, edge.joint + 1);
    }
    assignReusing(nodeOf_, most, kNone);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        nodeOf_[nodes_[i].joint] = i;
    }
}

/// Adds the tree of an edge. A component with a loop is skipped. An unanchored tree that touches
/// something is skipped too, unless it is crowded: contacts and joints are solved alternately
/// there, and only soft joints let both converge.
void ArticulatedTrees::grow(const Bodies& bodies, std::span<const Edge> edges, std::uint32_t root) {
    reached_.clear();
    links_.clear();
    const Edge& edge = edges[root];
    const bool fromA = bodies.locked(edge.a);
    const bool anchored = fromA || bodies.locked(edge.b);
    if (anchored) {
        used_[root] = 1;
        links_.push_back({root, join(fromA ? edge.b : edge.a), kNone, fromA});
    } else {
        join(edge.a);
    }
    bool isTree = true;
    bool touches = false;
    for (std::size_t i = 0; i < reached_.size(); ++i) {
        touches = touches || (bodies.filter[reached_[i]].flags & kColliding) != 0;
        isTree = growFrom(bodies, edges, i) && isTree;
    }
    const bool springs = touches && !anchored; // would converge with the contacts
    if (!isTree || !(isCrowded(bodies, edges) || (!springs && isDirect(bodies, edges, anchored)))) {
        return;
    }
    trees_.push_back({nodes_.size(), links_.size(), members_.size(), reached_.size(), anchored});
    for (const std::uint32_t body : reached_) {
        const BodyVelocity& motion = bodies.motion[body];
        Member& member = members_.emplace_back();
        member.body = body;
        member.mass = 1 / motion.invMass;
        member.moment = motion.invInertia > 0 ? 1 / motion.invInertia : Real(0);
    }
    for (const Link& link : links_) {
        const Edge& held = edges[link.edge];
        nodes_.push_back({held.joint, held.a, held.b, link.child, link.parent, link.childIsB});
    }
}

/// True if the joints of a body of the component in reached_ and links_ would move it too far as
/// springs, each of which is as stiff as its own two bodies allow.
bool ArticulatedTrees::isCrowded(const Bodies& bodies, std::span<const Edge> edges) {
    joined_.assign(reached_.size(), 0);
    const auto first = static_cast<std::uint32_t>(members_.size());
    return std::any_of(links_.begin(), links_.end(), [&](const Link& link) {
        const Edge& edge = edges[link.edge];
        const auto joins = [&](std::uint32_t member) {
            if (member == kNone) {
                return false;
            }
            const std::uint32_t body = reached_[member - first];
            Real& sum = joined_[member - first];
            sum += shareOf(bodies, edge, body, edge.a == body ? edge.b : edge.a);
            return sum > kMostJoined;
        };
        return joins(link.child) || joins(link.parent);
    });
}

/// True if the component in reached_ and links_ is to be solved directly. Depends on masses and
/// joints alone, so the result lasts from step to step. A joint of an anchored tree carries the
/// part beyond it; one of a free tree carries the lighter side.
bool ArticulatedTrees::isDirect(const Bodies& bodies, std::span<const Edge> edges, bool anchored) {
    if (anchored && gap_ * static_cast<Real>(links_.size()) <= kFewJoints) {
        return true;
    }
    carried_.clear();
    for (const std::uint32_t body : reached_) {
        carried_.push_back(1 / bodies.motion[body].invMass);
    }
    const auto first = static_cast<std::uint32_t>(members_.size());
    for (auto link = links_.rbegin(); link != links_.rend(); ++link) {
        if (link->child != kNone && link->parent != kNone) {
            carried_[link->parent - first] += carried_[link->child - first];
        }
    }
    const Real total = carried_.front();
    return std::any_of(links_.begin(), links_.end(), [&](const Link& link) {
        const Edge& edge = edges[link.edge];
        if (edge.direct || link.child == kNone) {
            return edge.direct;
        }
        const Real hanging = carried_[link.child - first];
        const Real carried = anchored ? hanging : std::min(hanging, total - hanging);
        return carried * (bodies.motion[edge.a].invMass + bodies.motion[edge.b].invMass) >
               gap_ * kMostCarried;
    });
}

/// Adds the neighbours of a reached body. False if an edge closes a loop.
bool ArticulatedTrees::growFrom(const Bodies& bodies, std::span<const Edge> edges,
                                std::size_t from) {
    bool isTree = true;
    const std::uint32_t body = reached_[from];
    const auto member = static_cast<std::uint32_t>(members_.size() + from);
    for (std::uint32_t link = first_[body]; link != kNone; link = next_[link]) {
        const std::uint32_t i = link / 2;
        if (used_[i] != 0) {
            continue;
        }
        used_[i] = 1;
        const bool isA = edges[i].a == body;
        const std::uint32_t other = isA ? edges[i].b : edges[i].a;
        if (bodies.locked(other)) {
            links_.push_back({i, kNone, member, isA});
        } else if (memberOf_[other] == kNone) {
            links_.push_back({i, join(other), member, isA});
        } else {
            isTree = false;
        }
    }
    return isTree;
}

void ArticulatedTrees::findTouched(const Bodies& bodies) {
    for (Tree& tree : trees_) {
        const std::span<const Member> members = membersOf(tree);
        const bool touched = std::any_of(members.begin(), members.end(), [&](const Member& member) {
            return (bodies.filter[member.body].flags & kColliding) != 0;
        });
        tree.light = !touched;
        for (Node& node : nodesOf(tree)) {
            node.touched = touched;
            tree.light = tree.light && node.rows.hinge;
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
