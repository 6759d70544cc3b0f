// SPDX-License-Identifier: MIT
#include <kodo/contacts/contact_report.hpp>

#include <algorithm>
#include <tuple>

namespace kodo::inline KODO_PRECISION {

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

namespace {

void sumUp(Contact& contact, const Tolerances& tolerances) {
    if (contact.sensor) {
        contact.touching = contact.touching || (contact.manifold.count > 0 &&
                                                contact.manifold.points[0].separation <= 0);
        return;
    }
    if (contact.hidden) {
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        PointImpulse& impulse = contact.impulse[i];
        impulse.largest = std::max(impulse.largest, impulse.impact);
        contact.total += impulse.impact;
        contact.touching = contact.touching || impulse.largest > 0 ||
                           contact.manifold.points[i].separation <= tolerances.slop;
    }
}

} // namespace

void finishContact(Contact& contact, const Tolerances& tolerances) {
    if (contact.near || contact.sensor) {
        sumUp(contact, tolerances);
    }
    contact.phase.reset();
    if (contact.touching) {
        contact.phase = contact.wasTouching ? TouchPhase::Persist : TouchPhase::Begin;
    } else if (contact.wasTouching) {
        contact.phase = TouchPhase::End;
    }
    contact.wasTouching = contact.touching;
}

void recordContact(const Contact& contact, std::vector<CollisionRecord>& out) {
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
    record.approachSpeed = contact.approachSpeed;
    record.totalImpulse = contact.total;
    for (std::size_t i = 0; i < record.pointCount; ++i) {
        if (contact.impulse[i].largest > record.maxImpulse) {
            record.maxImpulse = contact.impulse[i].largest;
            record.point = contact.centerA + contact.manifold.points[i].armA;
        }
    }
}

void addEnds(std::span<const CollisionRecord> ended, std::vector<CollisionRecord>& records) {
    if (ended.empty()) {
        return;
    }
    records.insert(records.end(), ended.begin(), ended.end());
    const auto key = [](const CollisionRecord& r) {
        return std::make_tuple(r.a, r.partA, r.b, r.partB, r.phase != TouchPhase::End);
    };
    std::sort(records.begin(), records.end(), // total order: one record a pair, or an End
              [&](const CollisionRecord& r, const CollisionRecord& s) { // and a new Begin
                  return key(r) < key(s);
              });
}

} // namespace kodo::inline KODO_PRECISION
