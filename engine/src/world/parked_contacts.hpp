// SPDX-License-Identifier: MIT
#pragma once

#include "base/pair_lists.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Parked contacts in the order in which they were added, and those of each body. A change costs
/// the contacts of its bodies, however many others are parked.
class ParkedContacts {
public:
    bool isEmpty() const { return gaps_ == contacts_.size(); }
    void add(const StoredContact& contact);
    /// Removes the contacts for which which(contact) is true, and appends them to `taken`, in
    /// order: those of some bodies, or all.
    template <typename Which>
    void take(std::span<const std::uint32_t> of, Which which, std::vector<StoredContact>& taken) {
        slots_.clear();
        for (const std::uint32_t body : of) {
            lists_.forEach(body, [&](std::uint32_t slot) { noteIf(slot, which); });
        }
        takeNoted(taken);
    }
    template <typename Which>
    void take(Which which, std::vector<StoredContact>& taken) {
        slots_.clear();
        for (std::uint32_t slot = 0; slot < contacts_.size(); ++slot) {
            if (!isGap(contacts_[slot])) {
                noteIf(slot, which);
            }
        }
        takeNoted(taken);
    }
    /// Calls visit(contact) for all, in order.
    template <typename Visit>
    void forEach(Visit visit) const {
        for (const StoredContact& contact : contacts_) {
            if (!isGap(contact)) {
                visit(contact);
            }
        }
    }
    /// Contacts visited by take(), of all calls so far.
    std::uint64_t visits() const { return visits_; }
    void visitState(StateStream& stream, const Bodies& bodies);

private:
    /// No contact is of one body alone.
    static bool isGap(const Contact& contact) { return contact.key.bodyA == contact.key.bodyB; }
    template <typename Which>
    void noteIf(std::uint32_t slot, Which which) {
        ++visits_;
        if (which(contacts_[slot])) {
            slots_.push_back(slot);
        }
    }
    void takeNoted(std::vector<StoredContact>& taken);
    void closeGaps();
    void listAll();

    std::vector<StoredContact> contacts_; // with gaps: a removal keeps the order of the others
    std::size_t gaps_ = 0;
    PairLists lists_;                  // by body: indices in contacts_
    std::vector<std::uint32_t> slots_; // scratch of take()
    std::uint64_t visits_ = 0;
};

} // namespace KODO_PRECISION
} // namespace kodo
