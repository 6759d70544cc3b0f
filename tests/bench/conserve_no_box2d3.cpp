// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "conserve.hpp"

namespace conserve::v3 {

bool isBuilt() {
    return false;
}

Series play(const Run&) {
    throw std::logic_error("Box2D 3 is not in this build");
}

} // namespace conserve::v3
