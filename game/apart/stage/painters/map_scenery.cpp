// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/map_scenery.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr Color kDim{22, 24, 38}; // of a land that is closed
constexpr int kSteps = 48;        // of a ridge

/// Arguments of the painters of a land. Lengths are shares of the height of its band.
struct Land {
    Canvas& canvas;
    Aabb band;
    Real unit;   // m, height of the band
    Color color; // of what stands on the ridge
    Color lights;
    Real time; // s
    Theme theme;

    /// Height of the ridge at a share of the width, m.
    Real ridge(Real share) const {
        const Real wave = Real(0.5) * std::sin(7 * share + static_cast<Real>(theme)) +
                          Real(0.5) * std::sin(19 * share + 2 * static_cast<Real>(theme));
        const Real rise = theme == Theme::Quarry     ? std::floor(2 * wave + Real(0.5)) / 2
                          : theme == Theme::Harbour  ? Real(0.35) * std::sin(40 * share + time)
                          : theme == Theme::Fortress ? Real(0.3) * wave
                                                     : wave;
        return band.upper.y + Real(0.08) * unit * rise - Real(0.5) * unit;
    }
    Vec2 at(Real share, Real up) const {
        return {band.lower.x + share * band.extent().x, ridge(share) + up * unit};
    }
    void box(Real share, Real width, Real height, Color above) const {
        const Vec2 foot = at(share, Real(-0.1));
        const Real half = width * unit / 2;
        canvas.rectangle(
            {{foot.x - half, foot.y}, {foot.x + half, foot.y + (height + Real(0.1)) * unit}},
            darker(above, 0.35f), above);
    }
    void roof(Real share, Real width, Real from, Real to) const {
        const Vec2 half{width * unit / 2, 0};
        canvas.polygon(std::array{at(share, from) - half, at(share, from) + half, at(share, to)},
                       color);
    }
};

void paintSunrise(const Land& land) {
    const Vec2 sun = land.at(Real(0.5), Real(-0.02));
    land.canvas.setGlow(true);
    for (int i = 0; i < 13; ++i) {
        const Real angle = kTurn * (static_cast<Real>(i) + Real(0.5)) / 26;
        const Real reach =
            (Real(0.95) + Real(0.08) * std::sin(land.time + 2 * static_cast<Real>(i))) * land.unit;
        const std::array<Color, 3> colors = {faded(land.lights, 0.35f), faded(land.lights, 0),
                                             faded(land.lights, 0)};
        land.canvas.facet(std::array{sun, sun + reach * towards(angle - Real(0.06)),
                                     sun + reach * towards(angle + Real(0.06))},
                          colors);
    }
    land.canvas.disc(sun, Real(1.1) * land.unit, faded(land.lights, 0.4f), faded(land.lights, 0));
    land.canvas.setGlow(false);
    land.canvas.disc(sun, Real(0.36) * land.unit, lighter(land.lights, 0.4f), land.lights);
}

void paintPits(const Land& land) {
    for (const Real share : {Real(0.16), Real(0.44), Real(0.79)}) { // cranes
        const Vec2 foot = land.at(share, 0);
        const Vec2 top = foot + land.unit * Vec2{0, Real(0.62)};
        const Vec2 tip =
            top + land.unit * Vec2{share < Real(0.5) ? Real(0.55) : Real(-0.55), Real(0.1)};
        land.canvas.line(foot, top, Real(0.06) * land.unit, land.color);
        land.canvas.line(top - Real(0.4) * (tip - top), tip, Real(0.045) * land.unit, land.color);
        const Vec2 load = tip - land.unit * Vec2{Real(0.03) * std::sin(land.time), Real(0.32)};
        land.canvas.line(tip, load, Real(0.02) * land.unit, land.color);
        land.canvas.rectangle({load - land.unit * Vec2{Real(0.08), Real(0.1)},
                               load + land.unit * Vec2{Real(0.08), 0}},
                              darker(land.color, 0.3f), land.color);
    }
    for (const Real share : {Real(0.27), Real(0.31), Real(0.6), Real(0.92)}) {
        land.box(share, Real(0.2), Real(0.16), land.color);
    }
}

void paintFair(const Land& land) {
    const Vec2 hub = land.at(Real(0.72), Real(0.42));
    const Real radius = Real(0.42) * land.unit;
    land.canvas.ring(hub, radius, Real(0.035) * land.unit, land.color);
    for (int i = 0; i < 10; ++i) {
        const Vec2 rim =
            hub + radius * towards(kTurn * static_cast<Real>(i) / 10 + Real(0.1) * land.time);
        land.canvas.line(hub, rim, Real(0.02) * land.unit, land.color);
        land.canvas.disc(rim, Real(0.055) * land.unit, land.lights, land.color);
    }
    for (const Real side : {Real(-0.2), Real(0.2)}) {
        land.canvas.line(hub, hub + land.unit * Vec2{side, Real(-0.5)}, Real(0.04) * land.unit,
                         land.color);
    }
    for (const Real share : {Real(0.2), Real(0.29), Real(0.47), Real(0.88)}) { // tents
        land.box(share, Real(0.34), Real(0.14), land.color);
        land.roof(share, Real(0.5), Real(0.14), Real(0.5));
        land.canvas.disc(land.at(share, Real(0.52)), Real(0.035) * land.unit, land.lights,
                         land.lights);
    }
}

void paintShips(const Land& land) {
    for (const Real share : {Real(0.18), Real(0.52), Real(0.84)}) {
        const Vec2 sea = land.at(share, Real(0.03) * std::sin(land.time + 9 * share));
        const auto point = [&](Real x, Real y) { return sea + land.unit * Vec2{x, y}; };
        land.canvas.polygon(
            std::array{point(Real(-0.26), Real(-0.04)), point(Real(0.22), Real(-0.04)),
                       point(Real(0.38), Real(0.14)), point(Real(-0.36), Real(0.14))},
            land.color);
        land.canvas.line(point(0, Real(0.14)), point(0, Real(0.66)), Real(0.03) * land.unit,
                         land.color);
        land.canvas.polygon(std::array{point(Real(0.03), Real(0.2)), point(Real(0.32), Real(0.24)),
                                       point(Real(0.03), Real(0.62))},
                            lighter(land.color, 0.25f));
        land.canvas.polygon(std::array{point(Real(-0.03), Real(0.56)),
                                       point(Real(-0.24), Real(0.2)),
                                       point(Real(-0.03), Real(0.2))},
                            lighter(land.color, 0.1f));
    }
}

void paintGearwork(const Land& land) {
    constexpr std::array<Real, 4> kPlaces = {Real(0.15), Real(0.36), Real(0.415), Real(0.8)};
    constexpr std::array<Real, 4> kRadii = {Real(0.42), Real(0.36), Real(0.2), Real(0.48)};
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
        const Real radius = kRadii[i] * land.unit;
        const Vec2 hub = land.at(kPlaces[i], Real(0.08));
        const auto teeth = static_cast<int>(kRadii[i] * 30);
        const Real angle = land.time * Real(0.08) / kRadii[i] * (i % 2 == 0 ? Real(1) : Real(-1));
        for (int k = 0; k < teeth; ++k) {
            const Vec2 out =
                towards(angle + kTurn * static_cast<Real>(k) / static_cast<Real>(teeth));
            land.canvas.line(hub + Real(0.8) * radius * out, hub + Real(1.12) * radius * out,
                             Real(2.6) * radius / static_cast<Real>(teeth), land.color);
        }
        land.canvas.ring(hub, Real(0.8) * radius, Real(0.3) * radius, land.color);
        for (int k = 0; k < 4; ++k) {
            const Vec2 out = towards(angle + kTurn * static_cast<Real>(k) / 4);
            land.canvas.line(hub, hub + Real(0.7) * radius * out, Real(0.12) * radius, land.color);
        }
    }
}

void paintDomes(const Land& land) {
    for (int i = 0; i < 40; ++i) { // stars
        const Real share = std::fmod(static_cast<Real>(i) * Real(0.618034), Real(1));
        const Real up =
            Real(0.08) + Real(0.5) * std::fmod(static_cast<Real>(i) * Real(0.754878), Real(1));
        const float shine = 0.5f + 0.4f * std::sin(land.time + static_cast<float>(i));
        land.canvas.disc(land.at(share, up), Real(0.018) * land.unit, faded(land.lights, shine),
                         faded(land.lights, 0));
    }
    for (const Real share : {Real(0.22), Real(0.66)}) {
        const Real radius = Real(0.26) * land.unit;
        land.box(share, Real(0.52), Real(0.16), land.color);
        const Vec2 middle = land.at(share, Real(0.16));
        land.canvas.disc(middle, radius, lighter(land.color, 0.1f), land.color);
        land.canvas.line(middle, middle + Real(1.35) * radius * towards(Real(1.1)),
                         Real(0.09) * land.unit, darker(land.color, 0.4f));
    }
    const Vec2 planet = land.at(Real(0.44), Real(0.42));
    land.canvas.disc(planet, Real(0.13) * land.unit, land.lights, land.color);
    land.canvas.line(planet - land.unit * Vec2{Real(0.24), Real(0.06)},
                     planet + land.unit * Vec2{Real(0.24), Real(0.06)}, Real(0.025) * land.unit,
                     land.lights);
}

void paintCastle(const Land& land) {
    for (int i = 0; i < 64; ++i) { // the wall
        const Real share = (static_cast<Real>(i) + Real(0.5)) / 64;
        land.box(share, land.band.extent().x / land.unit / 64 + Real(0.01),
                 i % 2 == 0 ? Real(0.2) : Real(0.12), land.color);
    }
    for (const Real share : {Real(0.12), Real(0.34), Real(0.5), Real(0.66), Real(0.88)}) {
        const Real height = share == Real(0.5) ? Real(0.62) : Real(0.4);
        land.box(share, Real(0.3), height, lighter(land.color, 0.06f));
        land.roof(share, Real(0.42), height, height + Real(0.26));
        const Vec2 pole = land.at(share, height + Real(0.24));
        const Vec2 flag{Real(0.16) * land.unit,
                        Real(0.02) * land.unit * std::sin(3 * land.time + 20 * share)};
        land.canvas.polygon(std::array{pole, pole + Vec2{0, Real(0.12) * land.unit},
                                       pole + flag + Vec2{0, Real(0.06) * land.unit}},
                            land.lights);
        land.canvas.disc(land.at(share, Real(0.6) * height), Real(0.04) * land.unit, land.lights,
                         land.lights);
    }
}

void paintRidge(const Land& land, Color above, Color below) {
    for (int i = 0; i < kSteps; ++i) {
        const Real from = static_cast<Real>(i) / kSteps;
        const Real to = static_cast<Real>(i + 1) / kSteps;
        const Vec2 left = land.at(from, 0);
        const Vec2 right = land.at(to, 0);
        const Real foot = land.band.lower.y - Real(0.6) * land.unit; // behind the next ridge
        land.canvas.facet(std::array{Vec2{left.x, foot}, Vec2{right.x, foot}, right, left},
                          std::array{below, below, above, above});
        land.canvas.line(left, right, Real(0.03), lighter(above, 0.25f));
    }
}

} // namespace

void paintLock(Canvas& canvas, Vec2 middle, Real size, Color color) {
    canvas.ring(middle + Vec2{0, Real(0.3) * size}, Real(0.42) * size, Real(0.2) * size, color);
    canvas.rectangle(
        {middle - size * Vec2{Real(0.6), Real(0.75)}, middle + size * Vec2{Real(0.6), Real(0.2)}},
        color, color);
}

void paintCrown(Canvas& canvas, Vec2 foot, Real size, Color color) {
    for (const Real x : {Real(-0.62), Real(0), Real(0.62)}) {
        const Real top = x == 0 ? Real(0.95) : Real(0.75);
        canvas.polygon(std::array{foot + size * Vec2{x - Real(0.36), 0},
                                  foot + size * Vec2{x + Real(0.36), 0},
                                  foot + size * Vec2{Real(1.25) * x, top}},
                       color);
    }
}

void paintLand(Canvas& canvas, Theme theme, const Aabb& band, bool open, double seconds) {
    const ThemeLook& look = lookOf(theme);
    const auto shade = [&](Color color) { return open ? color : mix(color, kDim, 0.55f); };
    const Land land{canvas,
                    band,
                    band.extent().y,
                    shade(mix(look.dusk, look.frame, 0.45f)),
                    shade(look.glow),
                    static_cast<Real>(std::fmod(seconds, 36000)),
                    theme};
    switch (theme) {
    case Theme::Daybreak:
        paintSunrise(land);
        break;
    case Theme::Quarry:
        paintPits(land);
        break;
    case Theme::Fairground:
        paintFair(land);
        break;
    case Theme::Harbour:
        paintShips(land);
        break;
    case Theme::Clockwork:
        paintGearwork(land);
        break;
    case Theme::Observatory:
        paintDomes(land);
        break;
    case Theme::Fortress:
        paintCastle(land);
        break;
    }
    paintRidge(land, shade(lighter(look.dusk, 0.14f)), shade(mix(look.night, look.dusk, 0.35f)));
}

} // namespace apart
