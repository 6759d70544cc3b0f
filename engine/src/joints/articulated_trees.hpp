// SPDX-License-Identifier: MIT
#pragma once

#include "joints/joint_rows.hpp"
#include "math/symmetric3.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
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
    bool settle = true;   // false: a tree may leave its relax pass to the next substep
    bool last = true;     // of a substep, if not biased: adds the impulses to the sums of the step
    ErrorRemoval errors = ErrorRemoval::ByVelocity;
    /// m/s; largest velocity that closes a gap of a tree. A tree that touches something has a
    /// quarter of it.
    Real mostBias = std::numeric_limits<Real>::infinity();
};

/// The rigid constraints of one joint, on the motion of b relative to a at anchor b: along x and y,
/// and about the anchor.
struct HeldRows {
    Vec2 armA{};      // m, from the centre of mass of a to anchor b
    Vec2 armB{};      // m, likewise
    Triple error{};   // m and rad
    Vec2 arc{};       // m/s, see PointConstraint
    Triple impulse{}; // N s and N m s, on b, accumulated
    Vec2 across{};    // unit; of a slider: the direction that is held; else zero
    bool point = false;
    bool angle = false;       // the relative angle is held
    Real side = 0;            // of a limit that is reached: above 0 for the lower one, else below
    std::size_t acrossAt = 0; // see JointSet::Joint::impulseAt
    std::size_t angleAt = 0;
    Real reachA = 0;    // m, length of armA
    Real reachB = 0;    // m
    Real pull = 0;      // N, estimate of the force at the anchors
    bool hinge = false; // a revolute joint and nothing else, see JointSet::Hinge
    bool lazy = false;  // see ArticulatedTrees::Tree

    static constexpr Real kNear = Real(1) / 512; // rad, of a limit that is reached

    void add(const PointConstraint& anchors, Vec2 soFar, std::size_t slot);
    void add(const AxisConstraint& axis, Real soFar, std::size_t slot);
    /// Holds the angle at a limit that is reached, if it presses, or did: `pressed` is `side` of
    /// the substep before. False if the limit is solved alone: along an axis, or beside the other
    /// one of an angle that cannot move.
    bool hold(const AxisConstraint& limit, Real soFar, Real pressed, std::size_t slot);
};

/// Direct solve of joints that connect bodies without a loop, as articulated bodies
/// [Featherstone08]. It is exact for any length of a chain and any mass ratio.
///
/// Each joint eliminates its child, from the leaves to the root. With A and c as the inertia and
/// the impulse of a child and its subtree at anchor b, e as the motion that the joint leaves free
/// and w as the change of relative velocity that it wants:
///
///   u = A e,  d = e . u,  A' = A - u u^T / d,  c' = c - u (e . c) / d
///   A_p += A',  c_p += c' - A' w
///
/// From the root back to the leaves, with t_p as the change of the parent at anchor b:
///
///   m = t_p + w,  t_c = m + e (e . c - u . m) / d,  impulse on the child = A' m - c'
///
/// The system is solved again while its solution changes what it depends on: the arcs of the
/// anchors, and the forces that bound inertia from below (see begin()).
///
/// The soft solver solves a loaded tree directly: one in which a joint carries many times the
/// reduced mass of its two bodies, since a soft joint opens in proportion to that ratio. Small
/// anchored trees are solved directly too; see kFewJoints. The joints of other trees of revolute
/// joints are solved one by one, as springs.
///
/// Each elimination depends on the one before. So some trees are solved side by side, node by node.
///
/// A limit of an angle that is reached is held as long as it presses: alone it would see the mass
/// of two bodies only. If it pulls in the solution, it is released, and the tree is solved again.
/// If its angle then closes, the next pass holds it.
///
/// A tree has at most one joint to an immovable body as its root. Further joints to immovable
/// bodies close loops; they are soft, within the direct solve. Joints of any other loop, and of an
/// unanchored tree that touches something, are not part of a tree: they are solved one by one, as
/// springs. Trees with a body of too many joints for springs are solved directly in any case.
class ArticulatedTrees {
public:
    /// A joint that may belong to a tree, and its bodies.
    struct Edge {
        std::uint32_t joint;
        std::uint32_t a;
        std::uint32_t b;
        bool direct = true; // false: only a load makes its tree direct
    };

    /// Finds the trees among these joints. Each joint must have a movable body. `gap`: see
    /// SoftSettings::jointGap; with 0 every tree is solved directly.
    void find(const Bodies& bodies, std::span<const Edge> edges, Real gap);
    bool empty() const { return trees_.empty(); }
    /// The rows of a joint of a tree; nullptr for other joints.
    HeldRows* rowsOf(std::uint32_t joint);

    /// Finds the trees that touch something, and the light ones. The flag `hinge` of their rows
    /// must be set.
    void findTouched(const Bodies& bodies);
    bool allLazy() const {
        return std::all_of(trees_.begin(), trees_.end(),
                           [](const Tree& tree) { return tree.lazy; });
    }
    /// Updates velocities and the impulses of all rows.
    void solve(Bodies& bodies, const JointPass& pass);

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{};

    /// A body of a tree, with its subtree.
    struct Member {
        std::uint32_t body = kNone;
        Real mass = 0;       // kg
        Real moment = 0;     // kg m^2, of the body alone
        Symmetric3 inertia;  // A, at the centre of mass
        Real pull = 0;       // N m, sum of force times arm of its joints
        Real ownInertia = 0; // kg m^2, with the lower bound of begin()
        Real spin = 0;       // rad/s, before the solve
        Triple push{};       // c, at the centre of mass
        Triple change{};     // of the velocity
    };
    /// A joint of a tree. It has a child, a parent, or both; a missing one is an immovable body.
    struct Node {
        std::uint32_t joint = kNone;
        std::uint32_t a = kNone; // bodies
        std::uint32_t b = kNone;
        std::uint32_t child = kNone;  // index in members_
        std::uint32_t parent = kNone; // index in members_
        bool childIsB = true;
        bool touched = false; // a body of the tree touches something
        HeldRows rows{};
        Symmetric3 carried{}; // A'
        Triple answer{};      // u
        Real perAnswer = 0;   // 1 / d; 0 without a free motion
        Real freely = 0;      // (e . c) / d
        Triple base{};        // w without the arc
        Triple wanted{};      // w
        Triple load{};        // c'
        Triple impulse{};     // on b

        /// False if the joint fixes its bodies to each other.
        bool movesFreely() const { return !rows.angle || rows.across != Vec2{}; }
        Vec2 childArm() const { return childIsB ? rows.armB : rows.armA; }
        Vec2 parentArm() const { return childIsB ? rows.armA : rows.armB; }
        Triple freeAxis() const;
    };
    /// A range of nodes, from the root to the leaves, and of members.
    struct Tree {
        std::size_t firstNode;
        std::size_t nodes;
        std::size_t firstMember;
        std::size_t members;
        bool anchored; // false: the first member has no parent joint
        /// Only hinges, and nothing is touched. The solve of a substep then removes what the relax
        /// pass of the one before would have removed, at the same positions.
        bool light = false;
        bool lazy = false; // light, and the lower bound of inertia was not in effect, see begin()
        Real spin = 0;     // rad/s, see spinOf()
    };

    /// An edge found during the search of a tree, with the fields of its future Node.
    struct Link {
        std::uint32_t edge;
        std::uint32_t child;
        std::uint32_t parent;
        bool childIsB;
    };

    void listEdges(const Bodies& bodies, std::span<const Edge> edges);
    void unlistEdges(std::span<const Edge> edges);
    void grow(const Bodies& bodies, std::span<const Edge> edges, std::uint32_t root);
    bool growFrom(const Bodies& bodies, std::span<const Edge> edges, std::size_t from);
    std::uint32_t join(std::uint32_t body);
    bool isCrowded(const Bodies& bodies, std::span<const Edge> edges);
    bool isDirect(const Bodies& bodies, std::span<const Edge> edges, bool anchored);
    void solveBatch(Bodies& bodies, const JointPass& pass);
    void factorizeTrees(const Bodies& bodies, const JointPass& pass, std::span<Tree* const> trees);
    void solveLinear(std::span<Tree* const> trees);
    Real spinOf(const Bodies& bodies, const Tree& tree);
    void addPulls(const Bodies& bodies, const JointPass& pass, const Tree& tree);
    bool raisePulls(const Bodies& bodies, const JointPass& pass, const Tree& tree);
    bool updateArcs(const Bodies& bodies, const Tree& tree, Real h);
    void begin(const Bodies& bodies, const JointPass& pass, Tree& tree);
    void measure(const Bodies& bodies, const JointPass& pass, Node& node);
    Symmetric3 closing(const Bodies& bodies, const Node& node, const JointPass& pass) const;
    void eliminate(const Bodies& bodies, const JointPass& pass, Node& node);
    void reduce(Node& node);
    void backSubstitute(Node& node);
    template <typename Visit>
    void forNodes(std::span<Tree* const> trees, bool fromLeaves, Visit visit);
    void apply(Bodies& bodies, const Tree& tree);
    std::span<Node> nodesOf(const Tree& tree) {
        return std::span(nodes_).subspan(tree.firstNode, tree.nodes);
    }
    std::span<Member> membersOf(const Tree& tree) {
        return std::span(members_).subspan(tree.firstMember, tree.members);
    }

    std::vector<Node> nodes_;
    std::vector<Tree*> batch_;    // solved side by side
    std::vector<Tree*> unsolved_; // scratch of solveBatch()
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
    std::vector<Real> joined_;            // by body of that component, see kMostJoined
    Real gap_ = 0;                        // see find()
};

} // namespace KODO_PRECISION
} // namespace kodo
