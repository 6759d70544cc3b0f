// SPDX-License-Identifier: MIT
#include "joints/articulated_trees.hpp"

#include "base/vector_reuse.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Compliance of a joint that closes a loop through an immovable body, as a fraction of the inverse
// mass of its row. Without compliance the loop is over-determined and S is singular.
constexpr Real kLeastGive = Real(1) / 1024;
// Fraction of the usual compliance for such a joint. It is solved together with its tree, so it may
// be stiffer than joints that are solved one by one.
constexpr Real kLoopGive = Real(0.4);
// rad per substep: larger changes of angle come from impacts and are not predicted.
constexpr Real kMostForeseen = Real(1) / 32;

Triple velocityOf(const BodyVelocity& motion) {
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

HeldRows* ArticulatedTrees::rowsOf(std::uint32_t joint) {
    const std::uint32_t node = joint < nodeOf_.size() ? nodeOf_[joint] : kNone;
    return node == kNone ? nullptr : &nodes_[node].rows;
}

void ArticulatedTrees::foresee(std::uint32_t joint, const Foresight& gain, bool given) {
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

/// After an impact the next substep differs from the last, so large changes are not predicted.
Foresight ArticulatedTrees::foreseen(std::uint32_t joint, Real h) const {
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

/// Adds a body to reached_. Returns its future index in members_, valid if the component is a tree.
std::uint32_t ArticulatedTrees::join(std::uint32_t body) {
    memberOf_[body] = static_cast<std::uint32_t>(members_.size() + reached_.size());
    reached_.push_back(body);
    return memberOf_[body];
}

/// Lists the edges of each body, in order (counting sort).
void ArticulatedTrees::listEdges(const Bodies& bodies, std::span<const Edge> edges) {
    assignReusing(first_, bodies.size() + 1, std::uint32_t{0});
    assignReusing(incident_, 2 * edges.size(), std::uint32_t{0});
    for (const Edge& edge : edges) {
        ++first_[edge.a];
        ++first_[edge.b];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& first : first_) {
        sum += first;
        first = sum; // end of the list; decremented to its begin while the list fills
    }
    for (std::size_t i = edges.size(); i-- > 0;) {
        incident_[--first_[edges[i].b]] = static_cast<std::uint32_t>(i);
        incident_[--first_[edges[i].a]] = static_cast<std::uint32_t>(i);
    }
}

void ArticulatedTrees::find(const Bodies& bodies, std::span<const Edge> edges) {
    nodes_.clear();
    members_.clear();
    roots_.clear();
    nodeOf_.clear();
    if (edges.empty()) {
        return;
    }
    listEdges(bodies, edges);
    assignReusing(memberOf_, bodies.size(), kNone);
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
/// something is skipped too: contacts and joints are solved alternately there, and only soft joints
/// let both converge.
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

/// Adds the neighbours of a reached body. False if an edge closes a loop.
bool ArticulatedTrees::growFrom(const Bodies& bodies, std::span<const Edge> edges,
                                std::size_t from) {
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

/// Initialises A and c of every body. Tension at the anchors exerts a restoring torque on a body.
/// The step is unstable if its angular frequency exceeds 1 rad per substep. So the inertia has a
/// lower bound:
///
///   I >= h^2 sum of (pull . arm)
void ArticulatedTrees::begin(Bodies& bodies, const JointPass& pass) {
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
        BodyVelocity& motion = bodies.motion[member.body];
        const Real mass = 1 / motion.invMass;
        const Real least = member.inertia.zz;
        member.inertia = {mass, 0, mass, 0, 0, 1};
        if (motion.invInertia > 0) {
            member.inertia.zz = std::max(1 / motion.invInertia, least);
            motion.angularVelocity /= pass.biased ? member.inertia.zz * motion.invInertia : 1;
        }
    }
}

/// Sets q = -(J v + rate error) of all rows, from the velocities before the solve.
void ArticulatedTrees::measure(const Bodies& bodies, const JointPass& pass) {
    for (Node& node : nodes_) {
        HeldRows& rows = node.rows;
        const BodyVelocity& a = bodies.motion[node.a];
        const BodyVelocity& b = bodies.motion[node.b];
        for (std::size_t r = 0; r < rows.count; ++r) {
            node.wanted[r] = -dot(rows.a[r], velocityOf(a)) - dot(rows.b[r], velocityOf(b));
            if (pass.biased) {
                node.wanted[r] -= pass.stiff.biasRate * rows.error[r];
            }
            if (a.invMass > 0 && a.invInertia == 0) {
                rows.a[r][2] = 0; // the body moves without rotation
            }
            if (b.invMass > 0 && b.invInertia == 0) {
                rows.b[r][2] = 0;
            }
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
        for (std::size_t k = 0; k <= r; ++k) {
            s[r][k] = dot(answer, j[k]);
        }
    }
    return {s[0][0], s[1][0], s[1][1], s[2][0], s[2][1], s[2][2]};
}

/// S of a joint to an immovable body that closes a loop: its own compliance alone, that of a spring
/// on the mass of its body; see Softness.
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
            node.wanted[r] -= give[r] * rows.impulse[r];
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

void ArticulatedTrees::solve(Bodies& bodies, const JointPass& pass) {
    begin(bodies, pass);
    measure(bodies, pass);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        eliminate(bodies, nodes_[i], pass);
    }
    for (const std::uint32_t root : roots_) {
        Member& member = members_[root];
        member.change = Symmetric3::Factors(member.inertia).solve(member.push);
    }
    for (Node& node : nodes_) {
        backSubstitute(node);
    }
    for (Member& member : members_) {
        BodyVelocity& motion = bodies.motion[member.body];
        motion.velocity += Vec2{member.change[0], member.change[1]};
        motion.angularVelocity += member.change[2];
        member.gain = 0; // the change is applied now
        member.given = 0;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
