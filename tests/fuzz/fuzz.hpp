// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>

/// The entry of every fuzz target, as clang's libFuzzer names it. It must accept any bytes. What
/// must not happen ends the program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

/// Ends the program with a sentence, unless `good`.
inline void require(bool good, const char* sentence) {
    if (!good) {
        std::fprintf(stderr, "fuzz target: %s\n", sentence);
        std::abort();
    }
}

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Takes values from the bytes of an input; zeros behind its end.
class Feed {
public:
    Feed(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

    bool empty() const { return left_.empty(); }
    std::uint8_t byte() {
        if (left_.empty()) {
            return 0;
        }
        const std::uint8_t value = left_.front();
        left_ = left_.subspan(1);
        return value;
    }
    std::size_t below(std::size_t count) { return byte() % count; }

    /// In steps of a 16th from -8 to 8; every 64th byte gives any bits instead.
    kodo::Real number() {
        const std::uint8_t value = byte();
        if (value == 128) {
            return anyBits();
        }
        return static_cast<kodo::Real>(static_cast<int>(value) - 128) / 16;
    }
    kodo::Real positive() { return static_cast<kodo::Real>(1 + below(64)) / 32; }
    kodo::Real anyBits() {
        kodo::Real real{};
        unsigned char bits[sizeof real];
        for (unsigned char& each : bits) {
            each = byte();
        }
        std::memcpy(&real, bits, sizeof real);
        return real;
    }
    kodo::Vec2 point() {
        const kodo::Real x = number();
        return {x, number()};
    }
    kodo::Rot rotation() {
        return kodo::Rot::fromAngle(kodo::Real(0.1) * static_cast<kodo::Real>(byte()));
    }

private:
    std::span<const std::uint8_t> left_;
};

} // namespace fuzz
