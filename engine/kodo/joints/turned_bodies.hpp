// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>

#include <vector>

namespace kodo::inline KODO_PRECISION {

/// How bodies stand at a moment within the step. All joints of a body ask for that, in several
/// passes between two moves; it is found once.
class TurnedBodies {
public:
    Rot rotation(const Bodies& bodies, std::uint32_t body) {
        const Rot from = bodies.pose[body].rotation;
        const Real turn = bodies.motion[body].turn;
        if (turn == 0) {
            return from;
        }
        if (body >= known_.size()) {
            known_.resize(bodies.size());
        }
        Known& known = known_[body];
        if (known.turn != turn || known.from != from) {
            known = {from, turn, turned(from, turn)};
        }
        return known.to;
    }

private:
    struct Known {
        Rot from;
        Real turn = 0; // rad
        Rot to;
    };
    std::vector<Known> known_; // by body
};

} // namespace kodo::inline KODO_PRECISION
