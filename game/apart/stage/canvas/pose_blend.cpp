// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/pose_blend.hpp>

namespace apart {

namespace {

constexpr kodo::Real kJump = kodo::Real(1.5); // m per tick, above every speed: a teleport

} // namespace

void PoseBlend::remember(const kodo::World& world) {
    for (const kodo::BodyId id : world.bodies()) {
        if (id.index >= poses_.size()) {
            poses_.resize(id.index + 1);
        }
        const kodo::BodyView body = world[id];
        poses_[id.index] = {id.generation, body.position(), body.rotation()};
    }
}

kodo::Transform PoseBlend::massFrame(const kodo::BodyView& body, kodo::Real share) const {
    const kodo::BodyId id = body.id();
    if (id.index >= poses_.size() || poses_[id.index].generation != id.generation) {
        return body.massFrame();
    }
    const Pose& old = poses_[id.index];
    const kodo::Vec2 way = body.position() - old.position;
    const kodo::Rot now = body.rotation();
    const kodo::Rot turn = old.rotation.inverse() * now;
    if (lengthSquared(way) > kJump * kJump || turn.c < 0) {
        return body.massFrame();
    }
    const kodo::Rot rotation =
        normalize(kodo::Rot{old.rotation.c + share * (now.c - old.rotation.c),
                            old.rotation.s + share * (now.s - old.rotation.s)});
    const kodo::Vec2 center = unrotate(now, body.center() - body.position());
    return {old.position + share * way + rotation * center, rotation};
}

} // namespace apart
