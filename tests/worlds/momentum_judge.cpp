// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <worlds/judges.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace worlds {

using namespace kodo;

MomentumJudge::MomentumJudge(const Recipe& recipe)
    : closed_(recipe.world.gravity == Vec2{} && recipe.drag == 0 &&
              recipe.world.settings.has(Feature::Rotation)) {
    for (const BodyDef& body : recipe.bodies) {
        closed_ = closed_ && body.type == BodyType::Dynamic &&
                  (body.flags & (kLockMove | kLockRotate)) == 0;
    }
    for (const JointDef& joint : recipe.joints) {
        closed_ = closed_ && !std::holds_alternative<MouseJoint>(joint) &&
                  !std::holds_alternative<PulleyJoint>(joint);
    }
}

void MomentumJudge::restart(const World& world) {
    const support::Totals totals = support::totalsOf(world);
    momentum_ = totals.momentum;
    spin_ = totals.spin;
}

std::optional<std::string> MomentumJudge::afterStep(const World& world) {
    if (!closed_) {
        return std::nullopt;
    }
    long double momentumScale = 0;
    long double spinScale = 0;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        const auto moving = static_cast<long double>(body.mass() * length(body.velocity()));
        momentumScale += moving;
        spinScale += moving * static_cast<long double>(length(body.center())) +
                     static_cast<long double>(std::abs(body.inertia() * body.angularVelocity()));
    }
    momentumScale_ = std::max(momentumScale_, momentumScale);
    spinScale_ = std::max(spinScale_, spinScale);
    const support::Totals now = support::totalsOf(world);
    const long double lost = length(now.momentum - momentum_);
    const long double turned = std::abs(now.spin - spin_);
    const long double share = sizeof(Real) == 4 ? 1e-4L : 1e-10L;
    if (lost <= share * momentumScale_ && turned <= 2.5e-3L * spinScale_) {
        return std::nullopt;
    }
    std::ostringstream text;
    text << "momentum off by " << static_cast<double>(lost) << " of "
         << static_cast<double>(momentumScale_) << " kg m/s, angular momentum by "
         << static_cast<double>(turned) << " of " << static_cast<double>(spinScale_) << " kg m^2/s";
    return text.str();
}

} // namespace worlds
