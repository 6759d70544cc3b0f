// SPDX-License-Identifier: MIT
// A renderer of your own: a World as letters in a terminal. Six functions are enough.
#include <kodo/kodo.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

struct TerminalDraw final : kodo::DebugDraw {
    char letter = ' '; // of the present body
    std::array<std::string, 16> rows{};

    kodo::Aabb view() const override { return {{-10, -1}, {10, 9}}; } // m
    kodo::Real pixel() const override { return 1.0f / 3; }            // m, width of a letter
    void line(kodo::Vec2 from, kodo::Vec2 to, const kodo::DrawStyle&) override {
        for (int i = 0; i <= 100; ++i) {
            put(from + 0.01f * static_cast<float>(i) * (to - from));
        }
    }
    void circle(kodo::Vec2 center, kodo::Real radius, const kodo::DrawStyle&) override {
        for (int i = 0; i < 60; ++i) {
            put(center + radius * kodo::Rot::fromAngle(0.1f * static_cast<float>(i)).xAxis());
        }
    }
    void polygon(std::span<const kodo::Vec2> corners, const kodo::DrawStyle& style) override {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            line(corners[i], corners[(i + 1) % corners.size()], style);
        }
    }
    void text(kodo::Vec2, std::string_view, const kodo::DrawStyle&) override {}
    void begin(const kodo::BodyView& body, kodo::DrawStyle&) override {
        letter = body.type() == kodo::BodyType::Static ? '=' : '#';
    }
    void put(kodo::Vec2 place) { // a letter is twice as high as wide
        const auto column = static_cast<std::size_t>(3 * (place.x + 10));
        std::string& row = rows.at(static_cast<std::size_t>(1.5f * (9 - place.y)));
        row.resize((std::max)(row.size(), column + 1), ' ');
        row[column] = letter;
    }
};

int main() {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Box{16, 1}, .position = {0, -0.5f}, .type = kodo::BodyType::Static});
    for (int i = 0; i < 3; ++i) {
        world.add({.shape = kodo::Box{3, 2}, .position = {0, 1 + 2 * static_cast<float>(i)}});
    }
    world.add({.shape = kodo::Circle{1}, .position = {-6, 7}});
    for (int step = 0; step < 20; ++step) {
        world.step(1.0f / 60);
    }
    TerminalDraw picture;
    kodo::draw(world, picture);
    for (const std::string& row : picture.rows) {
        std::puts(row.c_str());
    }
}
