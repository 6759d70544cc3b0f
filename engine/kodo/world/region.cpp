// SPDX-License-Identifier: MIT
#include <kodo/world/world.hpp>

namespace kodo::inline KODO_PRECISION {

void World::setRegion(std::optional<Aabb> region) {
    if (region && !(region->lower.x <= region->upper.x && region->lower.y <= region->upper.y)) {
        throw BadDefinition({"region", "must have its lower corner below and left of its upper"});
    }
    region_ = region;
    for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
        if (bodies_.ids.aliveAt(body)) {
            placeInRegion(body);
        }
    }
    bodies_.awakeStale = true;
    contacts_.activityChanged();
}

/// Asks anew whether a body takes part in steps or waits, since it or the region has changed.
void World::placeInRegion(std::uint32_t body) {
    Flags& flags = bodies_.record[body].filter.flags;
    const bool inside = !region_ || overlap(*region_, boundsOfBody(bodies_, body));
    flags = inside ? flags & ~kOutside : flags | kOutside;
    bodies_.jumped(body);
}

} // namespace kodo::inline KODO_PRECISION
