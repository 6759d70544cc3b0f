// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/contacts/contact.hpp>
#include <kodo/solve/contact_block.hpp>

#include <array>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Arranges contacts into blocks for one step. Contacts that push the same body get different
/// colours, the lowest that is free, in the order in which they are added; the passes go through
/// colour by colour. Contacts with what cannot be pushed come last, so that they have the last
/// word.
class ContactBlocks {
public:
    void clear(const Bodies& bodies);
    /// Takes a contact that responds. `place` is that in the list that store() will be given.
    void add(const Bodies& bodies, const Contact& contact, std::uint32_t place);
    /// Lays out what was added. `pushSpeed` (m/s) is shared out among those who crowd a body.
    void arrange(const Bodies& bodies, std::span<const Contact> contacts,
                 std::span<const std::uint16_t> crowd, Real pushSpeed, bool rolling);

    ContactPassArguments pass(Bodies& bodies, const PassSettings& settings);
    std::size_t size() const { return rows_.size(); }

    /// Hands the impulses of the step to the contacts they belong to.
    void store(std::span<Contact> contacts) const;

private:
    static constexpr std::size_t kFreeColours = 48;
    static constexpr std::size_t kColours = 64;          // the others are for what cannot be pushed
    static constexpr std::size_t kGroups = kColours + 2; // and two for those that found no colour

    struct Row {
        std::uint32_t contact;
        std::uint32_t slot; // while rows are added: place in counts_; then block * 8 + lane
    };

    void placeRows(std::span<const Contact> contacts);
    void fill(const Bodies& bodies, const Contact& contact, std::uint32_t slot, Real pushSpeed);
    void addRolling(const Bodies& bodies, const Contact& contact, std::uint32_t slot);

    std::vector<std::uint64_t> colours_; // by body: those that it has
    std::vector<Row> rows_;
    std::array<std::uint32_t, 2 * kGroups> counts_{}; // by group: with one point, with two
    std::vector<ContactBlock> blocks_;
    std::vector<BlockUse> use_;
    std::vector<RollingBlock> rolling_;
};

} // namespace kodo::inline KODO_PRECISION
