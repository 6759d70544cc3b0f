// SPDX-License-Identifier: MIT
#include <kodo/body.hpp>

#include "bodies/bodies.hpp"
#include "bodies/body_checks.hpp"
#include "bodies/part_filter.hpp"

#include <stdexcept>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {

BodyView::BodyView(const Bodies& bodies, BodyId id) : bodies_(&bodies), id_(id) {
    index(); // throws
}

std::uint32_t BodyView::index() const {
    if (!bodies_->alive(id_)) {
        requireAlive(*bodies_, id_); // throws
    }
    return id_.index;
}

BodyType BodyView::type() const {
    return typeOf(bodies_->filter[index()].flags);
}
Vec2 BodyView::position() const {
    return bodies_->originOf(index());
}
Rot BodyView::rotation() const {
    return bodies_->pose[index()].rotation;
}
Transform BodyView::transform() const {
    return {position(), rotation()};
}
Vec2 BodyView::center() const {
    return bodies_->pose[index()].position;
}
Vec2 BodyView::velocity() const {
    return bodies_->motion[index()].velocity;
}
Real BodyView::angularVelocity() const {
    return bodies_->motion[index()].angularVelocity;
}
Vec2 BodyView::velocityAt(Vec2 point) const {
    return kodo::velocityAt(bodies_->motion[index()], point - center());
}
Real BodyView::mass() const {
    return bodies_->geometry(index()).mass.mass;
}
Real BodyView::inertia() const {
    return bodies_->geometry(index()).mass.inertia;
}
Vec2 BodyView::localCenter() const {
    return bodies_->geometry(index()).mass.center;
}
bool BodyView::hasSetMass() const {
    return !bodies_->geometry(index()).setMasses.empty();
}
Real BodyView::area() const {
    return bodies_->geometry(index()).area;
}
Flags BodyView::flags() const {
    return bodies_->filter[index()].flags & ~kTypeBits;
}
Flags BodyView::required() const {
    return bodies_->filter[index()].required;
}
std::int32_t BodyView::group() const {
    return bodies_->filter[index()].group;
}
std::uint64_t BodyView::userData() const {
    return bodies_->record[index()].userData;
}
bool BodyView::isAsleep() const {
    return (flags() & kAsleep) != 0;
}
Real BodyView::linearDamping() const {
    return bodies_->record[index()].rules.linearDamping;
}
Real BodyView::angularDamping() const {
    return bodies_->record[index()].rules.angularDamping;
}
Real BodyView::gravityScale() const {
    return bodies_->record[index()].rules.gravityScale;
}
ContinuousMode BodyView::continuousMode() const {
    return bodies_->record[index()].rules.continuousMode;
}
std::size_t BodyView::partCount() const {
    return bodies_->geometry(index()).parts.size();
}
const Part& BodyView::part(std::size_t index) const {
    const std::vector<Part>& parts = bodies_->geometry(this->index()).parts;
    if (index >= parts.size()) {
        throw std::out_of_range("part " + std::to_string(index) + " does not exist: the body has " +
                                std::to_string(parts.size()) + " of them, counted from 0");
    }
    return parts[index];
}
CollisionFilter BodyView::filter(std::size_t part) const {
    static_cast<void>(this->part(part)); // throws for an index that is too high
    CollisionFilter filter = filterOf(*bodies_, index(), part);
    filter.flags &= ~kTypeBits;
    return filter;
}
const Transform& BodyView::massFrame() const {
    return bodies_->pose[index()];
}
Aabb BodyView::bounds() const {
    return boundsOfBody(*bodies_, index());
}

bool BodyView::contains(Vec2 point) const {
    for (const Part& part : bodies_->geometry(index()).parts) {
        if (kodo::contains(part.convex, massFrame(), point)) {
            return true;
        }
    }
    return false;
}

} // namespace KODO_PRECISION
} // namespace kodo
