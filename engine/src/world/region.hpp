// SPDX-License-Identifier: MIT
#pragma once

#include "contacts/contact_set.hpp"
#include "joints/joint_set.hpp"
#include "world/parked_contacts.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// The region of a World, and the contacts outside: see World::setRegion. A contact without an
/// active body, with a body outside, is parked until a body becomes active. A parked contact
/// neither ends nor begins.
class Region {
public:
    const std::optional<Aabb>& box() const { return box_; }
    /// moveInOut() must follow.
    void setBox(const std::optional<Aabb>& box) { box_ = box; }
    bool isActive() const { return box_.has_value(); }
    bool contains(const Bodies& bodies, std::uint32_t body) const;

    /// The bodies that a change of the region from `before` may concern, in order: those whose
    /// bounds may meet only one of both, and the awake ones.
    std::vector<std::uint32_t> mayCross(const Aabb& before, const Bodies& bodies,
                                        const CandidatePairs& parts) const;

    /// Updates kOutside after a change of the body or the region. True if the body has just left
    /// the region.
    bool update(Bodies& bodies, std::uint32_t body) const;
    /// The same for a body that may have contacts.
    void place(std::uint32_t body, Bodies& bodies, ContactSet& contacts);
    /// Parks those contacts of some bodies that have no active body, and puts those with one back.
    void park(std::span<const std::uint32_t> of, Bodies& bodies, ContactSet& contacts);
    /// Puts back the contacts of bodies that have become active since the last step.
    void followActivity(Bodies& bodies, ContactSet& contacts);
    /// After setBox(): updates the candidates that entered or left the region, and keeps only these
    /// in the list. The other bodies and their contacts stay as they are.
    void moveInOut(std::vector<std::uint32_t>& candidates, Bodies& bodies, ContactSet& contacts);
    void unparkContactsOf(std::uint32_t body, Bodies& bodies, ContactSet& contacts);
    const ParkedContacts& parked() const { return parked_; }

    /// Bodies outside the region count as static during the solve, for touching contacts and
    /// joints.
    void makeOutsideStatic(Bodies& bodies, const ContactSet& contacts, const JointSet& joints);
    /// Visits the bodies that makeOutsideStatic() stopped.
    template <typename Visit>
    void forEachHeld(Visit visit) const {
        for (const auto& held : outsideVelocities_) {
            visit(held.first);
        }
    }
    void restoreOutside(Bodies& bodies);
    void visitState(StateStream& stream, const Bodies& bodies);

private:
    void setAside(std::span<const StoredContact> idle, std::span<const std::uint32_t> of,
                  Bodies& bodies, ContactSet& contacts);
    void putBack(Bodies& bodies, ContactSet& contacts);

    std::optional<Aabb> box_;
    // Of bodies outside the region, during the solve.
    std::vector<std::pair<std::uint32_t, BodyVelocity>> outsideVelocities_;
    ParkedContacts parked_;
    std::vector<StoredContact> unparked_; // scratch: a step allocates nothing
};

} // namespace KODO_PRECISION
} // namespace kodo
