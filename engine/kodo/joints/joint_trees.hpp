// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joints/joint_rows.hpp>
#include <kodo/math/symmetric3.hpp>

#include <array>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// What a joint of a tree will do to the angular velocities of its bodies, if that is what it did
/// in the last substep.
struct Foresight {
    Real spinA = 0; // rad/s
    Real spinB = 0;
};

/// Times of one substep and how stiff joints are.
struct JointPass {
    Real h = 0; // s
    Softness stiff;
    bool biased = false;
    bool exact = false; // of a joint that belongs to a tree, see JointTrees
    Foresight foreseen{};
};

/// What one joint holds rigidly: up to three rows J = (a, b) of the velocities of its two bodies,
/// to be driven to J v = -rate error.
struct HeldRows {
    std::size_t count = 0;
    std::array<Triple, 3> a{};
    std::array<Triple, 3> b{};
    Triple error{};                    // m or rad
    Triple impulse{};                  // N s or N m s so far
    std::array<std::size_t, 3> slot{}; // where the joint keeps it
    Vec2 pull;                         // N, on b, of late
    Real stretchA = 0; // N m; how much of it draws a's anchor away from a's centre of mass
    Real stretchB = 0;

    void add(const PointConstraint& point, Vec2 soFar, std::size_t firstSlot);
    void add(const AxisConstraint& axis, Real soFar, std::size_t firstSlot);
};

/// Joints that hold bodies together without closing a loop, solved all at once, however long the
/// chain and however unequal its masses [Baraff96].
///
/// The changes dv of the velocities and the impulses l satisfy
///
///   M dv = J^T l,   J (v + dv) = -rate error
///
/// which is a linear system as sparse as the tree is. From the leaves to the root each joint takes
/// in what hangs on it: with A and c of the bodies hanging there (M and 0 of a leaf),
///
///   S = J_c A_c^-1 J_c^T,   q = -(J v + rate error) - J_c A_c^-1 c_c
///   A_p += J_p^T S^-1 J_p,  c_p += J_p^T S^-1 q
///
/// and from the root back, l = S^-1 (q - J_p dv_p), dv_c = A_c^-1 (c_c + J_c^T l). There are only
/// sums of positive things in A, so masses a million times apart lose no digits.
///
/// A tree hangs from one immovable body at most. Where it is tied to more, the further joints close
/// loops through the ground; they are springs, as all joints of a loop are, and those of a tree
/// that lies about loose and touches something.
class JointTrees {
public:
    /// A joint that may belong to a tree, and its bodies.
    struct Edge {
        std::uint32_t joint;
        std::uint32_t a;
        std::uint32_t b;
    };

    /// Finds the trees that joints form. Each has a body that can be pushed.
    void find(const Bodies& bodies, std::span<const Edge> edges);
    /// Where a joint of a tree notes what it holds; nullptr for the others.
    HeldRows* rowsOf(std::uint32_t joint);
    /// Adds what a joint of a tree will do; `given` if it has done so by now.
    void foresee(std::uint32_t joint, const Foresight& gain, bool given);
    /// What is still to come of all of them for the bodies of one, until the next solve.
    Foresight foreseen(std::uint32_t joint, Real h) const;

    /// Changes velocities and the impulses of all rows.
    void solve(Bodies& bodies, const JointPass& pass);

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{};

    /// A body of a tree, with what hangs on it.
    struct Member {
        std::uint32_t body = kNone;
        Symmetric3 inertia;                   // A
        Symmetric3::Factors factors{inertia}; // of A, when all of it is there
        Triple push{};                        // c
        Triple change{};                      // dv
        Real gain = 0;                        // rad/s, foreseen
        Real given = 0;                       // rad/s, how much of that it has by now
    };
    /// A joint of a tree. It has a child (what hangs on it), or a parent, or both; the other is
    /// immovable.
    struct Node {
        std::uint32_t joint;
        std::uint32_t a; // its bodies
        std::uint32_t b;
        std::uint32_t child = kNone; // places in members_
        std::uint32_t parent = kNone;
        bool childIsB = true;
        HeldRows rows{};
        Symmetric3::Factors factors{Symmetric3{}}; // of S
        Triple wanted{};                           // q
    };

    /// An edge on the way to all that hangs together, and what it will be as a Node.
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
    void takeIn(const Bodies& bodies, Node& node, const JointPass& pass);
    void giveBack(Node& node);

    std::vector<Node> nodes_; // from the roots to the leaves
    std::vector<Member> members_;
    std::vector<std::uint32_t> roots_;    // members that hang on nothing
    std::vector<std::uint32_t> nodeOf_;   // by joint
    std::vector<std::uint32_t> memberOf_; // by body; while finding
    std::vector<std::uint32_t> first_;    // by body: where its edges begin in incident_
    std::vector<std::uint32_t> incident_; // edges
    std::vector<std::uint8_t> used_;      // by edge
    std::vector<std::uint32_t> reached_;  // bodies that hang together
    std::vector<Link> links_;             // and how
};

} // namespace kodo::inline KODO_PRECISION
