// SPDX-License-Identifier: MIT
#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "world/world_impl.hpp"

#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Checks whether the parts of both can form one body. `place`: pose of the other shape's frame.
std::optional<Problem> checkTogether(const BodyGeometry& into, const BodyGeometry& part,
                                     const Transform& place) {
    if (into.parts.size() + part.parts.size() > kMaxParts) {
        return Problem{"part", "must not give the body more than " + std::to_string(kMaxParts) +
                                   " parts, but they would be " +
                                   std::to_string(into.parts.size() + part.parts.size())};
    }
    Mass added = part.mass;
    added.center = place * added.center;
    const Mass sum = combine(into.mass, added);
    auto problem = sum.mass > 0 ? checkMass(sum) : std::nullopt; // two planes have no mass
    if (problem) {
        problem->field = "part";
        problem->reason = "makes an invalid body: " + problem->reason;
    }
    return problem;
}

std::optional<Problem> checkMassless(const char* field, const Primitive& part, Flags into) {
    auto problem = checkPlaneType(part, into);
    if (problem) {
        problem = Problem{field, "is a plane, which has no mass: weld it to a static or kinematic "
                                 "body"};
    }
    return problem;
}

/// A part that is small and far from `into` loses its corners by rounding in the frame of `into`.
std::optional<Problem> checkNear(const Primitive& movedPart, Real lengthUnit) {
    if (const auto problem = checkMoved(movedPart)) {
        return Problem{"part", "is too small for its distance: " + problem->text()};
    }
    auto problem = checkExtent(movedPart, lengthUnit);
    if (problem) {
        problem->field = "part";
        problem->reason = "is too far away: " + problem->reason;
    }
    return problem;
}

/// A body without one of its parts, and that part. Throws BadDefinition for a set mass whose shares
/// are out of range.
DividedGeometry divide(const BodyGeometry& whole, std::size_t part) {
    PartList list = whole;
    DividedGeometry both;
    both.taken = makeGeometry(takePart(list, part));
    both.rest = makeGeometry(std::move(list));
    for (const BodyGeometry* each : {both.rest.get(), both.taken.get()}) {
        if (auto problem = each->setMasses.empty() ? std::nullopt : checkMass(each->mass)) {
            throw BadDefinition({"part", "divides the mass that was set: " + problem->reason});
        }
    }
    return both;
}

} // namespace

std::size_t WorldImpl::weld(BodyId into, BodyId part) {
    kodo::requireAlive(bodies_, into, "into");
    kodo::requireAlive(bodies_, part, "part");
    if (into == part) {
        throw BadDefinition({"part", "must not be the body that it is welded to"});
    }
    const Transform frame{bodies_.originOf(into.index), bodies_.pose[into.index].rotation};
    const Transform other{bodies_.originOf(part.index), bodies_.pose[part.index].rotation};
    const Transform place = between(frame, other);
    for (const Part& added : bodies_.geometry(part.index).parts) {
        refuse(checkMassless("part", added.primitive, bodies_.filter[into.index].flags));
        refuse(checkNear(moved(added.primitive, place), tolerances_.unit()));
    }
    if (auto problem = joints_.checkTransfer(part, into, place, tolerances_.unit())) {
        throw BadDefinition({"part", "has a joint that would be invalid: " + problem->text()});
    }
    refuse(checkTogether(bodies_.geometry(into.index), bodies_.geometry(part.index), place));
    wakeNeighbours(into.index);
    const std::size_t firstPart = bodies_.geometry(into.index).parts.size();
    joints_.transfer(part, into, place);
    notePairChanges();
    weldBodies(bodies_, into.index, part.index);
    region_.place(into.index, bodies_, contacts_);
    contacts_.bodyChanged(bodies_, tolerances_, into.index);
    remove(part);
    return firstPart;
}

std::size_t WorldImpl::weld(BodyId into, const Primitive& shape, const Material& material,
                            Real density) {
    kodo::requireAlive(bodies_, into);
    refuse(check(shape));
    refuse(check(material));
    refuse(checkDensity(density));
    refuse(checkMassless("shape", shape, bodies_.filter[into.index].flags));
    const Part part{shape, material, density};
    refuse(checkParts({&part, 1}, tolerances_.unit()));
    refuse(checkTogether(bodies_.geometry(into.index), *makeGeometry({part}), {}));
    wakeNeighbours(into.index);
    PartList list = bodies_.geometry(into.index);
    list.parts.push_back(part);
    if (!list.former.empty()) {
        list.former.emplace_back();
    }
    setGeometryInMotion(bodies_, into.index, makeGeometry(std::move(list)));
    region_.place(into.index, bodies_, contacts_);
    contacts_.bodyChanged(bodies_, tolerances_, into.index);
    return bodies_.geometry(into.index).parts.size() - 1;
}

BodyId WorldImpl::unweld(BodyId body, std::size_t part, std::optional<Flags> flags) {
    kodo::requireAlive(bodies_, body);
    const std::vector<Part>& parts = bodies_.geometry(body.index).parts;
    if (part >= parts.size()) {
        throw BadDefinition({"part", "must be below " + std::to_string(parts.size()) +
                                         ", the number of parts of the body, but is " +
                                         std::to_string(part)});
    }
    if (parts.size() == 1) {
        throw BadDefinition({"part", "is the only part of the body, which would be left empty"});
    }
    FormerBody made = formerBody(bodies_.geometry(body.index), part);
    if (!made.known) { // it moves on as it did
        made.rules = bodies_.record[body.index].rules;
    }
    if (flags) {
        refuse(checkFlags("flags", *flags));
        if ((*flags & (kMatchAny | kMatchAll)) != 0) {
            refuse(Problem{"flags", "must not have kMatchAny or kMatchAll: `required` will be 0, "
                                    "so the body would collide with nothing"});
        }
        made.filter = {*flags & ~kStatusFlags};
    }
    if (needsLock(parts[part].primitive) && locksOf(made.filter.flags) != kLockBoth) {
        refuse(Problem{"flags", "must have kLockMove and kLockRotate: a plane has no mass"});
    }
    const DividedGeometry geometry = divide(bodies_.geometry(body.index), part);
    wakeNeighbours(body.index);
    contacts_.partRemoved(body.index, part, bodies_);
    const BodyId freed = unweldPart(bodies_, body.index, geometry, made);
    region_.place(body.index, bodies_, contacts_);
    region_.update(bodies_, freed.index);
    contacts_.bodyChanged(bodies_, tolerances_, body.index);
    contacts_.bodyChanged(bodies_, tolerances_, freed.index);
    flagBlocks_.note(freed.index, bodies_.filter[freed.index].flags);
    ++count_;
    return freed;
}

} // namespace KODO_PRECISION
} // namespace kodo
