// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/state_hash.hpp>

#include "base/members.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Refuses the bytes of a snapshot unless a condition holds. Throws BadSnapshot.
inline void require(bool good, const char* sentence) {
    if (!good) {
        throw BadSnapshot(sentence);
    }
}
inline void require(const std::optional<Problem>& problem) {
    if (problem) {
        throw BadSnapshot(problem->text());
    }
}

/// True for ascending indices below `count`.
inline bool areInOrder(std::span<const std::uint32_t> list, std::size_t count) {
    return std::adjacent_find(list.begin(), list.end(), std::greater_equal()) == list.end() &&
           (list.empty() || list.back() < count);
}

/// Writes the state of a World as bytes, or reads it: one list serves both directions, so they
/// cannot diverge. The bytes are little-endian and without gaps, the same on every machine.
///
/// A class lists its own state in `visitState(StateStream&)`, which names all of its members: a new
/// one does not compile until it is listed or left out. All members of other aggregates are state.
class StateStream {
public:
    /// Writes.
    StateStream() = default;
    /// Reads.
    explicit StateStream(std::span<const std::byte> bytes) : remaining_(bytes), reads_(true) {}

    bool reads() const { return reads_; }
    std::size_t left() const { return remaining_.size(); } // bytes not yet read
    std::vector<std::byte> takeWritten() {
        written_.resize(std::exchange(size_, 0));
        return std::exchange(written_, {});
    }

    /// Writes these values in order, or reads into them. Floats are stored bit by bit, including
    /// NaN and -0. Throws BadSnapshot at the end of the bytes, and for a bool that is neither 0 nor
    /// 1. Whoever reads an enumerator checks it.
    template <typename... Values>
    void operator()(Values&... values) {
        (one(values), ...);
    }
    /// A number that is stored with another size.
    template <typename Stored, typename Value>
    void as(Value& value) {
        auto stored = static_cast<Stored>(value);
        one(stored);
        if (reads_) {
            value = static_cast<Value>(stored);
        }
    }
    /// For a stream that writes: values stay as they are.
    template <typename... Values>
    void write(const Values&... values) {
        (*this)(const_cast<Values&>(values)...);
    }
    /// A list whose elements visit(element) writes or reads.
    template <typename Value, typename Visit>
    void list(std::vector<Value>& values, Visit visit) {
        auto length = static_cast<std::uint32_t>(values.size());
        number(length);
        require(!reads_ || length <= left(), "a list is longer than the remaining bytes");
        if (!reads_) {
            std::for_each(values.begin(), values.end(), visit);
            return;
        }
        values.clear();
        while (length-- > 0) {
            visit(values.emplace_back()); // a wrong length fails before the list is large
        }
    }

private:
    template <typename Value>
    void one(Value& value) {
        if constexpr (requires { value.visitState(*this); }) {
            value.visitState(*this);
        } else if constexpr (requires { value.index, value.generation, value.world; }) {
            auto& [index, generation, world] = value; // an id: its World is not stored
            (*this)(index, generation);
        } else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
            number(value);
        } else {
            withMembers(value, [this](auto&... members) { (*this)(members...); });
        }
    }
    void one(bool& value) {
        auto byte = static_cast<std::uint8_t>(value);
        number(byte);
        require(byte <= 1, "a bool is neither 0 nor 1");
        if (reads_) {
            value = byte == 1;
        }
    }
    template <typename Value>
    void one(std::vector<Value>& values) {
        list(values, [this](Value& value) { one(value); });
    }
    template <typename Value, std::size_t N>
    void one(std::array<Value, N>& values) {
        for (Value& value : values) {
            one(value);
        }
    }
    template <typename Value>
    void one(std::optional<Value>& value) {
        bool there = value.has_value();
        one(there);
        if (reads_) {
            value = there ? std::optional(Value{}) : std::nullopt;
        }
        if (value) {
            one(*value);
        }
    }
    template <typename... Kinds>
    void one(std::variant<Kinds...>& value) {
        auto kind = static_cast<std::uint8_t>(value.index());
        number(kind);
        if (reads_) {
            std::uint8_t i = 0;
            const bool known = ((i++ == kind && (value = Kinds{}, true)) || ...);
            require(known, "the kind of a shape, joint or solver is unknown");
        }
        std::visit([this](auto& alternative) { one(alternative); }, value);
    }

    /// A number, or an enumerator.
    template <typename Number>
    void number(Number& value) {
        constexpr std::size_t kSize = sizeof(Number);
        if (reads_) {
            require(left() >= kSize, "the bytes end too soon");
            copy(remaining_.data(), reinterpret_cast<std::byte*>(&value), kSize);
            remaining_ = remaining_.subspan(kSize);
            return;
        }
        if (written_.size() - size_ < kSize) {
            written_.resize(2 * written_.size() + kLeastRoom);
        }
        copy(reinterpret_cast<const std::byte*>(&value), &written_[size_], kSize);
        size_ += kSize;
    }
    static void copy(const std::byte* from, std::byte* to, std::size_t size) {
        if constexpr (std::endian::native == std::endian::little) {
            std::memcpy(to, from, size);
        } else {
            std::reverse_copy(from, from + size, to);
        }
    }

    static constexpr std::size_t kLeastRoom = 4096;

    std::vector<std::byte> written_; // and room for more
    std::size_t size_ = 0;           // of what was written
    std::span<const std::byte> remaining_;
    bool reads_ = false;
};

/// FNV-1a, 64 bits. Two sequences that differ in exactly one byte have different checksums.
inline std::uint64_t checksumOf(std::span<const std::byte> bytes) {
    StateHash hash;
    for (const std::byte byte : bytes) {
        hash.add(std::to_integer<std::uint8_t>(byte));
    }
    return hash.value();
}

} // namespace KODO_PRECISION
} // namespace kodo
