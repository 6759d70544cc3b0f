// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace apart {

/// A filter of second order [ITU-R BS.1770-4, annex 1], designed for any sample rate by the
/// bilinear transform of its analogue prototype.
struct Biquad {
    std::array<double, 3> b;
    std::array<double, 2> a;
    double z1 = 0;
    double z2 = 0;

    double next(double in) {
        const double out = b[0] * in + z1;
        z1 = b[1] * in - a[0] * out + z2;
        z2 = b[2] * in - a[1] * out;
        return out;
    }
};

/// First stage of the K-weighting: a shelf that lifts high frequencies by 4 dB.
inline Biquad shelfFilter(double rate) {
    const double k = std::tan(std::numbers::pi * 1681.974450955533 / rate);
    const double q = 0.7071752369554196;
    const double high = std::pow(10, 3.999843853973347 / 20);
    const double mid = std::pow(high, 0.4996667741545416);
    const double d = 1 + k / q + k * k;
    return {{(high + mid * k / q + k * k) / d, 2 * (k * k - high) / d,
             (high - mid * k / q + k * k) / d},
            {2 * (k * k - 1) / d, (1 - k / q + k * k) / d}};
}

/// Second stage: a high-pass filter.
inline Biquad highPassFilter(double rate) {
    const double k = std::tan(std::numbers::pi * 38.13547087602444 / rate);
    const double q = 0.5003270373238773;
    const double d = 1 + k / q + k * k;
    return {{1, -2, 1}, {2 * (k * k - 1) / d, (1 - k / q + k * k) / d}};
}

/// Energies of both channels after the K-weighting, of each tenth of a second of interleaved stereo
/// samples [ITU-R BS.1770-4].
inline std::vector<double> energiesOf(std::span<const float> samples, double rate) {
    const auto hop = static_cast<std::size_t>(rate / 10); // frames
    std::vector<double> energies;
    std::array<Biquad, 2> shelf = {shelfFilter(rate), shelfFilter(rate)};
    std::array<Biquad, 2> pass = {highPassFilter(rate), highPassFilter(rate)};
    double sum = 0;
    for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
        for (std::size_t ear = 0; ear < 2; ++ear) {
            const double in = static_cast<double>(samples[i + ear]);
            const double weighted = pass[ear].next(shelf[ear].next(in));
            sum += weighted * weighted;
        }
        if ((i / 2 + 1) % hop == 0) {
            energies.push_back(sum / static_cast<double>(hop));
            sum = 0;
        }
    }
    return energies;
}

inline double lufsOf(double energy) {
    return -0.691 + 10 * std::log10(std::max(energy, 1e-12));
}

/// Means of `length` tenths of a second, which begin a tenth apart.
inline std::vector<double> blocksOf(const std::vector<double>& energies, std::size_t length) {
    std::vector<double> blocks;
    for (std::size_t i = length; i <= energies.size(); ++i) {
        double sum = 0;
        for (std::size_t j = i - length; j < i; ++j) {
            sum += energies[j];
        }
        blocks.push_back(sum / static_cast<double>(length));
    }
    return blocks;
}

/// Mean of the blocks above -70 LUFS and above `below` LU under the mean of these.
inline double gatedMean(const std::vector<double>& blocks, double below) {
    const auto meanAbove = [&](double gate) {
        double all = 0;
        int count = 0;
        for (const double block : blocks) {
            all += block > gate ? block : 0;
            count += block > gate ? 1 : 0;
        }
        return count > 0 ? all / count : 0.0;
    };
    const double least = std::pow(10, (-70 + 0.691) / 10);
    return meanAbove(std::max(meanAbove(least) * std::pow(10, -below / 10), least));
}

/// Integrated loudness (LUFS) of interleaved stereo samples: blocks of 400 ms that overlap by 75 %,
/// gated at -70 LUFS and at 10 LU below the mean [ITU-R BS.1770-4].
inline double loudnessOf(std::span<const float> samples, double rate) {
    return lufsOf(gatedMean(blocksOf(energiesOf(samples, rate), 4), 10));
}

/// Loudness range (LU): from the 10th to the 95th percentile of blocks of 3 s, without those at 20
/// LU below the mean [EBU Tech 3342].
inline double loudnessRangeOf(std::span<const float> samples, double rate) {
    std::vector<double> blocks = blocksOf(energiesOf(samples, rate), 30);
    const double gate = gatedMean(blocks, 10) / 100;
    std::erase_if(blocks, [&](double block) { return block <= gate; });
    if (blocks.empty()) {
        return 0;
    }
    std::sort(blocks.begin(), blocks.end());
    const auto at = [&](double share) {
        return lufsOf(
            blocks[static_cast<std::size_t>(share * static_cast<double>(blocks.size() - 1) + 0.5)]);
    };
    return at(0.95) - at(0.10);
}

/// Share of the time in which no channel exceeds `level`, in pieces of 50 ms.
inline double silenceOf(std::span<const float> samples, double rate, float level) {
    const auto piece = 2 * static_cast<std::size_t>(rate / 20);
    int silent = 0;
    int all = 0;
    for (std::size_t i = 0; i + piece <= samples.size(); i += piece) {
        const auto part = samples.subspan(i, piece);
        ++all;
        silent += std::none_of(part.begin(), part.end(),
                               [&](float sample) { return std::abs(sample) > level; });
    }
    return all > 0 ? static_cast<double>(silent) / all : 1;
}

} // namespace apart
