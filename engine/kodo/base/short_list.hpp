// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace kodo {

/// A list whose first `kInside` elements lie in the object itself, so that short ones, which are
/// most, are read without a way through the heap. A longer one lies on the heap as a whole.
template <typename T, std::size_t kInside>
class ShortList {
public:
    ShortList() = default;
    explicit ShortList(const std::vector<T>& from) {
        for (const T& element : from) {
            push_back(element);
        }
    }

    ShortList(const ShortList&) = default;
    ShortList(ShortList&& other) noexcept
        : size_(std::exchange(other.size_, 0)),
          inside_(std::move(other.inside_)),
          outside_(std::exchange(other.outside_, {})) {}
    ShortList& operator=(ShortList other) noexcept {
        std::swap(size_, other.size_);
        std::swap(inside_, other.inside_);
        std::swap(outside_, other.outside_);
        return *this;
    }
    ~ShortList() = default;

    void push_back(const T& element) {
        if (size_ == kInside && outside_.empty()) {
            outside_.assign(inside_.begin(), inside_.end());
        }
        if (size_ >= kInside) {
            outside_.push_back(element);
        } else {
            inside_[size_] = element;
        }
        ++size_;
    }

    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    T* data() { return size_ > kInside ? outside_.data() : inside_.data(); }
    const T* data() const { return size_ > kInside ? outside_.data() : inside_.data(); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    const T& back() const { return data()[size_ - 1]; }

private:
    std::size_t size_ = 0;
    std::array<T, kInside> inside_{};
    std::vector<T> outside_;
};

} // namespace kodo
