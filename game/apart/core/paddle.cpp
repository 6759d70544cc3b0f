// SPDX-License-Identifier: MIT
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Vec2;

namespace {

Real wantedSpeed(const Input& input, Real x, Real acceleration) {
    if (!input.target) {
        return kKeySpeed * static_cast<Real>(input.paddle) / 127;
    }
    // Braking limit v = sqrt(2 a s), without overshoot within this tick.
    const Real way = static_cast<Real>(*input.target) / 1000 - x;
    const Real size = std::abs(way);
    const Real speed = std::min(std::sqrt(2 * acceleration * size), size / kTickSeconds);
    return way < 0 ? -speed : speed;
}

} // namespace

Real domeHeight(Real x) {
    const Real rim = std::sqrt(kDomeRadius * kDomeRadius - kPaddleHalfWidth * kPaddleHalfWidth);
    const Real inside = std::min(std::abs(x), kPaddleHalfWidth);
    return std::sqrt(kDomeRadius * kDomeRadius - inside * inside) - rim;
}

kodo::Polygon paddleShape() {
    kodo::Polygon shape{{{-kPaddleFoot, -kPaddleDepth}, {kPaddleFoot, -kPaddleDepth}}};
    for (int i = 0; i <= kDomeFacets; ++i) {
        const Real share = static_cast<Real>(2 * i) / kDomeFacets - 1; // -1..1, right to left
        const Real x = -share * kPaddleHalfWidth;
        shape.corners.push_back({x, domeHeight(x)});
    }
    return shape;
}

namespace {

/// One tick of a damped spring, by the symplectic Euler method: no numerical gain of energy.
void swing(Real& place, Real& speed, Real low, Real high) {
    speed -= (kSwayStiffness * place + kSwayDamping * speed) * kTickSeconds;
    place += speed * kTickSeconds;
    if (place < low || place > high) { // inelastic stop
        place = std::clamp(place, low, high);
        speed = 0;
    }
}

} // namespace

Sway swayed(Sway sway, PaddleKind kind) {
    Sway next;
    if (tilts(kind)) {
        next.tilt = sway.tilt;
        next.tiltSpeed = sway.tiltSpeed;
        swing(next.tilt, next.tiltSpeed, -kMostTilt, kMostTilt);
    }
    if (recoils(kind)) {
        next.lift = sway.lift;
        next.liftSpeed = sway.liftSpeed;
        swing(next.lift, next.liftSpeed, -kMostSag, kMostLeap);
    }
    return next;
}

Sway pushed(Sway sway, PaddleKind kind, const kodo::Mass& paddle, Vec2 arm, Vec2 impulse) {
    if (tilts(kind)) {
        sway.tiltSpeed += cross(arm, impulse) / paddle.inertia;
    }
    if (recoils(kind)) {
        sway.liftSpeed += impulse.y / paddle.mass;
    }
    return sway;
}

Real drivenSpeed(const Input& input, Real x, Real speed, Real mass) {
    const Real acceleration = kPaddleForce / mass;
    const Real fastest = std::sqrt(2 * kPaddleEnergy / mass);
    const Real wanted = std::clamp(wantedSpeed(input, x, acceleration), -fastest, fastest);
    const Real change = acceleration * kTickSeconds;
    return std::clamp(wanted, speed - change, speed + change);
}

} // namespace apart
