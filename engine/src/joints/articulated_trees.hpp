// SPDX-License-Identifier: MIT
#pragma once

#include "joints/joint_rows.hpp"
#include "math/symmetric3.hpp"

#include <array>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Predicted change of the angular velocities of both bodies by a joint of a tree: the change of
/// the last substep.
struct Foresight {
    Real spinA = 0; // rad/s
    Real spinB = 0;
};

/// Parameters of one pass over the joints.
struct JointPass {
    Real h = 0;          // s, length of the substep
    Softness stiff;      // of all rigid constraints
    bool biased = false; // false: relax pass
    bool exact = false;  // the joint belongs to a tree, see ArticulatedTrees
    Foresight foreseen{};
};

/// Rigid constraints of one joint: up to three rows J = (a, b) on the velocities of its bodies,
/// with the target J v = -rate error.
struct HeldRows {
    std::size_t count = 0;
    std::array<Triple, 3> a{};
    std::array<Triple, 3> b{};
    Triple error{};                    // m or rad
    Triple impulse{};                  // N s or N m s, accumulated
    std::array<std::size_t, 3> slot{}; // see JointSet::Joint::impulseAt
    Vec2 pull;                         // N, on b, mean of the last solved step
    Real stretchA = 0; // N m, (force on a) . armA; > 0: away from a's centre of mass
    Real stretchB = 0; // N m, (force on b) . armB

    void add(const PointConstraint& point, Vec2 soFar, std::size_t firstSlot);
    void add(const AxisConstraint& axis, Real soFar, std::size_t firstSlot);
};

/// Direct solve of joints that connect bodies without a loop [Baraff96]. It is exact for any length
/// of a chain and any mass ratio.
///
/// The changes dv of the velocities and the impulses l satisfy
///
///   M dv = J^T l,   J (v + dv) = -rate error
///
/// The linear system is as sparse as the tree. A joint connects a child to its parent. From the
/// leaves to the root, each joint eliminates its child; A and c are M and 0 for a leaf:
///
///   S = J_c A_c^-1 J_c^T,   q = -(J v + rate error) - J_c A_c^-1 c_c
///   A_p += J_p^T S^-1 J_p,  c_p += J_p^T S^-1 q
///
/// From the root back to the leaves: l = S^-1 (q - J_p dv_p), dv_c = A_c^-1 (c_c + J_c^T l). A is a
/// sum of positive terms, so mass ratios of a million lose no digits.
///
/// A tree has at most one joint to an immovable body as its root. Further joints to immovable
/// bodies close loops; they are soft, within the direct solve. Joints of any other loop, and of an
/// unanchored tree that touches something, are not part of a tree: they are solved one by one, as
/// springs.
class ArticulatedTrees {
public:
    /// A joint that may belong to a tree, and its bodies.
    struct Edge {
        std::uint32_t joint;
        std::uint32_t a;
        std::uint32_t b;
    };

    /// Finds the trees among these joints. Each joint must have a movable body.
    void find(const Bodies& bodies, std::span<const Edge> edges);
    /// The rows of a joint of a tree; nullptr for other joints.
    HeldRows* rowsOf(std::uint32_t joint);
    /// Adds the predicted change by a joint of a tree; `given`: it is already applied.
    void foresee(std::uint32_t joint, const Foresight& gain, bool given);
    /// Predicted change that is not applied yet, by all joints, for the bodies of this joint.
    Foresight foreseen(std::uint32_t joint, Real h) const;

    /// Updates velocities and the impulses of all rows.
    void solve(Bodies& bodies, const JointPass& pass);

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{};

    /// A body of a tree, with its subtree.
    struct Member {
        std::uint32_t body = kNone;
        Symmetric3 inertia;                   // A
        Symmetric3::Factors factors{inertia}; // of A, once the subtree is eliminated
        Triple push{};                        // c
        Triple change{};                      // dv
        Real gain = 0;                        // rad/s, predicted change
        Real given = 0;                       // rad/s, part of gain that is already applied
    };
    /// A joint of a tree. It has a child, a parent, or both; a missing one is an immovable body.
    struct Node {
        std::uint32_t joint;
        std::uint32_t a; // bodies
        std::uint32_t b;
        std::uint32_t child = kNone;  // index in members_
        std::uint32_t parent = kNone; // index in members_
        bool childIsB = true;
        HeldRows rows{};
        Symmetric3::Factors factors{Symmetric3{}}; // of S
        Triple wanted{};                           // q
    };

    /// An edge found during the search of a tree, with the fields of its future Node.
    struct Link {
        std::uint32_t edge;
        std::uint32_t child;
        std::uint32_t parent;
        bool childIsB;
    };

    void listEdges(const Bodies& bodies, std::span<const Edge> edges);
    void grow(const Bodies& bodies, std::span<const Edge> edges, std::uint32_t root);
    bool growFrom(const Bodies& bodies, std::span<const Edge> edges, std::size_t from);
    std::uint32_t join(std::uint32_t body);
    void begin(Bodies& bodies, const JointPass& pass);
    void measure(const Bodies& bodies, const JointPass& pass);
    Symmetric3 carry(Node& node);
    Symmetric3 giving(const Bodies& bodies, Node& node, const JointPass& pass) const;
    void eliminate(const Bodies& bodies, Node& node, const JointPass& pass);
    void backSubstitute(Node& node);

    std::vector<Node> nodes_; // from the roots to the leaves
    std::vector<Member> members_;
    std::vector<std::uint32_t> roots_;    // members without a parent joint
    std::vector<std::uint32_t> nodeOf_;   // by joint
    std::vector<std::uint32_t> memberOf_; // by body; only within find()
    std::vector<std::uint32_t> first_;    // by body: index of its first edge in incident_
    std::vector<std::uint32_t> incident_; // edges
    std::vector<std::uint8_t> used_;      // by edge
    std::vector<std::uint32_t> reached_;  // bodies of the component being searched
    std::vector<Link> links_;             // edges of that component
};

} // namespace KODO_PRECISION
} // namespace kodo
