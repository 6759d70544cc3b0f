// SPDX-License-Identifier: MIT
// Palettes and flashes: what a player with other eyes needs.
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/palette.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "stage_rig.hpp"

namespace apart {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v) {
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i) {
        out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    }
    return out;
}

/// Simulation of a complete deficiency in linear RGB [Machado09, severity 1.0].
const Matrix& simulationOf(Vision vision) {
    static const std::array<Matrix, kVisions> kMatrices = {{
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {{{0.367322, 0.860646, -0.227968},
          {0.280085, 0.672501, 0.047413},
          {-0.011820, 0.042940, 0.968881}}},
        {{{0.152286, 1.052583, -0.204868},
          {0.114503, 0.786281, 0.099216},
          {-0.003882, -0.048116, 1.051998}}},
        {{{1.255528, -0.076749, -0.178779},
          {-0.078411, 0.930809, 0.147602},
          {0.004733, 0.691367, 0.303900}}},
    }};
    return kMatrices[static_cast<std::size_t>(vision)];
}

/// CIE L*a*b* of a colour (sRGB, D65) as a player sees it.
Triple seenAs(Color color, Vision vision) {
    const auto linear = [](std::uint8_t value) {
        const double c = value / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    Triple rgb = times(simulationOf(vision), {linear(color.r), linear(color.g), linear(color.b)});
    for (double& c : rgb) {
        c = std::clamp(c, 0.0, 1.0);
    }
    constexpr Matrix kToXyz = {{{0.4124564, 0.3575761, 0.1804375},
                                {0.2126729, 0.7151522, 0.0721750},
                                {0.0193339, 0.1191920, 0.9503041}}};
    const Triple xyz = times(kToXyz, rgb);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(xyz[0] / 0.95047);
    const double y = f(xyz[1]);
    const double z = f(xyz[2] / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Smallest distance (CIE76) of any two colours for a vision.
template <std::size_t N>
double closest(const std::array<Color, N>& colors, std::size_t first, Vision vision) {
    double least = 1000;
    for (std::size_t a = first; a < N; ++a) {
        for (std::size_t b = a + 1; b < N; ++b) {
            const Triple one = seenAs(colors[a], vision);
            const Triple other = seenAs(colors[b], vision);
            const double way = std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
            least = std::min(least, way);
        }
    }
    return least;
}

// 2.3 is the smallest visible distance side by side [Mahy94]. Stuffs are told apart at a glance, so
// they need ten times that; powers have symbols, and need five times.
TEST(Palette, ItsColorsAreFarApartForTheVisionItIsMadeFor) {
    for (std::size_t i = 1; i < kVisions; ++i) {
        SCOPED_TRACE(i);
        const auto vision = static_cast<Vision>(i);
        const Palette& palette = paletteOf(vision);
        EXPECT_GE(closest(palette.stuff, 0, vision), 23);
        EXPECT_GE(closest(palette.power, 1, vision), 11.5);
        EXPECT_GE(closest(palette.stuff, 0, Vision::Usual), 23);
    }
    EXPECT_GE(closest(paletteOf(Vision::Usual).stuff, 0, Vision::Usual), 23);
    // The usual palette is not enough for others.
    EXPECT_LT(closest(paletteOf(Vision::Usual).stuff, 0, Vision::Deuteranopia), 23);
    EXPECT_LT(closest(paletteOf(Vision::Usual).power, 1, Vision::Protanopia), 11.5);
}

TEST(Palette, IsASettingOfThePicture) {
    StageDef def = StageRig::playing();
    def.profile.settings.colors = static_cast<int>(Vision::Tritanopia);
    StageRig rig(std::move(def));
    rig.frame();
    EXPECT_EQ(&rig.picture().palette(), &paletteOf(Vision::Tritanopia));
    EXPECT_EQ(&paletteOf(17), &paletteOf(Vision::Usual)); // of a later version of the game
}

/// The most flashes of the field within one second (s) of real time, for a stream with every event
/// that flashes in each tick. `pace`: ticks of the game pass this much faster.
std::size_t mostFlashes(double pace, int calm) {
    Settings settings;
    settings.flash = 100;
    settings.calm = calm;
    Level level = *glassLevel("x", {0, 1, 2});
    Game game(level, 1);
    Juice juice(1, settings);
    juice.setPace(pace);
    Collapsed great;
    great.blocks = 20;
    const std::vector<Event> all = {LifeLost{}, Cleared{}, great, BossDown{}};
    std::vector<double> starts; // s
    float before = 0;
    for (int i = 0; i < 20 * kTicksPerSecond; ++i) {
        game.tick({});
        juice.tick(game);
        juice.take(game, std::vector<Event>{all[static_cast<std::size_t>(i) % all.size()]});
        // A flash is a rise by a tenth of the full luminance [WCAG21, general flash].
        if (juice.flashes().field() > before + 0.1f) {
            starts.push_back(i / (pace * kTicksPerSecond));
        }
        before = juice.flashes().field();
    }
    std::size_t most = 0;
    for (std::size_t a = 0; a < starts.size(); ++a) {
        std::size_t within = 0;
        while (a + within < starts.size() && starts[a + within] < starts[a] + 1) {
            ++within;
        }
        most = std::max(most, within);
    }
    return most;
}

TEST(Flashes, AreAtMostThreeASecondWhateverHappensAndAtAnySpeed) {
    for (const double pace : {0.125, 1.0, 8.0}) {
        SCOPED_TRACE(pace);
        EXPECT_LE(mostFlashes(pace, 0), 3u);
        EXPECT_EQ(mostFlashes(pace, 1), 0u); // reduced flashing
    }
    EXPECT_GE(mostFlashes(1, 0), 1u); // the test is not vacuous
}

TEST(Flashes, ReducedFlashingDimsImpactsToo) {
    Settings settings;
    settings.calm = 1;
    const Game game(*glassLevel("x", {7}), 1);
    Juice juice(1, settings);
    Cracked hit;
    hit.key = 3;
    hit.impulse = 20;
    juice.take(game, std::vector<Event>{hit});
    EXPECT_LE(juice.responseOfBlock(3).heat, Real(0.2));
    EXPECT_EQ(juice.flashes().punch(), 0);
}

} // namespace
} // namespace apart
