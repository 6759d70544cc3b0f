// SPDX-License-Identifier: MIT
#pragma once

#include "base/vector_reuse.hpp"
#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// The number of touching contacts of each body, and the bodies for which it has changed.
class TouchCounts {
public:
    void resize(const Bodies& bodies) { resizeByBody(counts_, bodies); }
    bool isTouched(std::uint32_t body) const { return counts_[body] > 0; }
    /// Bodies whose isTouched may have changed since clearChanges; may contain duplicates.
    std::span<const std::uint32_t> changes() const { return changes_; }
    void clearChanges() { changes_.clear(); }

    /// The contact began or ceased to touch.
    void count(const Contact& contact, bool touches) {
        for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
            counts_[body] += touches ? 1u : kOneLess;
            appendIndex(changes_, body, counts_.size());
        }
    }
    /// The same on any thread, without a change in changes(): see addChanges.
    void count(const WorkerTeam& team, const ContactSummary& summary, bool touches) {
        for (const std::uint32_t body : {summary.bodyA, summary.bodyB}) {
            team.count(counts_[body], touches ? 1u : kOneLess);
        }
    }
    /// Adds the bodies of contacts that began or ceased to touch.
    void addChanges(std::span<const ContactSummary> summaries,
                    std::span<const std::uint32_t> slots) {
        for (const std::uint32_t slot : slots) {
            changes_.push_back(summaries[slot].bodyA);
            changes_.push_back(summaries[slot].bodyB);
        }
    }
    /// Makes room for changes of this many contacts, which then allocate nothing.
    void reserveChanges(std::size_t contacts) {
        reserveReusing(changes_, changes_.size() + 2 * contacts);
    }
    /// Sets the counts from all contacts. Lists the bodies whose flag kColliding is out of date.
    void recount(std::span<const Contact> contacts, const Bodies& bodies) {
        counts_.assign(bodies.size(), 0);
        for (const Contact& contact : contacts) {
            if (contact.wasTouching) {
                ++counts_[contact.key.bodyA];
                ++counts_[contact.key.bodyB];
            }
        }
        changes_.clear();
        for (std::uint32_t body = 0; body < bodies.size(); ++body) {
            if (((bodies.filter[body].flags & kColliding) != 0) != isTouched(body)) {
                changes_.push_back(body);
            }
        }
    }

private:
    static constexpr std::uint32_t kOneLess = ~std::uint32_t{}; // -1, added to unsigned counts

    std::vector<std::uint32_t> counts_; // by body
    std::vector<std::uint32_t> changes_;
};

} // namespace KODO_PRECISION
} // namespace kodo
