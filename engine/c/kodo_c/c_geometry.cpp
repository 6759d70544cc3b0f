// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo_c/c_values.hpp>

#include <utility>
#include <variant>

namespace kodo_c {
namespace {

/// The result of a function that returns a shape or a problem. Throws BadDefinition.
template <typename Made>
Made madeOf(std::variant<Made, kodo::Problem> result) {
    if (auto* problem = std::get_if<kodo::Problem>(&result)) {
        throw kodo::BadDefinition(std::move(*problem));
    }
    return std::get<Made>(std::move(result));
}

} // namespace
} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_convexHull(const kodo_Vec2* points, size_t pointCount, kodo_Vec2* corners,
                            size_t capacity, size_t* count) {
    return guarded([&] {
        const std::vector<kodo::Vec2> given = listFromC(itemsOf(points, pointCount, "points"));
        writeList(madeOf(kodo::convexHull(given)).corners, corners, capacity, count);
    });
}

kodo_Status kodo_decompose(const kodo_Vec2* outline, size_t pointCount, kodo_Polygons* polygons) {
    return guarded([&] {
        kodo_Polygons& made = required(polygons, "polygons");
        const std::vector<kodo::Vec2> given = listFromC(itemsOf(outline, pointCount, "outline"));
        std::vector<kodo::Vec2> corners;
        std::vector<std::size_t> sizes;
        for (const kodo::Primitive& part : madeOf(kodo::decompose(given)).parts) {
            const auto& polygon = std::get<kodo::Polygon>(part);
            corners.insert(corners.end(), polygon.corners.begin(), polygon.corners.end());
            sizes.push_back(polygon.corners.size());
        }
        writeList(corners, made.corners, made.cornerCapacity, &made.cornerCount);
        writeList(sizes, made.sizes, made.capacity, &made.count);
    });
}
