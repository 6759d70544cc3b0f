// SPDX-License-Identifier: MIT
#include <kodo/base/crew.hpp>
#include <kodo/base/spin.hpp>

#include <algorithm>
#include <span>

namespace kodo::inline KODO_PRECISION {
namespace {

// A piece of somebody else's share costs more than it saves, since its data are in the other's
// cache: so who has done his own waits a little first. A spin takes some tens of nanoseconds.
constexpr int kPatience = 30;

} // namespace

void Crew::gather(Executor& executor) {
    executor_ = &executor;
    shared_.emplace();
    shared_->count = std::min(kMostShares, static_cast<std::uint32_t>(executor.helpers()) + 1);
    executor.begin([](void* crew) { static_cast<Crew*>(crew)->help(); }, this);
}

void Crew::dismiss() noexcept {
    shared_->over.store(true, std::memory_order_release);
    executor_->end();
}

void Crew::share(const Job& job) noexcept {
    shared_->job = job;
    const auto pieces = static_cast<std::uint32_t>((job.count + job.grain - 1) / job.grain);
    shared_->done.store(0, std::memory_order_relaxed);
    for (std::uint32_t i = 0; i < shared_->count; ++i) {
        const std::uint64_t first = std::uint64_t{pieces} * i / shared_->count;
        const std::uint64_t last = std::uint64_t{pieces} * (i + 1) / shared_->count;
        shared_->shares[i].left.store(last << 32 | first, std::memory_order_release);
    }
    shared_->shares[0].owned.store(true, std::memory_order_relaxed);
    workUntil(0, [&] { return shared_->done.load(std::memory_order_acquire) == pieces; });
}

void Crew::shareTurns(const Job& job) noexcept {
    const std::span<Share> shares = std::span(shared_->shares).first(shared_->count);
    shared_->job = job;
    for (Share& share : shares) { // or one might seem to have done them all
        share.turn.store(kNotYet, std::memory_order_relaxed);
    }
    for (Share& share : shares) {
        share.turn.store(0, std::memory_order_release);
    }
    shares[0].owned.store(true, std::memory_order_relaxed);
    workUntil(0, [&] {
        return std::all_of(shares.begin(), shares.end(), [](const Share& share) {
            return share.turn.load(std::memory_order_acquire) == kNoTurn;
        });
    });
}

void Crew::help() noexcept {
    const std::uint32_t own =
        (1 + shared_->came.fetch_add(1, std::memory_order_relaxed)) % shared_->count;
    shared_->shares[own].owned.store(true, std::memory_order_relaxed);
    workUntil(own, [&] { return shared_->over.load(std::memory_order_acquire); });
}

template <typename Ready>
void Crew::workUntil(std::uint32_t own, Ready ready) {
    for (int spins = 0; !ready(); spins = std::min(spins + 1, kManySpins)) {
        while (takePieceOf(shared_->shares[own]) || takeTurnsOf(shared_->shares[own])) {
            spins = 0;
        }
        for (std::uint32_t i = 1; i < shared_->count; ++i) {
            Share& other = shared_->shares[(own + i) % shared_->count];
            const bool leave = spins < kPatience && other.owned.load(std::memory_order_relaxed);
            if (!leave && (takePieceOf(other) || takeTurnsOf(other))) {
                break;
            }
        }
        pauseSpin(spins);
    }
}

bool Crew::takePieceOf(Share& share) noexcept {
    const auto any = [](std::uint64_t left) {
        return static_cast<std::uint32_t>(left) < left >> 32;
    };
    if (!any(share.left.load(std::memory_order_relaxed))) {
        return false; // so that the idle do not count on and on
    }
    const std::uint64_t left = share.left.fetch_add(1, std::memory_order_acq_rel);
    if (!any(left)) {
        return false;
    }
    const std::size_t first = static_cast<std::uint32_t>(left) * shared_->job.grain;
    shared_->job.call(shared_->job.work, first,
                      std::min(first + shared_->job.grain, shared_->job.count));
    shared_->done.fetch_add(1, std::memory_order_release);
    return true;
}

/// Have all shares done the turn before that it has to wait for?
bool Crew::mayBegin(std::int32_t turn) const noexcept {
    const auto all = std::span(shared_->shares).first(shared_->count);
    return turn % 2 == 1 || std::all_of(all.begin(), all.end(), [&](const Share& other) {
               return other.turn.load(std::memory_order_acquire) > turn - 2;
           });
}

/// As many turns of the share as may be done, if nobody else is at it.
bool Crew::takeTurnsOf(Share& share) noexcept {
    const auto next = [&] { return share.turn.load(std::memory_order_acquire); };
    const auto any = [&](std::int32_t turn) {
        return turn != kNoTurn && turn != kNotYet && mayBegin(turn);
    };
    if (!any(next()) || share.busy.exchange(true, std::memory_order_acquire)) {
        return false;
    }
    const auto own = static_cast<std::size_t>(&share - shared_->shares.data());
    bool done = false;
    for (std::int32_t turn = next(); any(turn); turn = next()) {
        const std::size_t turns = shared_->job.count;
        const auto number = static_cast<std::size_t>(turn);
        shared_->job.call(shared_->job.work, own, number);
        share.turn.store(number + 1 == turns ? kNoTurn : turn + 1, std::memory_order_release);
        done = true;
    }
    share.busy.store(false, std::memory_order_release);
    return done;
}

} // namespace kodo::inline KODO_PRECISION
