// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/math/octagon.hpp>

#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Bounds of every part of every body, in order: where it is, and where it may be until its pairs
/// are looked for again. Those whose bounds are new are listed.
class PartBounds {
public:
    struct Part {
        std::uint32_t body;
        std::uint16_t part;
    };

    const Part& part(std::size_t i) const { return parts_[i]; }
    std::uint32_t indexOf(std::uint32_t body, std::uint16_t part) const {
        return firstPart_[body] + part;
    }
    const Octagon& tight(std::size_t i) const { return tight_[i]; }
    std::span<const Octagon> grown() const { return grown_; }
    std::span<const std::uint32_t> changed() const { return changed_; }
    std::span<const std::uint8_t> isChanged() const { return isChanged_; }

    /// Numbers the parts, after bodies came, went or changed. Their bounds are not those of before.
    void number(const Bodies& bodies);
    /// Numbers the parts, finds their bounds, and lists them all.
    void renew(const Bodies& bodies, const Tolerances& tolerances);
    /// The same where only these bodies did, in order: the bounds of the others stay. True if some
    /// have other numbers now.
    bool renew(const Bodies& bodies, const Tolerances& tolerances,
               std::span<const std::uint32_t> changed);
    /// By its index before: that of a part of a body that has not changed.
    std::uint32_t indexNow(std::uint32_t before, std::uint32_t body) const {
        return before - firstBefore_[body] + firstPart_[body];
    }
    /// Lists them all.
    void listAll();
    /// Lists those of one body.
    void listBody(std::uint32_t body);
    /// Before a step of dt: grows the bounds of what will leave them if nothing pushes it.
    void foresee(const Bodies& bodies, const Tolerances& tolerances, Real dt, Crew& crew);
    /// Grows the bounds of what the solver sent out of them.
    void coverMoves(const Bodies& bodies, const Tolerances& tolerances, Crew& crew);
    /// Their pairs have been found.
    void clearChanged();

private:
    friend class SnapshotFields;
    static constexpr std::size_t kBodiesAPiece = 128;

    /// What the bounds of a part are found from. Those of all parts lie one behind the other, since
    /// the way to a form leads through memory that no step has at hand.
    struct Outline {
        std::uint32_t first = 0; // of its corners
        std::uint32_t count = 0; // of them; 1: it may be round; 0: it is a plane
        Real radius = 0;         // m
    };

    /// Of parts, in place of which there will be `count` others.
    struct Replaced {
        std::size_t first;
        std::size_t last; // the one behind them
        std::size_t count;
    };

    void addOutline(const Convex& convex);
    void setOutline(std::size_t i, const Convex& convex);
    bool renumber(const Bodies& bodies, std::span<const std::uint32_t> changed);
    template <typename T>
    void replace(std::vector<T>& list) const;
    Octagon boundsAt(const Bodies& bodies, std::size_t i, const Transform& pose) const;
    void list(std::size_t i, std::vector<std::uint32_t>& changed);
    template <typename Outgrow>
    void listOutgrown(const Bodies& bodies, Crew& crew, Outgrow outgrow);

    std::vector<Part> parts_;
    std::vector<std::uint32_t> firstPart_;   // by body; and behind the last
    std::vector<std::uint32_t> firstBefore_; // the same, before parts were renumbered last
    std::vector<Replaced> replaced_;
    std::vector<Outline> outlines_;
    std::vector<Vec2> corners_;
    std::size_t leftOver_ = 0; // of the corners: of outlines that are gone
    std::vector<Octagon> tight_;
    std::vector<Octagon> grown_;
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint8_t> isChanged_;
    Findings<std::uint32_t> outgrown_;
};

} // namespace kodo::inline KODO_PRECISION
