// SPDX-License-Identifier: MIT
#include <kodo/base/refill.hpp>
#include <kodo/joints/joint_trees.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

// Of a row's inverse mass: how much a joint gives within a pass that closes a loop through the
// ground. Nothing else gives way there, and something must.
constexpr Real kLeastGive = Real(1) / 1024;
// A spring that closes a loop so is solved together with all that hangs on it, and therefore may be
// stiffer than those that take turns.
constexpr Real kLoopGive = Real(0.4);
// rad in a substep: what can be foreseen is smooth.
constexpr Real kMostForeseen = Real(1) / 32;

Triple velocityOf(const Motion& motion) {
    return {motion.velocity.x, motion.velocity.y, motion.angularVelocity};
}

} // namespace

void HeldRows::add(const PointConstraint& point, Vec2 soFar, std::size_t firstSlot) {
    const Vec2 p = point.armA;
    const Vec2 q = point.armB;
    a[count] = {-1, 0, p.y};
    b[count] = {1, 0, -q.y};
    error[count] = point.error.x;
    slot[count] = firstSlot;
    impulse[count++] = soFar.x;
    a[count] = {0, -1, -p.x};
    b[count] = {0, 1, q.x};
    error[count] = point.error.y;
    slot[count] = firstSlot + 1;
    impulse[count++] = soFar.y;
    stretchA = -dot(pull, p);
    stretchB = dot(pull, q);
}

void HeldRows::add(const AxisConstraint& axis, Real soFar, std::size_t firstSlot) {
    a[count] = {-axis.axis.x, -axis.axis.y, -axis.leverA};
    b[count] = {axis.axis.x, axis.axis.y, axis.leverB};
    error[count] = axis.error;
    slot[count] = firstSlot;
    impulse[count++] = soFar;
}

HeldRows* JointTrees::rowsOf(std::uint32_t joint) {
    const std::uint32_t node = joint < nodeOf_.size() ? nodeOf_[joint] : kNone;
    return node == kNone ? nullptr : &nodes_[node].rows;
}

void JointTrees::foresee(std::uint32_t joint, const Foresight& gain, bool given) {
    const Node& node = nodes_[nodeOf_[joint]];
    const auto add = [&](std::uint32_t member, Real spin) {
        if (member != kNone) {
            members_[member].gain += spin;
            members_[member].given += given ? spin : 0;
        }
    };
    add(node.child, node.childIsB ? gain.spinB : gain.spinA);
    add(node.parent, node.childIsB ? gain.spinA : gain.spinB);
}

/// After a blow the next substep will not be like the last: what would be much is not foreseen.
Foresight JointTrees::foreseen(std::uint32_t joint, Real h) const {
    const Node& node = nodes_[nodeOf_[joint]];
    const auto gainOf = [&](std::uint32_t member) {
        if (member == kNone) {
            return Real(0);
        }
        const Real gain = members_[member].gain;
        return (std::abs(h * gain) < kMostForeseen ? gain : 0) - members_[member].given;
    };
    const Real ofChild = gainOf(node.child);
    const Real ofParent = gainOf(node.parent);
    return node.childIsB ? Foresight{ofParent, ofChild} : Foresight{ofChild, ofParent};
}

/// A place in members_, should all that is reached be a tree.
std::uint32_t JointTrees::join(std::uint32_t body) {
    memberOf_[body] = static_cast<std::uint32_t>(members_.size() + reached_.size());
    reached_.push_back(body);
    return memberOf_[body];
}

/// The edges of each body that can be moved, in order.
void JointTrees::listEdges(const Bodies& bodies, std::span<const Edge> edges) {
    refill(first_, bodies.size() + 1, std::uint32_t{0});
    refill(incident_, 2 * edges.size(), std::uint32_t{0});
    for (const Edge& edge : edges) {
        ++first_[edge.a];
        ++first_[edge.b];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& first : first_) {
        sum += first;
        first = sum; // the end, moved down to the beginning as the list fills
    }
    for (std::size_t i = edges.size(); i-- > 0;) {
        incident_[--first_[edges[i].b]] = static_cast<std::uint32_t>(i);
        incident_[--first_[edges[i].a]] = static_cast<std::uint32_t>(i);
    }
}

void JointTrees::find(const Bodies& bodies, std::span<const Edge> edges) {
    nodes_.clear();
    members_.clear();
    roots_.clear();
    nodeOf_.clear();
    if (edges.empty()) {
        return;
    }
    listEdges(bodies, edges);
    refill(memberOf_, bodies.size(), kNone);
    refill(used_, edges.size(), std::uint8_t{0});
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
    if (nodes_.empty()) {
        return;
    }
    std::uint32_t most = 0;
    for (const Edge& edge : edges) {
        most = std::max(most, edge.joint + 1);
    }
    refill(nodeOf_, most, kNone);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        nodeOf_[nodes_[i].joint] = i;
    }
}

/// The tree that an edge belongs to; nothing if there is a loop in it, or if it lies about loose
/// and touches something: contacts take turns with its joints, and only joints that give a little
/// let the two come to rest.
void JointTrees::grow(const Bodies& bodies, std::span<const Edge> edges, std::uint32_t root) {
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
    bool fit = true;
    for (std::size_t i = 0; i < reached_.size(); ++i) {
        const Flags flags = bodies.filter[reached_[i]].flags;
        const bool isTree = growFrom(bodies, edges, i);
        fit = fit && isTree && (anchored || (flags & kColliding) == 0);
    }
    if (!fit) {
        return;
    }
    if (!anchored) {
        roots_.push_back(static_cast<std::uint32_t>(members_.size()));
    }
    for (const std::uint32_t body : reached_) {
        members_.emplace_back().body = body;
    }
    for (const Link& link : links_) {
        const Edge& held = edges[link.edge];
        nodes_.push_back({held.joint, held.a, held.b, link.child, link.parent, link.childIsB});
    }
}

/// Adds what hangs on a body that was reached. False if that closes a loop.
bool JointTrees::growFrom(const Bodies& bodies, std::span<const Edge> edges, std::size_t from) {
    bool isTree = true;
    const std::uint32_t body = reached_[from];
    const auto member = static_cast<std::uint32_t>(members_.size() + from);
    for (std::uint32_t k = first_[body]; k < first_[body + 1]; ++k) {
        const std::uint32_t i = incident_[k];
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

/// Every body with nothing hanging on it yet. One that its joints draw apart is turned back by them
/// like a string under tension, and if that is faster than substeps can follow, it would shake
/// itself to pieces. So it is taken for one of at least the inertia that they can follow, by a
/// radian in each:
///
///   I >= h^2 sum of (pull . arm)
void JointTrees::begin(Bodies& bodies, const JointPass& pass) {
    for (Member& member : members_) {
        member.push = {};
        member.inertia.zz = 0;
    }
    const auto stretch = [&](std::uint32_t member, Real amount) {
        if (member != kNone) {
            members_[member].inertia.zz += pass.h * pass.h * amount;
        }
    };
    for (const Node& node : nodes_) {
        const HeldRows& rows = node.rows;
        stretch(node.child, node.childIsB ? rows.stretchB : rows.stretchA);
        stretch(node.parent, node.childIsB ? rows.stretchA : rows.stretchB);
    }
    for (Member& member : members_) {
        Motion& motion = bodies.motion[member.body];
        const Real mass = 1 / motion.invMass;
        const Real least = member.inertia.zz;
        member.inertia = {mass, 0, mass, 0, 0, 1};
        if (motion.invInertia > 0) {
            member.inertia.zz = std::max(1 / motion.invInertia, least);
            motion.angularVelocity /= pass.biased ? member.inertia.zz * motion.invInertia : 1;
        }
    }
}

/// Finds J v + rate error of all rows, while nothing has changed yet.
void JointTrees::measure(const Bodies& bodies, const JointPass& pass) {
    for (Node& node : nodes_) {
        HeldRows& rows = node.rows;
        const Motion& a = bodies.motion[node.a];
        const Motion& b = bodies.motion[node.b];
        for (std::size_t r = 0; r < rows.count; ++r) {
            node.wanted[r] = -dot(rows.a[r], velocityOf(a)) - dot(rows.b[r], velocityOf(b));
            if (pass.biased) {
                node.wanted[r] -= pass.stiff.biasRate * rows.error[r];
            }
            if (a.invMass > 0 && a.invInertia == 0) {
                rows.a[r][2] = 0; // it is moved, but not turned
            }
            if (b.invMass > 0 && b.invInertia == 0) {
                rows.b[r][2] = 0;
            }
        }
    }
}

/// S of a joint with something hanging on it. It takes that into account in q.
Symmetric3 JointTrees::carry(Node& node) {
    Member& child = members_[node.child];
    child.factors = Symmetric3::Factors(child.inertia);
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.b : rows.a;
    Real s[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t r = 0; r < rows.count; ++r) {
        const Triple answer = child.factors.solve(j[r]);
        node.wanted[r] -= dot(answer, child.push);
        for (std::size_t k = 0; k <= r; ++k) {
            s[r][k] = dot(answer, j[k]);
        }
    }
    return {s[0][0], s[1][0], s[1][1], s[2][0], s[2][1], s[2][2]};
}

/// S of a joint that closes a loop through the ground: nothing gives but itself, as a spring with
/// the mass of the body it holds does; see Softness.
Symmetric3 JointTrees::giving(const Bodies& bodies, Node& node, const JointPass& pass) const {
    const HeldRows& rows = node.rows;
    const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
    const Motion& motion = bodies.motion[members_[node.parent].body];
    Real give[3] = {1, 1, 1};
    for (std::size_t r = 0; r < rows.count; ++r) {
        const Triple& row = j[r];
        const Real inverseMass = motion.invMass * (row[0] * row[0] + row[1] * row[1]) +
                                 motion.invInertia * row[2] * row[2];
        give[r] = kLeastGive * inverseMass;
        if (pass.biased && pass.stiff.impulseScale > 0) {
            give[r] = kLoopGive * pass.stiff.impulseScale / pass.stiff.massScale * inverseMass;
            node.wanted[r] -= give[r] * rows.impulse[r];
        }
    }
    return {give[0], 0, give[1], 0, 0, give[2]};
}

/// Takes a joint, with what hangs on it, into what it hangs on.
void JointTrees::takeIn(const Bodies& bodies, Node& node, const JointPass& pass) {
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

/// With the parent's change known: the impulse, and the child's change.
void JointTrees::giveBack(Node& node) {
    HeldRows& rows = node.rows;
    if (node.parent != kNone) {
        const Triple& change = members_[node.parent].change;
        const std::array<Triple, 3>& j = node.childIsB ? rows.a : rows.b;
        for (std::size_t r = 0; r < rows.count; ++r) {
            node.wanted[r] -= dot(j[r], change);
        }
    }
    const Triple impulse = node.factors.solve(node.wanted);
    for (std::size_t r = 0; r < rows.count; ++r) {
        rows.impulse[r] += impulse[r];
    }
    if (node.child == kNone) {
        return;
    }
    Member& child = members_[node.child];
    const std::array<Triple, 3>& j = node.childIsB ? rows.b : rows.a;
    Triple push = child.push;
    for (std::size_t r = 0; r < rows.count; ++r) {
        for (std::size_t k = 0; k < 3; ++k) {
            push[k] += impulse[r] * j[r][k];
        }
    }
    child.change = child.factors.solve(push);
}

void JointTrees::solve(Bodies& bodies, const JointPass& pass) {
    begin(bodies, pass);
    measure(bodies, pass);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        takeIn(bodies, nodes_[i], pass);
    }
    for (const std::uint32_t root : roots_) {
        Member& member = members_[root];
        member.change = Symmetric3::Factors(member.inertia).solve(member.push);
    }
    for (Node& node : nodes_) {
        giveBack(node);
    }
    for (Member& member : members_) {
        Motion& motion = bodies.motion[member.body];
        motion.velocity += Vec2{member.change[0], member.change[1]};
        motion.angularVelocity += member.change[2];
        member.gain = 0; // it has come
        member.given = 0;
    }
}

} // namespace kodo::inline KODO_PRECISION
