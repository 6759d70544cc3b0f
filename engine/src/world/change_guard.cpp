// SPDX-License-Identifier: MIT
#include "world/change_guard.hpp"

#include <stdexcept>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {

void ChangeGuard::refuse(const char* call) const {
    throw std::logic_error(
        std::string(call) +
        (inStep_ ? " is not possible within a step: note what is to be done, and do it after "
                   "World::step() returns"
                 : " is not possible while a query visits the World: note what is to be done, and "
                   "do it after the query returns"));
}

} // namespace KODO_PRECISION
} // namespace kodo
