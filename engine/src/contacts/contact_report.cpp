// SPDX-License-Identifier: MIT
#include "contacts/contact_report.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

CollisionRecord endOf(const Contact& contact) {
    CollisionRecord record;
    record.a = contact.a;
    record.b = contact.b;
    record.partA = contact.key.partA;
    record.partB = contact.key.partB;
    record.phase = TouchPhase::End;
    record.normal = contact.manifold.normal;
    record.point = contact.centerA + contact.manifold.points[0].armA;
    return record;
}

bool touches(const Contact& contact, const ContactLane& lane, const Tolerances& tolerances) {
    if (contact.sensor) {
        return contact.manifold.count > 0 && lane.separation(0) <= 0;
    }
    if (contact.hidden) {
        return false;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        // Impacts happen within the slop; other impulses also where the step closes the gap.
        if (lane.largest(i) > 0 || lane.impact(i) > 0 || lane.separation(i) <= tolerances.slop) {
            return true;
        }
    }
    return false;
}

void finishContact(Contact& contact, bool touches) {
    contact.touching = (contact.sensor && contact.touching) || touches;
    contact.phase.reset();
    if (contact.touching) {
        contact.phase = contact.wasTouching ? TouchPhase::Persist : TouchPhase::Begin;
    } else if (contact.wasTouching) {
        contact.phase = TouchPhase::End;
    }
    contact.wasTouching = contact.touching;
}

void recordContact(const StoredContact& contact, std::vector<CollisionRecord>& out, Vec2 turned) {
    if (!contact.phase) {
        return;
    }
    CollisionRecord& record = out.emplace_back(endOf(contact));
    if (contact.phase == TouchPhase::End) {
        return;
    }
    record.phase = *contact.phase;
    record.pointCount = static_cast<std::uint8_t>(contact.manifold.count);
    record.separation = contact.manifold.points[0].separation;
    const ContactNumbers& numbers = contact.numbers;
    record.approachSpeed = numbers.approachSpeed;
    const Real impacts = numbers.impulse[0].impact + numbers.impulse[1].impact;
    record.totalImpulse = numbers.total[0] + impacts;
    record.tangentImpulse = numbers.total[1];
    Real substeps = 0;
    Real most = 0;
    for (std::size_t i = 0; i < record.pointCount; ++i) {
        const PointImpulse& impulse = numbers.impulse[i];
        RecordPoint& point = record.points[i];
        point.position = contact.centerA + contact.manifold.points[i].armA;
        point.separation = contact.manifold.points[i].separation;
        // Refined substeps store their largest part times the number of parts: an upper bound.
        point.maxImpulse = std::min(std::max(impulse.largest, impulse.impact), record.totalImpulse);
        substeps += impulse.largest;
        const bool deeper = most == 0 && point.separation < record.separation;
        if (point.maxImpulse > most || deeper) {
            most = point.maxImpulse;
            record.point = point.position;
        }
        record.separation = std::min(record.separation, point.separation);
    }
    record.maxImpulse = std::min(std::max(impacts, substeps), record.totalImpulse);
    if (turned != Vec2{}) { // the sums have the direction of what acted
        const Vec2 sums{record.totalImpulse, record.tangentImpulse};
        const Vec2 along = normalize(turned + impulseOf(sums, record.normal));
        const Vec2 normal = impulseOf(normalize(Vec2{sums.x, -sums.y}), along);
        record.normal = normal == Vec2{} ? record.normal : normal;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
