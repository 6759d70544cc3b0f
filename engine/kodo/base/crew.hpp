// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/executor.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// The thread that steps and those that help it, for the time of one step. Loops are cut into
/// pieces of a size that does not depend on how many threads there are. Each thread begins with
/// those of its own share, which are the same in every loop of that length, so that it finds much
/// of their data in its cache; then it helps the others. Who does which piece, and when, is left
/// open, so a piece must touch nothing that another one changes.
class Crew {
public:
    static constexpr std::uint32_t kMostShares = 16;

    /// Nobody helps.
    Crew() = default;
    /// The executor's threads help; nullptr: nobody does.
    explicit Crew(Executor* executor) {
        if (executor != nullptr && executor->helpers() > 0) {
            gather(*executor);
        }
    }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    ~Crew() {
        if (executor_ != nullptr) {
            dismiss();
        }
    }

    bool alone() const { return executor_ == nullptr; }

    /// Calls work(first, last) for pieces of 0..count, `grain` each, and returns when all is done.
    /// What fits into one piece is done at once, by the caller. Where others help, work must not
    /// throw: a program that is out of memory then ends.
    template <typename Work>
    void forEach(std::size_t count, std::size_t grain, const Work& work) {
        if (executor_ == nullptr || count <= grain) {
            work(std::size_t{0}, count);
            return;
        }
        share({&work,
               [](const void* of, std::size_t first, std::size_t last) {
                   (*static_cast<const Work*>(of))(first, last);
               },
               count, grain});
    }

    /// Shares that inTurns() cuts work into: one for each thread that may come, and the caller's;
    /// at most kMostShares.
    std::uint32_t shares() const { return alone() ? 1 : shared_->count; }
    /// Calls work(share, turn) for all shares and for the turns 0..turns-1 of each, in their order.
    /// An even turn begins when all shares have done the even one before it; an odd one waits for
    /// nobody. So what shares have in common belongs into even turns, and what each has for itself
    /// into odd ones, during which the others may catch up. Work must not throw where others help.
    template <typename Work>
    void inTurns(std::uint32_t turns, const Work& work) {
        if (alone()) {
            for (std::uint32_t turn = 0; turn < turns; ++turn) {
                work(std::uint32_t{0}, turn);
            }
        } else if (turns > 0) {
            shareTurns({&work,
                        [](const void* of, std::size_t share, std::size_t turn) {
                            (*static_cast<const Work*>(of))(static_cast<std::uint32_t>(share),
                                                            static_cast<std::uint32_t>(turn));
                        },
                        turns, 1});
        }
    }

    // For what several pieces write all the same. These work on plain numbers, which can be copied
    // with a World; std::atomic_ref is not in every library Kodo is built with.

    /// Sets a mark that another piece may set at the same time.
    template <typename Mark>
    static void mark(Mark& shared) {
        __atomic_store_n(&shared, Mark{1}, __ATOMIC_RELAXED);
    }
    /// Counts so many more, and returns how many there were before.
    template <typename Count>
    Count count(Count& shared, Count more = 1) const {
        if (alone()) {
            const Count before = shared;
            shared = static_cast<Count>(before + more);
            return before;
        }
        return __atomic_fetch_add(&shared, more, __ATOMIC_RELAXED);
    }
    /// Keeps the largest.
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
        /// Of a piece; or with a share and a turn of it.
        void (*call)(const void* work, std::size_t first, std::size_t last) = nullptr;
        std::size_t count = 0; // or the number of turns
        std::size_t grain = 1;
    };

    /// Pieces of the job that are still to be taken: the first of them in the lower half, the one
    /// behind the last in the upper. One number, so that who takes a piece takes it of this job.
    struct alignas(64) Share {
        std::atomic<std::uint64_t> left{0};
        std::atomic<bool> owned{false};                      // somebody has come who does it
        std::atomic<bool> busy{false};                       // somebody does turns of it
        alignas(64) std::atomic<std::int32_t> turn{kNoTurn}; // that comes next
    };
    static constexpr std::int32_t kNotYet = -1; // before all shares are there to be begun
    static constexpr std::int32_t kNoTurn = std::numeric_limits<std::int32_t>::max();

    void gather(Executor& executor);
    void dismiss() noexcept;
    void share(const Job& job) noexcept;
    void shareTurns(const Job& job) noexcept;
    void help() noexcept;
    template <typename Ready>
    void workUntil(std::uint32_t own, Ready ready);
    bool takePieceOf(Share& share) noexcept;
    bool takeTurnsOf(Share& share) noexcept;
    bool mayBegin(std::int32_t turn) const noexcept;

    /// What is there only when somebody helps, so that a small step does not pay for it.
    struct Shared {
        Shared() {} // NOLINT: std::optional does not find the implicit one in a nested class

        Job job;
        std::uint32_t count = 1; // of the shares
        std::array<Share, kMostShares> shares;
        std::atomic<std::uint32_t> came{0};             // helpers
        alignas(64) std::atomic<std::uint32_t> done{0}; // pieces
        std::atomic<bool> over{false};
    };

    Executor* executor_ = nullptr;
    std::optional<Shared> shared_;
};

/// Calls work(from, to) for pieces of first..last, `grain` each, in their order.
template <typename Work>
void forPieces(std::size_t first, std::size_t last, std::size_t grain, const Work& work) {
    for (std::size_t from = first; from < last; from += grain) {
        work(from, std::min(from + grain, last));
    }
}

/// What the pieces of a loop find, put together in their order.
template <typename T>
class Findings {
public:
    /// Calls find(first, last, out) as Crew::forEach does, and adds all that it finds to `out`.
    template <typename Find>
    void gather(Crew& crew, std::size_t count, std::size_t grain, std::vector<T>& out,
                const Find& find) {
        if (crew.alone() || count <= grain) {
            find(std::size_t{0}, count, out);
            return;
        }
        const std::size_t pieces = (count + grain - 1) / grain;
        if (byPiece_.size() < pieces) {
            byPiece_.resize(pieces);
        }
        crew.forEach(count, grain, [&](std::size_t first, std::size_t last) {
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

} // namespace kodo::inline KODO_PRECISION
