// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact.hpp>

#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Lets bodies slide over the seams of ground that is made of pieces.
///
/// Where two locked pieces lie flush, a body that slides on the first meets the side or corner of
/// the second, and would bump into nothing. But if all of the second lies under the surface that
/// carries the body, the body cannot be under that surface to hit it: that contact is hidden for
/// the step. A real step or wall rises above the surface, and stays. Another part of the same body
/// may well be under that surface, as a fork over a wall is, and is not concerned.
class Seams {
public:
    /// After contacts came, went or changed places, or something was locked or set free; with the
    /// places of those between something locked and what can be pushed, in order, without sensors.
    void link(const Bodies& bodies, std::span<const ContactHead> heads,
              std::span<const std::uint32_t> onGround);
    void hide(const Bodies& bodies, std::span<Contact> contacts, std::span<ContactHead> heads,
              const Tolerances& tolerances) const;

private:
    static constexpr std::uint32_t kEnd = ~std::uint32_t{};

    std::vector<std::uint32_t> first_;    // by body: its first contact with something locked
    std::vector<std::uint32_t> next_;     // by contact, of those
    std::vector<std::uint32_t> onPieces_; // bodies with two of these or more
};

} // namespace kodo::inline KODO_PRECISION
