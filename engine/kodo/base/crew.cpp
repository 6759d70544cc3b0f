// SPDX-License-Identifier: MIT
#include <kodo/base/crew.hpp>
#include <kodo/base/spin.hpp>

#include <algorithm>

namespace kodo::inline KODO_PRECISION {
namespace {

// A piece of somebody else's share costs more than it saves, since its data are in the other's
// cache: so who has done his own waits a little first. A spin takes some tens of nanoseconds.
constexpr int kPatience = 100;

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

void Crew::help() noexcept {
    const std::uint32_t own =
        (1 + shared_->came.fetch_add(1, std::memory_order_relaxed)) % shared_->count;
    shared_->shares[own].owned.store(true, std::memory_order_relaxed);
    workUntil(own, [&] { return shared_->over.load(std::memory_order_acquire); });
}

template <typename Ready>
void Crew::workUntil(std::uint32_t own, Ready ready) {
    for (int spins = 0; !ready(); spins = std::min(spins + 1, kManySpins)) {
        while (takePieceOf(shared_->shares[own])) {
            spins = 0;
        }
        for (std::uint32_t i = 1; i < shared_->count; ++i) {
            Share& other = shared_->shares[(own + i) % shared_->count];
            const bool leave = spins < kPatience && other.owned.load(std::memory_order_relaxed);
            if (!leave && takePieceOf(other)) {
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

} // namespace kodo::inline KODO_PRECISION
