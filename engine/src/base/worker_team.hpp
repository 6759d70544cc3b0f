// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/executor.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The stepping thread and its helpers, for one step. Loops are cut into pieces whose size is
/// independent of the number of threads. Each thread starts with the pieces of its own partition.
/// These are the same in every loop of equal length, so their data are often still in its cache.
/// Then it takes pieces of other partitions. Assignment and order of pieces are unspecified, so a
/// piece must not access data that another one modifies.
class WorkerTeam {
public:
    static constexpr std::uint32_t kMaxPartitions = 16;

    /// No helpers.
    WorkerTeam() = default;
    /// Uses the executor's threads; nullptr: no helpers.
    explicit WorkerTeam(Executor* executor) {
        if (executor != nullptr && executor->helpers() > 0) {
            gather(*executor);
        }
    }
    WorkerTeam(const WorkerTeam&) = delete;
    WorkerTeam& operator=(const WorkerTeam&) = delete;
    ~WorkerTeam() {
        if (executor_ != nullptr) {
            release();
        }
    }

    bool alone() const { return executor_ == nullptr; }

    /// Calls work(first, last) for pieces of 0..count, `grain` elements each, and returns when all
    /// are done. A loop of one piece runs on the caller. With helpers, work must not throw: an
    /// out-of-memory error then terminates the program.
    template <typename Work>
    void forEach(std::size_t count, std::size_t grain, const Work& work) {
        if (executor_ == nullptr || count <= grain) {
            work(std::size_t{0}, count);
            return;
        }
        partition({&work,
                   [](const void* of, std::size_t first, std::size_t last) {
                       (*static_cast<const Work*>(of))(first, last);
                   },
                   count, grain});
    }

    /// Partitions of inPhases(): one for each helper and one for the caller; at most
    /// kMaxPartitions.
    std::uint32_t partitions() const { return alone() ? 1 : shared_->count; }
    /// Calls work(partition, phase) for all partitions, and for the phases 0..phases-1 of each in
    /// order. An even phase begins when all partitions have completed the previous even phase. An
    /// odd phase begins at once. Data shared by partitions belong into even phases, data of one
    /// partition into odd phases, during which the others catch up. With helpers, work must not
    /// throw.
    template <typename Work>
    void inPhases(std::uint32_t phases, const Work& work) {
        if (alone()) {
            for (std::uint32_t phase = 0; phase < phases; ++phase) {
                work(std::uint32_t{0}, phase);
            }
        } else if (phases > 0) {
            sharePhases({&work,
                         [](const void* of, std::size_t partition, std::size_t phase) {
                             (*static_cast<const Work*>(of))(static_cast<std::uint32_t>(partition),
                                                             static_cast<std::uint32_t>(phase));
                         },
                         phases, 1});
        }
    }

    // For data that several pieces write. These use plain numbers, which are copied with a World;
    // std::atomic_ref is missing in some supported standard libraries.

    /// Sets a flag that several pieces may set concurrently.
    template <typename Mark>
    static void mark(Mark& shared) {
        __atomic_store_n(&shared, Mark{1}, __ATOMIC_RELAXED);
    }
    /// Adds to a counter and returns its previous value.
    template <typename Count>
    Count count(Count& shared, Count more = 1) const {
        if (alone()) {
            const Count before = shared;
            shared = static_cast<Count>(before + more);
            return before;
        }
        return __atomic_fetch_add(&shared, more, __ATOMIC_RELAXED);
    }
    /// Atomic maximum.
    template <typename Number>
    static void raise(Number& shared, Number value) {
        Number known{};
        __atomic_load(&shared, &known, __ATOMIC_RELAXED);
        while (known < value && !__atomic_compare_exchange(&shared, &known, &value, true,
                                                           __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
        }
    }

private:
    struct Job {
        const void* work = nullptr;
        /// For a piece [first, last), or for a partition and a phase.
        void (*call)(const void* work, std::size_t first, std::size_t last) = nullptr;
        std::size_t count = 0; // or the number of phases
        std::size_t grain = 1;
    };

    /// Remaining pieces of the job: the first in the lower 32 bits, the end in the upper 32 bits. A
    /// single atomic, so a piece is always taken from the current job.
    struct alignas(64) Partition {
        std::atomic<std::uint64_t> left{0};
        std::atomic<bool> owned{false}; // a thread has this partition as its own
        std::atomic<bool> busy{false};  // a thread runs phases of it
        alignas(64) std::atomic<std::int32_t> phase{kNoPhase}; // the next phase
    };
    static constexpr std::int32_t kNotYet = -1; // before all partitions are ready
    static constexpr std::int32_t kNoPhase = std::numeric_limits<std::int32_t>::max();

    void gather(Executor& executor);
    void release() noexcept;
    void partition(const Job& job) noexcept;
    void sharePhases(const Job& job) noexcept;
    void help() noexcept;
    template <typename Ready>
    void workUntil(std::uint32_t own, Ready ready);
    bool takePieceOf(Partition& partition) noexcept;
    bool takePhasesOf(Partition& partition) noexcept;
    bool mayBegin(std::int32_t phase) const noexcept;

    /// Exists only with helpers, so that a step without them does not pay for it.
    struct Shared {
        Shared() {} // NOLINT: std::optional does not find the implicit one in a nested class

        Job job;
        std::uint32_t count = 1; // number of partitions
        std::array<Partition, kMaxPartitions> partitions;
        std::atomic<std::uint32_t> came{0};             // helpers that have started
        alignas(64) std::atomic<std::uint32_t> done{0}; // completed pieces
        std::atomic<bool> over{false};
    };

    Executor* executor_ = nullptr;
    std::optional<Shared> shared_;
};

/// Calls work(from, to) for pieces of first..last, `grain` elements each, in order.
template <typename Work>
void forPieces(std::size_t first, std::size_t last, std::size_t grain, const Work& work) {
    for (std::size_t from = first; from < last; from += grain) {
        work(from, std::min(from + grain, last));
    }
}

/// Concatenates the results of a loop's pieces in the order of the pieces.
template <typename T>
class ParallelCollector {
public:
    /// Calls find(first, last, out) as WorkerTeam::forEach() does, and appends all results to
    /// `out`.
    template <typename Find>
    void gather(WorkerTeam& team, std::size_t count, std::size_t grain, std::vector<T>& out,
                const Find& find) {
        if (team.alone() || count <= grain) {
            find(std::size_t{0}, count, out);
            return;
        }
        const std::size_t pieces = (count + grain - 1) / grain;
        if (byPiece_.size() < pieces) {
            byPiece_.resize(pieces);
        }
        team.forEach(count, grain, [&](std::size_t first, std::size_t last) {
            std::vector<T>& found = byPiece_[first / grain];
            found.clear();
            find(first, last, found);
        });
        for (std::size_t i = 0; i < pieces; ++i) {
            out.insert(out.end(), byPiece_[i].begin(), byPiece_[i].end());
        }
    }

private:
    std::vector<std::vector<T>> byPiece_;
};

} // namespace KODO_PRECISION
} // namespace kodo
