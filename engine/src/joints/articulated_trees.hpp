// SPDX-License-Identifier: MIT
#pragma once

#include "joints/joint_rows.hpp"
#include "math/symmetric3.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// How the errors of equality constraints are removed: by a velocity that a relax pass removes
/// again, or by displacements (see JointSet::correct()). In loops of many joints the passes of a
/// substep do not converge, so that a part of the velocity remains and adds energy. Joints of
/// articulated trees, which are solved directly, and limits within a tolerance use the velocity.
enum class ErrorRemoval : std::uint8_t { ByVelocity, ByDisplacement };

/// Parameters of one pass over the joints.
struct JointPass {
    Real h = 0;           // s, length of the substep
    Softness stiff;       // of all rigid constraints
    bool biased = false;  // false: relax pass
    bool exact = false;   // the joint belongs to a tree, see ArticulatedTrees
    int springPasses = 0; // further passes over springs with a lag, see Softness::spring()
    bool last = true;     // of a substep, if not biased: adds the impulses to the sums of the step
    ErrorRemoval errors = ErrorRemoval::ByVelocity;
};

/// Rigid constraints of one joint: up to three rows J = (a, b) on the velocities of its bodies,
/// with the target J v = -rate error - arc.
struct HeldRows {
    std::size_t count = 0;
    std::array<Triple, 3> a{};
    std::array<Triple, 3> b{};
    Triple error{};                    // m or rad
    Triple arc{};                      // m/s, see PointConstraint
    Triple impulse{};                  // N s or N m s, accumulated
    std::array<std::size_t, 3> slot{}; // see JointSet::Joint::impulseAt
    std::size_t point = kNoPoint;      // index of the first row of the anchors
    Vec2 armA{};                       // m, from the centre of mass to the anchor
    Vec2 armB{};
    Real pull = 0;      // N, estimate of the force at the anchors
    bool hinge = false; // two rows of a revolute joint and nothing else, see JointSet::Hinge

    static constexpr std::size_t kNoPoint = 3;
    bool hasPoint() const { return point != kNoPoint; }

    void add(const PointConstraint& anchors, Vec2 soFar, std::size_t firstSlot);
    void add(const AxisConstraint& axis, Real soFar, std::size_t firstSlot);
};

/// Direct solve of joints that connect bodies without a loop [Baraff96]. It is exact for any length
/// of a chain and any mass ratio.
///
/// The changes dv of the velocities and the impulses l satisfy
///
///   M dv = J^T l,   J (v + dv) = -b,   b = rate error + arc
///
/// The linear system is as sparse as the tree. A joint connects a child to its parent. From the
/// leaves to the root, each joint eliminates its child; A and c are M and 0 for a leaf:
///
///   S = J_c A_c^-1 J_c^T,   q = -(J v + b) - J_c A_c^-1 c_c
///   A_p += J_p^T S^-1 J_p,  c_p += J_p^T S^-1 q
///
/// From the root back to the leaves: l = S^-1 q - S^-1 J_p dv_p, dv_c = A_c^-1 c_c + A_c^-1 J_c^T
/// l. A is a sum of positive terms, so mass ratios of a million lose no digits.
///
/// The system is solved again while its solution changes what it depends on: the arcs of the
/// anchors, and the forces that bound inertia from below (see begin()).
///
/// The soft solver solves a loaded tree directly. A tree is loaded if a joint carries more than
/// kMostCarried times the reduced mass of its two bodies: a soft joint opens in proportion to that
/// ratio. Small anchored trees are solved directly too; see kFewJoints. The
/// joints of other trees of revolute joints are solved one by one, as springs.
///
/// Each elimination depends on the one before. So some trees are solved side by side, node by node.
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
        bool direct = true; // false: only a load makes its tree direct
    };

    /// Finds the trees among these joints. Each joint must have a movable body.
    void find(const Bodies& bodies, std::span<const Edge> edges);
    bool empty() const { return trees_.empty(); }
    /// The rows of a joint of a tree; nullptr for other joints.
    HeldRows* rowsOf(std::uint32_t joint);

    /// Updates velocities and the impulses of all rows.
    void solve(Bodies& bodies, const JointPass& pass);

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{};

    /// A body of a tree, with its subtree.
    struct Member {
        std::uint32_t body = kNone;
        Symmetric3 inertia;                   // A
        Symmetric3::Factors factors{inertia}; // of A, once the subtree is eliminated
        Real pull = 0;                        // N m, sum of force times arm of its joints
        Real ownInertia = 0;                  // kg m^2, with the lower bound of begin()
        Real spin = 0;                        // rad/s, before the solve
        Triple push{};                        // c
        Triple change{};                      // dv
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
        std::array<Triple, 3> answer{};            // rows of J_c A_c^-1
        std::array<Triple, 3> columns{};           // of S^-1 J_p
        Triple give{};                             // see giving()
        Triple wanted{};                           // q
        Triple impulse{};                          // l; from reduce() on, S^-1 q
    };
    /// A range of nodes, from the root to the leaves, and of members.
    struct Tree {
        std::size_t firstNode;
        std::size_t nodes;
        std::size_t firstMember;
        std::size_t members;
        bool anchored;           // false: the first member has no parent joint
        bool stiff = false;      // the lower bound of inertia is in effect, see begin()
        bool factorized = false; // for the present positions and the true inertia
        bool reusable = true;    // the factors of one pass may serve another
        Real spin = 0;           // rad/s, see spinOf()
    };

    /// An edge found during the search of a tree, with the fields of its future Node.
    struct Link {
        std::uint32_t edge;
        std::uint32_t child;
        std::uint32_t parent;
        bool childIsB;
    };

    /// What a tree needs after a solution.
    enum class Next : std::uint8_t { Done, Solve, Factorize };

    void listEdges(const Bodies& bodies, std::span<const Edge> edges);
    void unlistEdges(std::span<const Edge> edges);
    void grow(const Bodies& bodies, std::span<const Edge> edges, std::uint32_t root);
    bool growFrom(const Bodies& bodies, std::span<const Edge> edges, std::size_t from);
    std::uint32_t join(std::uint32_t body);
    bool isDirect(const Bodies& bodies, std::span<const Edge> edges, bool anchored);
    void solveBatch(Bodies& bodies, const JointPass& pass, std::span<Tree> trees);
    Next nextOf(const Bodies& bodies, const Tree& tree, Real h);
    void resetInertia(const Bodies& bodies, const Tree& tree);
    void factorizeTrees(const Bodies& bodies, const JointPass& pass, std::span<Tree* const> trees);
    void solveLinear(const Bodies& bodies, const JointPass& pass, std::span<Tree* const> trees);
    Real spinOf(const Bodies& bodies, const Tree& tree);
    void addPulls(const Tree& tree);
    bool raisePulls(const Tree& tree, Real h);
    bool updateArcs(const Bodies& bodies, const Tree& tree, Real h);
    void begin(const Bodies& bodies, const JointPass& pass, Tree& tree);
    void measure(const Bodies& bodies, const JointPass& pass, Node& node);
    template <std::size_t N>
    Symmetric3 carry(Node& node);
    Triple giving(const Bodies& bodies, const Node& node, const JointPass& pass) const;
    void factorize(const Bodies& bodies, Node& node, const JointPass& pass);
    template <std::size_t N>
    void addToParent(Node& node);
    template <std::size_t N>
    void reduce(Node& node);
    template <std::size_t N>
    void backSubstitute(Node& node);
    template <typename Visit>
    void fromLeaves(std::span<Tree* const> trees, Visit visit);
    template <typename Visit>
    void fromRoots(std::span<Tree* const> trees, Visit visit);
    void apply(Bodies& bodies, const Tree& tree);
    std::span<Node> nodesOf(const Tree& tree);
    std::span<Member> membersOf(const Tree& tree);

    std::vector<Node> nodes_;
    std::vector<Tree*> unsolved_; // scratch of solveBatch()
    std::vector<Tree*> changed_;  // scratch of factorizeTrees()
    std::vector<Tree*> raised_;   // likewise: those to be factorized again
    std::vector<Member> members_;
    std::vector<Tree> trees_;
    std::vector<std::uint32_t> nodeOf_;   // by joint
    std::vector<std::uint32_t> memberOf_; // by body; kNone outside find()
    std::vector<std::uint32_t> first_;    // by body: head of its list of edges, likewise
    std::vector<std::uint32_t> next_;     // of these lists
    std::vector<std::uint8_t> used_;      // by edge
    std::vector<std::uint32_t> reached_;  // bodies of the component being searched
    std::vector<Link> links_;             // edges of that component
    std::vector<Real> carried_;           // kg, by body of that component: with its subtree
};

} // namespace KODO_PRECISION
} // namespace kodo
