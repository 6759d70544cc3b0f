// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>
#include <kodo/geometry.hpp>
#include <kodo/joint.hpp>

#include "base/byte_stream.hpp"
#include "base/checks.hpp"
#include "base/reorder_policy.hpp"
#include "bodies/part_list.hpp"
#include "math/octagon.hpp"

#include <array>
#include <optional>
#include <type_traits>
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

/// Writes or reads numbers, geometry and containers. Elements of containers go to the function
/// one() of `Fields`, the class that derives from this one.
template <typename Fields>
class SnapshotStream {
protected:
    explicit SnapshotStream(ByteStream& stream) : stream_(stream) {}

    bool reads() const { return stream_.reads(); }

    template <typename... Values>
    void all(Values&... values) {
        (fields().one(values), ...);
    }

    template <typename Number>
    requires std::is_arithmetic_v<Number>
    void one(Number& number) { stream_.number(number); }
    /// A number stored with another size, or an enumerator.
    template <typename Stored, typename Value>
    void as(Value& value) {
        auto stored = static_cast<Stored>(value);
        stream_.number(stored);
        value = static_cast<Value>(stored);
    }
    void one(BodyId& id) {
        auto& [index, generation, world] = id; // the World is not stored
        all(index, generation);
    }
    void one(JointId& id) {
        auto& [index, generation, world] = id; // likewise
        all(index, generation);
    }
    void one(ReorderPolicy& reorderPolicy) {
        auto& [strayed, cost] = reorderPolicy;
        all(strayed, cost);
    }
    template <typename Value>
    void one(std::vector<Value>& list) {
        std::uint32_t length = lengthOf(list.size());
        if (reads()) {
            list.clear();
            while (length-- > 0) {
                fields().one(list.emplace_back()); // a wrong length fails before the list is large
            }
            return;
        }
        for (Value& value : list) {
            fields().one(value);
        }
    }
    template <typename Value, std::size_t N>
    void one(std::array<Value, N>& values) {
        for (Value& value : values) {
            fields().one(value);
        }
    }
    template <typename Value>
    void one(std::optional<Value>& value) {
        bool there = value.has_value();
        one(there);
        if (there) {
            fields().one(reads() ? value.emplace() : *value);
        } else {
            value.reset();
        }
    }
    template <typename... Kinds>
    void one(std::variant<Kinds...>& value) {
        std::uint8_t kind = static_cast<std::uint8_t>(value.index());
        one(kind);
        if (reads()) {
            std::uint8_t i = 0;
            const bool known = ((i++ == kind && (value = Kinds{}, true)) || ...);
            require(known, "the kind of a shape, joint or solver is unknown");
        }
        std::visit([this](auto& alternative) { fields().one(alternative); }, value);
    }

    template <typename T>
    void one(BasicVec2<T>& v) {
        auto& [x, y] = v;
        all(x, y);
    }
    void one(Rot& q) {
        auto& [c, s] = q;
        all(c, s);
    }
    void one(Transform& t) {
        auto& [position, rotation] = t;
        all(position, rotation);
    }
    void one(Aabb& box) {
        auto& [lower, upper] = box;
        all(lower, upper);
    }

    void one(SetMass& set) {
        auto& [firstPart, partCount, whole] = set;
        auto& [mass, center, inertia] = whole;
        all(firstPart, partCount, mass, center, inertia);
    }
    void one(FormerBody& former) {
        auto& [known, filter, userData] = former;
        all(known, filter, userData);
    }
    void one(Octagon& octagon) {
        auto& [lower, upper] = octagon;
        for (Octagon::Each* each : {&lower, &upper}) {
            for (int i = 0; i < 4; ++i) {
                Real value = (*each)[i];
                one(value);
                (*each)[i] = value;
            }
        }
    }
    std::uint32_t lengthOf(std::size_t size) {
        auto length = static_cast<std::uint32_t>(size);
        one(length);
        require(!reads() || length <= stream_.left(), "a list is longer than the remaining bytes");
        return length;
    }

private:
    Fields& fields() { return static_cast<Fields&>(*this); }

    ByteStream& stream_;
};

} // namespace KODO_PRECISION
} // namespace kodo
