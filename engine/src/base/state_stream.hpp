// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>

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
#include <tuple>
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

class StateStream;

template <typename T>
concept hasOwnState = requires(T& value, StateStream& stream) {
    value.visitState(stream);
};
/// An id: its World is not stored.
template <typename T>
concept isId = requires(T& id) {
    id.index, id.generation, id.world;
};

/// True for ascending indices below `count`.
inline bool areInOrder(std::span<const std::uint32_t> list, std::size_t count) {
    return std::adjacent_find(list.begin(), list.end(), std::greater_equal()) == list.end() &&
           (list.empty() || list.back() < count);
}

template <typename T>
constexpr bool isPlain();
template <typename T, typename... Members>
inline constexpr bool kIsGapless = (isPlain<Members>() && ...) &&
                                   (sizeof(Members) + ... + 0) == sizeof(T);

template <typename T>
struct GaplessOf {
    template <typename... Members>
    std::bool_constant<kIsGapless<T, Members...>> operator()(Members&...) const {
        return {};
    }
};

/// True for a type whose bytes in memory are those of its members, in order and without gaps. Such
/// values are copied as one block. `bool` is not one of them: it is checked.
template <typename T>
constexpr bool isPlain() {
    if constexpr (std::endian::native != std::endian::little || std::is_same_v<T, bool> ||
                  !std::is_trivially_copyable_v<T> || std::is_pointer_v<T>) {
        return false;
    } else if constexpr (!std::is_class_v<T>) {
        return true;
    } else if constexpr (requires { std::tuple_size<T>::value; }) { // an array
        return isPlain<typename T::value_type>();
    } else if constexpr (!std::is_aggregate_v<T> || isId<T> || hasOwnState<T>) {
        return false;
    } else {
        return decltype(withMembers(std::declval<T&>(), GaplessOf<T>{}))::value;
    }
}

/// Writes the state of a World as bytes, or reads it: one list serves both directions, so they
/// cannot diverge. The bytes are little-endian and without gaps, the same on every machine.
///
/// A class lists its own state in `visitState(StateStream&)`, which names all of its members: a new
/// one does not compile until it is listed or left out. All members of other aggregates are state.
class StateStream {
public:
    /// Writes. There is room for so many bytes; for more, the written ones move.
    explicit StateStream(std::size_t room = 0) : written_(room) {}
    /// Reads.
    explicit StateStream(std::span<const std::byte> bytes) : remaining_(bytes), reads_(true) {}

    bool reads() const { return reads_; }
    std::size_t left() const { return remaining_.size(); } // bytes not yet read
    std::span<const std::byte> written() const { return {written_.data(), size_}; }
    std::vector<std::byte> takeWritten() {
        written_.resize(std::exchange(size_, 0));
        return std::exchange(written_, {});
    }

    /// Writes these values in order, or reads into them. Floats are stored bit by bit, including
    /// NaN and -0. Throws BadSnapshot at the end of the bytes, and for a bool that is neither 0 nor
    /// 1. The reading class checks enumerators.
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
    /// Takes back the last bytes that were written.
    void drop(std::size_t bytes) { size_ -= bytes; }
    /// A list whose elements visit(element) writes or reads.
    template <typename Value, typename Visit>
    void list(std::vector<Value>& values, Visit visit) {
        std::uint32_t length = lengthOf(values.size(), 1);
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
        if constexpr (hasOwnState<Value>) {
            value.visitState(*this);
        } else if constexpr (isPlain<Value>()) {
            block<sizeof(Value)>(&value);
        } else if constexpr (isId<Value>) {
            auto& [index, generation, world] = value;
            (*this)(index, generation);
        } else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
            number(value);
        } else {
            withMembers(value, [this](auto&... members) { (*this)(members...); });
        }
    }
    void one(bool& value) {
        auto byte = static_cast<std::uint8_t>(value);
        one(byte);
        require(byte <= 1, "a bool is neither 0 nor 1");
        if (reads_) {
            value = byte == 1;
        }
    }
    template <typename Value>
    void one(std::vector<Value>& values) {
        if constexpr (isPlain<Value>()) {
            const std::uint32_t length = lengthOf(values.size(), sizeof(Value));
            values.resize(length);
            if (length > 0) {
                block(values.data(), length * sizeof(Value));
            }
        } else {
            list(values, [this](Value& value) { one(value); });
        }
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
        one(kind);
        if (reads_) {
            std::uint8_t i = 0;
            const bool known = ((i++ == kind && (value = Kinds{}, true)) || ...);
            require(known, "the kind of a shape, joint or solver is unknown");
        }
        std::visit([this](auto& alternative) { this->one(alternative); }, value);
    }

    /// Length of a list, whose elements have at least `least` bytes.
    std::uint32_t lengthOf(std::size_t size, std::size_t least) {
        auto length = static_cast<std::uint32_t>(size);
        one(length);
        require(!reads_ || length <= left() / least, "a list is longer than the remaining bytes");
        return length;
    }
    /// A number, or an enumerator, of a machine that stores the high byte first.
    template <typename Number>
    void number(Number& value) {
        std::array<std::byte, sizeof(Number)> bytes;
        std::memcpy(&bytes, &value, sizeof value);
        std::reverse(bytes.begin(), bytes.end());
        block<sizeof(Number)>(&bytes);
        std::reverse(bytes.begin(), bytes.end());
        std::memcpy(&value, &bytes, sizeof value);
    }
    /// Of a size that the compiler knows, so that the copy is a few instructions.
    template <std::size_t kSize>
    void block(void* value) {
        if (!reads_ && written_.size() - size_ >= kSize) {
            std::memcpy(written_.data() + size_, value, kSize);
            size_ += kSize;
        } else {
            block(value, kSize);
        }
    }
    void block(void* value, std::size_t size);

    static constexpr std::size_t kLeastRoom = 4096;

    std::vector<std::byte> written_; // and room for more
    std::size_t size_ = 0;           // of what was written
    std::span<const std::byte> remaining_;
    bool reads_ = false;
};

} // namespace KODO_PRECISION
} // namespace kodo
