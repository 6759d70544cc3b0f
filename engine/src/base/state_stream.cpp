// SPDX-License-Identifier: MIT
#include "base/state_stream.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

void StateStream::block(void* value, std::size_t size) {
    if (reads_) {
        require(left() >= size, "the bytes end too soon");
        std::memcpy(value, remaining_.data(), size);
        remaining_ = remaining_.subspan(size);
    } else {
        if (written_.size() - size_ < size) {
            written_.resize(2 * (size_ + size) + kLeastRoom);
        }
        std::memcpy(&written_[size_], value, size);
        size_ += size;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
