// SPDX-License-Identifier: MIT
#pragma once

#include "base/assert.hpp"
#include "base/state_stream.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Allocates slots of an array. The generation of a slot grows with each use, so a stale id never
/// matches a newer owner. A slot whose generations are used up is retired.
///
/// Freed slots are reused last in, first out. The result depends on the calls alone, so ids repeat
/// exactly in a replay.
class IdPool {
public:
    /// Index and generation of a slot.
    struct Slot {
        std::uint32_t index = 0;
        std::uint32_t generation = 0; // 0 is never alive
    };

    Slot allocate() {
        if (free_.empty()) {
            generations_.push_back(1);
            return {static_cast<std::uint32_t>(generations_.size() - 1), 1};
        }
        const std::uint32_t index = free_.back();
        free_.pop_back();
        generations_[index] += 1; // even: free, odd: alive
        return {index, generations_[index]};
    }

    void release(std::uint32_t index) {
        KODO_ASSERT(index < generations_.size() && generations_[index] % 2 == 1);
        generations_[index] += 1; // wraps to 0 after the last generation: the slot is retired
        if (generations_[index] != 0) {
            free_.push_back(index);
        }
    }

    bool alive(std::uint32_t index, std::uint32_t generation) const {
        return index < generations_.size() && generations_[index] == generation &&
               generation % 2 == 1;
    }

    bool aliveAt(std::size_t index) const { return generations_[index] % 2 == 1; }
    /// Calls visit(index) for the slots in use, in order.
    template <typename Visit>
    void forEach(Visit visit) const {
        for (std::uint32_t index = 0; index < generations_.size(); ++index) {
            if (aliveAt(index)) {
                visit(index);
            }
        }
    }
    std::uint32_t generationAt(std::size_t index) const { return generations_[index]; }

    /// Number of slots ever made, alive or not: the size of an array indexed by them.
    std::size_t capacity() const { return generations_.size(); }

    void visitState(StateStream& stream) {
        auto& [generations, free] = *this;
        stream(generations, free);
        std::vector<bool> seen(generations.size());
        for (const std::uint32_t index : free) {
            require(index < generations.size() && generations[index] % 2 == 0 &&
                        generations[index] != 0 && !seen[index],
                    "the list of free ids is wrong");
            seen[index] = true;
        }
    }

private:
    std::vector<std::uint32_t> generations_;
    std::vector<std::uint32_t> free_;
};

} // namespace KODO_PRECISION
} // namespace kodo
