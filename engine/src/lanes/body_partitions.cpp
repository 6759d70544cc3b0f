// SPDX-License-Identifier: MIT
#include "lanes/body_partitions.hpp"

#include <array>
#include <numeric>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kHistogramBins = 256; // of body indices

} // namespace

void BodyPartitions::find(const Bodies& bodies, std::span<const ContactSummary> summaries,
                          std::uint32_t partitions) {
    const std::uint32_t width = static_cast<std::uint32_t>(bodies.size() / kHistogramBins) + 1;
    std::array<std::uint32_t, kHistogramBins> counts{};
    for (const ContactSummary& summary : summaries) {
        counts[summary.bodyA / width] += summary.inPasses() ? 1 : 0;
    }
    const std::size_t all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    first_.assign(1, 0);
    std::size_t before = 0;
    for (std::uint32_t bin = 0; first_.size() < partitions; ++bin) {
        before += counts[bin];
        while (first_.size() < partitions && (before * partitions >= all * first_.size())) {
            first_.push_back((bin + 1) * width);
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
