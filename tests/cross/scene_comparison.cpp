// SPDX-License-Identifier: MIT
#include "scene_comparison.hpp"

#include <algorithm>

namespace crosscheck {

std::vector<double> Measure::operator()(Engine& engine, long steps) const {
    for (const Link& link : links_) {
        engine.join(link);
    }
    std::vector<double> values;
    for (const Comparison& one : all_) {
        values.push_back(one.what == What::Impulse ? 0
                         : one.what == What::Touch ? -1
                                                   : number(engine, one, engine.state(one.a)));
    }
    for (long step = 1; step <= steps; ++step) {
        engine.step(1 / rate_);
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (step <= all_[i].step) {
                follow(engine, all_[i], static_cast<double>(step) / rate_, values[i]);
            }
        }
    }
    return values;
}

double Measure::number(const Engine& engine, const Comparison& one, const State& at) const {
    switch (one.what) {
    case What::X:
        return at.position.x;
    case What::Angle:
        return at.angle;
    case What::Speed:
        return sizeOf(at.velocity);
    case What::Spin:
        return at.spin;
    case What::Energy:
        return energy(engine, def_);
    default:
        return at.position.y;
    }
}

void Measure::follow(const Engine& engine, const Comparison& one, double time,
                     double& value) const {
    if (one.what == What::Impulse) {
        value += engine.impulse(one.a, one.b);
    } else if (one.what == What::Touch) {
        value = value < 0 && engine.touching(one.a, one.b) ? time : value;
    } else {
        const double now = number(engine, one, engine.state(one.a));
        value = one.what == What::Highest  ? std::max(value, now)
                : one.what == What::Lowest ? std::min(value, now)
                                           : now;
    }
}

} // namespace crosscheck
