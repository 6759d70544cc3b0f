// SPDX-License-Identifier: MIT
#include <apart/web/still_part.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>
#include <type_traits>

namespace apart {

using kodo_draw::MeshRun;
using kodo_draw::MeshVertex;

namespace {

constexpr int kSteady = 4;     // frames for which triangles are the same before they are kept
constexpr float kWorth = 1.5f; // pictures; the area of triangles that are worth it
constexpr float kTile = 64;    // pixels

static_assert(std::is_trivially_copyable_v<MeshVertex> && sizeof(MeshVertex) == 20,
              "vertices without padding are compared by their bytes");

bool areSame(const MeshVertex& a, const MeshVertex& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool areSame(const MeshRun& a, const MeshRun& b) {
    return a.first == b.first && a.blend == b.blend && a.fill == b.fill && a.image == b.image;
}

/// The number of leading elements that two lists share.
template <typename Item>
std::size_t shared(std::span<const Item> a, std::span<const Item> b) {
    const std::size_t most = std::min(a.size(), b.size());
    std::size_t count = 0;
    while (count < most && areSame(a[count], b[count])) {
        ++count;
    }
    return count;
}

/// Pixels, of all triangles.
float areaOf(std::span<const MeshVertex> triangles) {
    float twice = 0;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        const kodo_draw::Pixel a = triangles[i + 1].place - triangles[i].place;
        const kodo_draw::Pixel b = triangles[i + 2].place - triangles[i].place;
        twice += std::abs(a.x * b.y - a.y * b.x);
    }
    return twice / 2;
}

/// The tile of a coordinate (pixels), of so many.
std::size_t tileOf(float at, std::size_t count) {
    const float last = static_cast<float>(count) - 1;
    return static_cast<std::size_t>(std::clamp(std::floor(at / kTile), 0.0f, last));
}

} // namespace

StillPart::Plan StillPart::next(std::span<const MeshVertex> vertices, std::span<const MeshRun> runs,
                                kodo_draw::Size pixels) {
    std::size_t same = shared<MeshVertex>(vertices_, vertices);
    const std::size_t sameRuns = shared<MeshRun>(runs_, runs);
    for (const std::span<const MeshRun> all : {std::span<const MeshRun>(runs_), runs}) {
        if (sameRuns < all.size()) {
            same = std::min(same, all[sameRuns].first);
        }
    }
    same -= same % 3; // whole triangles
    vertices_.assign(vertices.begin(), vertices.end());
    runs_.assign(runs.begin(), runs.end());
    if (same < kept_) {
        forget();
    }
    least_ = frames_ == 0 ? same : std::min(least_, same);
    frames_ = (frames_ + 1) % kSteady;
    const float worth = kWorth * static_cast<float>(pixels.x * pixels.y);
    if (frames_ == 0 && least_ > kept_ + kept_ / 8 && areaOf(vertices.first(least_)) > worth) {
        kept_ = least_;
        return {kept_, kept_};
    }
    return {0, kept_};
}

void TouchedTiles::touchAll(kodo_draw::Size pixels) {
    const auto tiles = [](unsigned size) {
        return static_cast<std::size_t>(std::ceil(static_cast<float>(size) / kTile));
    };
    across_ = tiles(pixels.x);
    down_ = tiles(pixels.y);
    touched_.assign(across_ * down_, true);
}

void TouchedTiles::touch(std::span<const MeshVertex> triangles) {
    for (std::size_t i = 0; i + 2 < triangles.size() && !touched_.empty(); i += 3) {
        const auto [a, b, c] =
            std::tuple(triangles[i].place, triangles[i + 1].place, triangles[i + 2].place);
        const std::size_t left = tileOf(std::min({a.x, b.x, c.x}) - 1, across_);
        const std::size_t right = tileOf(std::max({a.x, b.x, c.x}) + 1, across_);
        const std::size_t bottom = tileOf(std::max({a.y, b.y, c.y}) + 1, down_);
        for (std::size_t y = tileOf(std::min({a.y, b.y, c.y}) - 1, down_); y <= bottom; ++y) {
            const auto row = touched_.begin() + static_cast<std::ptrdiff_t>(y * across_);
            std::fill(row + static_cast<std::ptrdiff_t>(left),
                      row + static_cast<std::ptrdiff_t>(right + 1), true);
        }
    }
}

std::vector<MeshVertex> TouchedTiles::quads() const {
    std::vector<MeshVertex> all;
    for (std::size_t y = 0; y < down_; ++y) {
        for (std::size_t x = 0; x < across_;) {
            std::size_t end = x;
            while (end < across_ && touched_[y * across_ + end]) {
                ++end;
            }
            const auto corner = [&](std::size_t tileX, std::size_t tileY) {
                return MeshVertex{
                    {kTile * static_cast<float>(tileX), kTile * static_cast<float>(tileY)}, {}, {}};
            };
            if (end > x) {
                const MeshVertex first = corner(x, y);
                const MeshVertex last = corner(end, y + 1);
                all.insert(all.end(), {first, corner(end, y), last, first, last, corner(x, y + 1)});
            }
            x = end + 1;
        }
    }
    return all;
}

} // namespace apart
