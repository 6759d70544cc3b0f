// SPDX-License-Identifier: MIT
#include <kodo/bodies/force_field.hpp>

namespace kodo::inline KODO_PRECISION {

Push Gravity::at(const Bodies& bodies, std::uint32_t body) const {
    return {bodies.form(body).mass.mass * acceleration_, 0};
}

} // namespace kodo::inline KODO_PRECISION
