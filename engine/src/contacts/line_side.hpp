// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "collide/one_sided.hpp"
#include "contacts/hiding_step.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// A contact of a two-sided line that shares a vertex with another one of its body. Contacts are
/// soft, so a thin shape lies a little below such a line. Its place alone does not give the side
/// then, least of all at the vertex. So the contact stores the side, as its normal.
struct JointedLine {
    bool isA = false; // the line is the part of body a
    std::uint32_t body = 0;
    std::uint16_t part = 0;
    std::uint32_t otherBody = 0;
    std::uint16_t otherPart = 0;
};

/// The jointed line of a pair; none if both parts are lines of this kind, or the other part has a
/// front of its own.
std::optional<JointedLine> findJointedLine(const Bodies& bodies, const ContactKey& key);
inline std::optional<JointedLine> jointedLineOf(const Bodies& bodies, const ContactKey& key) {
    return bodies.thinnest > 0 ? std::nullopt : findJointedLine(bodies, key); // lines are thin
}

/// Side of a line on which the other shape is.
struct JointedSide {
    Real side = 1; // 1 for that of normals[1], else -1
    Real sink = 0; // m; depth on the other side up to which the middle of the shape may be
};

/// The side of the last step, unless the middle of the shape is now deeper on the other side than
/// contacts let it sink: by the margin, or twice as deep as the contact of the last step.
JointedSide jointedSideOf(const Bodies& bodies, const Contact& contact, const JointedLine& line,
                          Real margin);

/// The manifold on that side. Without a contact point, its normal still gives the side.
Manifold collideOnSide(const Bodies& bodies, const ContactKey& key, const JointedLine& line,
                       JointedSide side, const ContactLimits& limits);

/// Copies the side from line to line: a shape that slides over the vertex onto the next line stays
/// on the side on which it touched the last one.
class LineSides {
public:
    /// Must be called after contacts were added, removed or moved.
    void link(const Bodies& bodies, std::span<const Contact> contacts,
              std::span<const ContactSummary> summaries);
    bool empty() const { return groups_.empty(); }
    /// Finds the manifolds of this step again that are on the wrong side.
    void spread(const HidingStep& step) const;

private:
    struct Member {
        JointedLine line;
        std::uint32_t slot = 0;
    };
    void copySide(const HidingStep& step, const Member& from, const Member& to) const;

    std::vector<Member> groups_; // in order; a group has the same other part and body of lines
};

} // namespace KODO_PRECISION
} // namespace kodo
