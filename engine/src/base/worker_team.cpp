// SPDX-License-Identifier: MIT
#include "base/worker_team.hpp"

#include "base/spin.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Spins before a thread takes work of another partition. The data of that work are in the other
// thread's cache, so stealing at once costs more than it saves. A spin takes some tens of
// nanoseconds.
constexpr int kPatience = 30;

/// The team whose Executor::begin() runs on this thread. A task that begin() calls itself would
/// wait for the end of a step that has not begun.
thread_local const WorkerTeam* gathering = nullptr;

struct Gathering {
    const WorkerTeam* outer;
    ~Gathering() { gathering = outer; }
};

} // namespace

void WorkerTeam::gather(Executor& executor) {
    executor_ = &executor;
    shared_.emplace();
    shared_->count = std::min(kMaxPartitions, static_cast<std::uint32_t>(executor.helpers()) + 1);
    const Gathering now{std::exchange(gathering, this)};
    executor.begin([](void* team) { static_cast<WorkerTeam*>(team)->help(); }, this);
}

void WorkerTeam::release() noexcept {
    shared_->over.store(true, std::memory_order_release);
    executor_->end();
}

void WorkerTeam::partition(const Job& job) noexcept {
    shared_->job = job;
    const auto pieces = static_cast<std::uint32_t>((job.count + job.grain - 1) / job.grain);
    shared_->done.store(0, std::memory_order_relaxed);
    for (std::uint32_t i = 0; i < shared_->count; ++i) {
        const std::uint64_t first = std::uint64_t{pieces} * i / shared_->count;
        const std::uint64_t last = std::uint64_t{pieces} * (i + 1) / shared_->count;
        shared_->partitions[i].left.store(last << 32 | first, std::memory_order_release);
    }
    shared_->partitions[0].owned.store(true, std::memory_order_relaxed);
    workUntil(0, [&] { return shared_->done.load(std::memory_order_acquire) == pieces; });
}

void WorkerTeam::sharePhases(const Job& job) noexcept {
    const std::span<Partition> partitions = std::span(shared_->partitions).first(shared_->count);
    shared_->job = job;
    for (Partition& partition : partitions) { // or one might seem to have done them all
        partition.phase.store(kNotYet, std::memory_order_relaxed);
    }
    for (Partition& partition : partitions) {
        partition.phase.store(0, std::memory_order_release);
    }
    partitions[0].owned.store(true, std::memory_order_relaxed);
    workUntil(0, [&] {
        return std::all_of(partitions.begin(), partitions.end(), [](const Partition& partition) {
            return partition.phase.load(std::memory_order_acquire) == kNoPhase;
        });
    });
}

void WorkerTeam::help() noexcept {
    if (gathering == this) {
        return;
    }
    const std::uint32_t own =
        (1 + shared_->came.fetch_add(1, std::memory_order_relaxed)) % shared_->count;
    shared_->partitions[own].owned.store(true, std::memory_order_relaxed);
    workUntil(own, [&] { return shared_->over.load(std::memory_order_acquire); });
}

template <typename Ready>
void WorkerTeam::workUntil(std::uint32_t own, Ready ready) {
    for (int spins = 0; !ready(); spins = std::min(spins + 1, kManySpins)) {
        while (takePieceOf(shared_->partitions[own]) || takePhasesOf(shared_->partitions[own])) {
            spins = 0;
        }
        for (std::uint32_t i = 1; i < shared_->count; ++i) {
            Partition& other = shared_->partitions[(own + i) % shared_->count];
            const bool leave = spins < kPatience && other.owned.load(std::memory_order_relaxed);
            if (!leave && (takePieceOf(other) || takePhasesOf(other))) {
                break;
            }
        }
        pauseSpin(spins);
    }
}

bool WorkerTeam::takePieceOf(Partition& partition) noexcept {
    const auto any = [](std::uint64_t left) {
        return static_cast<std::uint32_t>(left) < left >> 32;
    };
    if (!any(partition.left.load(std::memory_order_relaxed))) {
        return false; // no fetch_add, so that idle threads do not increment without end
    }
    const std::uint64_t left = partition.left.fetch_add(1, std::memory_order_acq_rel);
    if (!any(left)) {
        return false;
    }
    const std::size_t first = static_cast<std::uint32_t>(left) * shared_->job.grain;
    shared_->job.call(shared_->job.work, first,
                      std::min(first + shared_->job.grain, shared_->job.count));
    shared_->done.fetch_add(1, std::memory_order_release);
    return true;
}

/// True if all partitions have completed the previous even phase, or if this phase is odd.
bool WorkerTeam::mayBegin(std::int32_t phase) const noexcept {
    const auto all = std::span(shared_->partitions).first(shared_->count);
    return phase % 2 == 1 || std::all_of(all.begin(), all.end(), [&](const Partition& other) {
               return other.phase.load(std::memory_order_acquire) > phase - 2;
           });
}

/// Runs all phases of a partition that may begin, unless another thread runs it.
bool WorkerTeam::takePhasesOf(Partition& partition) noexcept {
    const auto next = [&] { return partition.phase.load(std::memory_order_acquire); };
    const auto any = [&](std::int32_t phase) {
        return phase != kNoPhase && phase != kNotYet && mayBegin(phase);
    };
    if (!any(next()) || partition.busy.exchange(true, std::memory_order_acquire)) {
        return false;
    }
    const auto own = static_cast<std::size_t>(&partition - shared_->partitions.data());
    bool done = false;
    for (std::int32_t phase = next(); any(phase); phase = next()) {
        const std::size_t phases = shared_->job.count;
        const auto number = static_cast<std::size_t>(phase);
        shared_->job.call(shared_->job.work, own, number);
        partition.phase.store(number + 1 == phases ? kNoPhase : phase + 1,
                              std::memory_order_release);
        done = true;
    }
    partition.busy.store(false, std::memory_order_release);
    return done;
}

} // namespace KODO_PRECISION
} // namespace kodo
