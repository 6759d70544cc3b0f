// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "collide/one_sided.hpp"
#include "contacts/contact_store.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// A contact of a two-sided line, of a chain or of locked ground. Contacts are soft, so a thin
/// shape lies a little below such a line. Its place alone does not give the side then, least of all
/// at a vertex. So the contact stores the side.
struct JointedLine {
    bool isA = false; // the line is the part of body a
    std::uint32_t body = 0;
    std::uint16_t part = 0;
    std::uint32_t otherBody = 0;
    std::uint16_t otherPart = 0;
};

/// The line of this kind of a pair; none if both parts are such lines, or the other part has a
/// front of its own. A lone line has sides only for shapes without thickness.
std::optional<JointedLine> findJointedLine(const Bodies& bodies, const ContactKey& key);
inline std::optional<JointedLine> jointedLineOf(const Bodies& bodies, const ContactKey& key) {
    const bool mayBeLine =
        !(bodies.extent[key.bodyA].coreRadius > 0) || !(bodies.extent[key.bodyB].coreRadius > 0);
    return mayBeLine ? findJointedLine(bodies, key) : std::nullopt;
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

/// The manifold on that side.
Manifold collideOnSide(const Bodies& bodies, const ContactKey& key, const JointedLine& line,
                       JointedSide side, const ContactLimits& limits);

/// Copies the side from line to line: a shape that slides over the vertex onto the next line stays
/// on the side on which it touched the last one.
class LineSides {
public:
    struct Spread {
        const Bodies& bodies;
        ContactStore& store;
        Real margin; // m
    };
    /// At the end of a step, when it is known what touches, and for new contacts. `changed`:
    /// contacts were added, removed or moved since the last step.
    void spread(const Spread& step, bool changed);

private:
    void link(const Spread& step);
    static Real sideFrom(const Spread& step, const Contact& carrier, const JointedLine& to);
    static bool takeSide(const Spread& step, std::uint32_t slot);

    std::vector<std::uint32_t> slots_; // of the contacts that have a side, in the order of keys
};

} // namespace KODO_PRECISION
} // namespace kodo
