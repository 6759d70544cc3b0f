// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Cache of the rotations of bodies within the step. All joints of a body need its rotation in
/// several passes; it is computed once after each change of deltaAngle.
class BodyRotations {
public:
    Rot rotation(const Bodies& bodies, std::uint32_t body) {
        const Rot from = bodies.pose[body].rotation;
        const Real turn = bodies.motion[body].deltaAngle;
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

} // namespace KODO_PRECISION
} // namespace kodo
