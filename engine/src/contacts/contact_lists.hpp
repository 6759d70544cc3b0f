// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kodo {

/// The contacts of each body: a doubly linked list of slots for each body. Adding, removing and
/// moving a contact takes constant time. The order within a list depends on history; no result may
/// depend on it.
class ContactLists {
public:
    /// False after changes of many contacts at once: then all must be added again.
    bool isValid() const { return valid_; }
    void forget() { valid_ = false; }
    void begin(std::size_t slots) {
        valid_ = true;
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
        add(2 * slot + 1, bodyB);
    }
    void remove(std::uint32_t slot, std::uint32_t bodyA, std::uint32_t bodyB) {
        remove(2 * slot, bodyA);
        remove(2 * slot + 1, bodyB);
    }
    /// The contact has moved to another slot, which was removed before.
    void move(std::uint32_t from, std::uint32_t to, std::uint32_t bodyA, std::uint32_t bodyB) {
        move(2 * from, 2 * to, bodyA);
        move(2 * from + 1, 2 * to + 1, bodyB);
    }

    /// Calls visit(slot) for each contact of a body. visit may remove that contact.
    template <typename Visit>
    void forEach(std::uint32_t body, Visit visit) const {
        std::uint32_t link = body < first_.size() ? first_[body] : kEnd;
        while (link != kEnd) {
            visit(std::exchange(link, links_[link].next) / 2);
        }
    }

private:
    static constexpr std::uint32_t kEnd = ~std::uint32_t{};
    /// One end of a contact: 2 slot for its body a, 2 slot + 1 for b.
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
    bool valid_ = false;
};

} // namespace kodo
