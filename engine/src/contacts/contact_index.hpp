// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kodo {

/// The contacts of each body, and the place of each contact in the order of keys. Built by the
/// first removal after a change of the list of contacts, and valid until the next one. Removals
/// keep it valid: they leave empty places.
class ContactIndex {
public:
    bool isValid() const { return valid_; }
    void forget() { valid_ = false; }

    struct Entry {
        std::uint32_t bodyA;
        std::uint32_t bodyB;
        std::uint32_t slot;
    };
    /// entryAt(place) returns the contact at each place in the order.
    template <typename EntryAt>
    void build(std::size_t places, EntryAt entryAt) {
        valid_ = true;
        first_.clear();
        placeOf_.assign(places, 0);
        for (std::uint32_t place = 0; place < places; ++place) {
            const Entry entry = entryAt(place);
            placeOf_[entry.slot] = place;
            count(entry.bodyA);
            count(entry.bodyB);
        }
        std::uint32_t sum = 0;
        for (std::uint32_t& first : first_) {
            sum += first;
            first = sum; // the end of the range, until it is filled
        }
        first_.push_back(sum);
        places_.resize(sum);
        for (std::size_t place = places; place-- > 0;) {
            const Entry entry = entryAt(place);
            places_[--first_[entry.bodyA]] = static_cast<std::uint32_t>(place);
            places_[--first_[entry.bodyB]] = static_cast<std::uint32_t>(place);
        }
    }

    /// Places of the contacts of a body, in order; some may be empty since.
    std::span<const std::uint32_t> placesOf(std::uint32_t body) const {
        if (body + std::size_t{1} >= first_.size()) {
            return {}; // added later
        }
        const std::uint32_t begin = first_[body];
        return std::span(places_).subspan(begin, first_[body + std::size_t{1}] - begin);
    }
    /// Of the contact in a slot.
    std::uint32_t placeOf(std::uint32_t slot) const { return placeOf_[slot]; }
    /// The contact has moved to another slot.
    void moveSlot(std::uint32_t from, std::uint32_t to) { placeOf_[to] = placeOf_[from]; }

private:
    void count(std::uint32_t body) {
        if (body >= first_.size()) {
            first_.resize(body + std::size_t{1}, 0);
        }
        ++first_[body];
    }

    std::vector<std::uint32_t>
        first_; // by body: begin of its range in places_; one more at the end
    std::vector<std::uint32_t> places_;  // by body, in order
    std::vector<std::uint32_t> placeOf_; // by slot
    bool valid_ = false;
};

} // namespace kodo
