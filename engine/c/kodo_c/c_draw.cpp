// SPDX-License-Identifier: MIT
#include <kodo/debug_draw.hpp>
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

#include <string>

namespace kodo_c {
namespace {

kodo_DrawColor colorToC(kodo::DrawColor color) {
    const auto& [r, g, b, a] = color;
    return {r, g, b, a};
}
kodo_DrawStyle styleToC(const kodo::DrawStyle& style) {
    const auto& [line, fill, width] = style;
    return {colorToC(line), colorToC(fill), width};
}
kodo::DrawColor colorFromC(kodo_DrawColor color) {
    return {color.r, color.g, color.b, color.a};
}

kodo_DrawOptions optionsToC(const kodo::DrawOptions& options, kodo_Head head) {
    const auto& [shapes, joints, contacts, impulses, bounds, velocities, centers, labels,
                 metresPerImpulse, secondsOfVelocity, islands] = options;
    return {head,       shapes,  joints, contacts,         impulses,          bounds,
            velocities, centers, labels, metresPerImpulse, secondsOfVelocity, islands};
}
kodo::DrawOptions optionsOf(const kodo_DrawOptions* options) {
    if (options == nullptr) {
        return {};
    }
    const kodo_DrawOptions& given = checked(options, "options", "kodo_DrawOptions");
    return {given.shapes,           given.joints,
            given.contacts,         given.impulses,
            given.bounds,           given.velocities,
            given.centers,          given.labels,
            given.metresPerImpulse, given.secondsOfVelocity,
            given.islands};
}

/// A picture that calls functions of C.
class Picture final : public kodo::DebugDraw {
public:
    explicit Picture(const kodo_DebugDraw& target) : target_(target) {}

    kodo::Aabb view() const override { return fromC(target_.view); }
    kodo::Real pixel() const override { return target_.pixel; }
    void line(kodo::Vec2 from, kodo::Vec2 to, const kodo::DrawStyle& style) override {
        call(target_.line, style, from, to);
    }
    void circle(kodo::Vec2 center, kodo::Real radius, const kodo::DrawStyle& style) override {
        call(target_.circle, style, center, radius);
    }
    void polygon(std::span<const kodo::Vec2> corners, const kodo::DrawStyle& style) override {
        const std::vector<kodo_Vec2> given = cornersOf(corners);
        call(target_.polygon, style, given.data(), given.size());
    }
    void text(kodo::Vec2 middle, std::string_view utf8, const kodo::DrawStyle& style) override {
        const std::string given(utf8);
        call(target_.text, style, middle, given.c_str());
    }

    void rounded(std::span<const kodo::Vec2> corners, kodo::Real radius,
                 const kodo::DrawStyle& style) override {
        const std::vector<kodo_Vec2> given = cornersOf(corners);
        if (!call(target_.rounded, style, given.data(), given.size(), radius)) {
            DebugDraw::rounded(corners, radius, style);
        }
    }
    void halfPlane(kodo::Vec2 surface, kodo::Vec2 normal, const kodo::DrawStyle& style) override {
        if (!call(target_.halfPlane, style, surface, normal)) {
            DebugDraw::halfPlane(surface, normal, style);
        }
    }
    void point(kodo::Vec2 place, const kodo::DrawStyle& style) override {
        if (!call(target_.point, style, place)) {
            DebugDraw::point(place, style);
        }
    }
    void arrow(kodo::Vec2 from, kodo::Vec2 to, const kodo::DrawStyle& style) override {
        if (!call(target_.arrow, style, from, to)) {
            DebugDraw::arrow(from, to, style);
        }
    }
    void spring(kodo::Vec2 from, kodo::Vec2 to, const kodo::DrawStyle& style) override {
        if (!call(target_.spring, style, from, to)) {
            DebugDraw::spring(from, to, style);
        }
    }

    void begin(const kodo::BodyView& body, kodo::DrawStyle& style) override {
        if (target_.begin != nullptr) {
            kodo_DrawStyle given = styleToC(style);
            target_.begin(target_.context, toC(body.id()), &given);
            style = {colorFromC(given.line), colorFromC(given.fill), given.width};
        }
    }
    std::string label(const kodo::BodyView& body) override {
        const char* text =
            target_.label == nullptr ? nullptr : target_.label(target_.context, toC(body.id()));
        return text == nullptr ? DebugDraw::label(body) : text;
    }

private:
    static kodo_Vec2 given(kodo::Vec2 v) { return toC(v); }
    template <typename Value>
    static Value given(Value value) {
        return value;
    }
    static std::vector<kodo_Vec2> cornersOf(std::span<const kodo::Vec2> corners) {
        std::vector<kodo_Vec2> list;
        for (const kodo::Vec2 corner : corners) {
            list.push_back(toC(corner));
        }
        return list;
    }

    /// Calls a function, unless it is null.
    template <typename Function, typename... Values>
    bool call(Function function, const kodo::DrawStyle& style, Values... values) const {
        if (function == nullptr) {
            return false;
        }
        const kodo_DrawStyle made = styleToC(style);
        function(target_.context, given(values)..., &made);
        return true;
    }

    const kodo_DebugDraw& target_;
};

} // namespace
} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initDrawOptions(kodo_DrawOptions* options, kodo_Head head) {
    return guarded([&] {
        initialise(options, head, "kodo_DrawOptions");
        *options = optionsToC(kodo::DrawOptions{}, head);
    });
}

kodo_Status kodo_initDebugDraw(kodo_DebugDraw* target, kodo_Head head) {
    return guarded([&] {
        initialise(target, head, "kodo_DebugDraw");
        target->pixel = kodo_Real(0.01);
    });
}

kodo_Status kodo_draw(const kodo_World* world, const kodo_DebugDraw* target,
                      const kodo_DrawOptions* options) {
    return guarded([&] {
        Picture picture(checked(target, "target", "kodo_DebugDraw"));
        const kodo::World& drawn = worldOf(world);
        const InUse use(*world);
        kodo::draw(drawn, picture, optionsOf(options));
    });
}

kodo_Status kodo_viewOf(const kodo_World* world, kodo_Aabb* view) {
    return guarded([&] { required(view, "view") = toC(kodo::viewOf(worldOf(world))); });
}

kodo_Status kodo_svg(const kodo_World* world, const kodo_DrawOptions* options,
                     const kodo_Aabb* view, char* text, size_t capacity, size_t* count) {
    return guarded([&] {
        const std::string made =
            kodo::svg(worldOf(world), optionsOf(options),
                      view == nullptr ? std::nullopt : std::optional(fromC(*view)));
        required(count, "count") = made.size();
        const std::size_t written = (std::min)(capacity, made.size());
        if (written > 0) {
            requirePointer(text, "text");
            std::memcpy(text, made.data(), written);
        }
    });
}
