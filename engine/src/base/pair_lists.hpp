// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kodo {

/// The contacts or joints of each body: a doubly linked list of slots for each body. Adding,
/// removing and moving a pair takes constant time. The order within a list depends on history; no
/// result may depend on it.
class PairLists {
public:
    static constexpr std::uint32_t kEnd = ~std::uint32_t{};

    /// Empties all lists, with room for this many slots.
    void clear(std::size_t slots = 0) {
        std::fill(first_.begin(), first_.end(), kEnd);
        links_.resize(2 * slots);
    }

    /// Sizes the array by body, with room for more.
    void makeRoom(std::size_t bodies, std::size_t room) {
        if (first_.size() < bodies) {
            first_.reserve(room);
            first_.resize(bodies, kEnd);
        }
    }

    void add(std::uint32_t slot, std::uint32_t bodyA, std::uint32_t bodyB) {
        const std::size_t ends = 2 * (slot + std::size_t{1});
        if (links_.size() < ends) {
            links_.resize(ends);
        }
        add(2 * slot, bodyA);
        if (bodyB != bodyA) {
            add(2 * slot + 1, bodyB);
        }
    }
    void remove(std::uint32_t slot, std::uint32_t bodyA, std::uint32_t bodyB) {
        remove(2 * slot, bodyA);
        if (bodyB != bodyA) {
            remove(2 * slot + 1, bodyB);
        }
    }
    /// A pair of two bodies has moved to another slot, which was removed before.
    void move(std::uint32_t from, std::uint32_t to, std::uint32_t bodyA, std::uint32_t bodyB) {
        move(2 * from, 2 * to, bodyA);
        move(2 * from + 1, 2 * to + 1, bodyB);
    }

    /// Index of the first link of a body, and of the one after; kEnd: none. Link / 2 is the slot.
    std::uint32_t firstOf(std::uint32_t body) const {
        return body < first_.size() ? first_[body] : kEnd;
    }
    std::uint32_t after(std::uint32_t link) const { return links_[link].next; }
    /// Calls visit(slot) for each pair of a body. visit may remove that pair.
    template <typename Visit>
    void forEach(std::uint32_t body, Visit visit) const {
        std::uint32_t link = firstOf(body);
        while (link != kEnd) {
            visit(std::exchange(link, after(link)) / 2);
        }
    }

private:
    /// One end of a pair: 2 slot for its body a, 2 slot + 1 for b.
    struct Link {
        std::uint32_t next = kEnd;
        std::uint32_t before = kEnd;
    };

    void add(std::uint32_t link, std::uint32_t body) {
        if (body >= first_.size()) {
            first_.resize(body + std::size_t{1}, kEnd);
        }
        const std::uint32_t next = std::exchange(first_[body], link);
        links_[link] = {next, kEnd};
        if (next != kEnd) {
            links_[next].before = link;
        }
    }
    void remove(std::uint32_t link, std::uint32_t body) {
        const auto [next, before] = links_[link];
        (before == kEnd ? first_[body] : links_[before].next) = next;
        if (next != kEnd) {
            links_[next].before = before;
        }
    }
    void move(std::uint32_t from, std::uint32_t to, std::uint32_t body) {
        links_[to] = links_[from];
        const auto [next, before] = links_[to];
        (before == kEnd ? first_[body] : links_[before].next) = to;
        if (next != kEnd) {
            links_[next].before = to;
        }
    }

    std::vector<std::uint32_t> first_; // by body: link
    std::vector<Link> links_;          // by link
};

} // namespace kodo
