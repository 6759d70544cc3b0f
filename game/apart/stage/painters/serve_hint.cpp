// SPDX-License-Identifier: MIT
// Title, idea and keys of a level beside the field's contents.
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/letterforms.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/effects/block_bounds.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/hud.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace apart {

namespace {

constexpr Real kHintMargin = Real(0.12); // m, around what is to stay free
constexpr Real kHintEdge = Real(11.6);   // m, from the middle of the field
constexpr Real kHintLowest = Real(2.2);  // m
constexpr Real kHintHighest = Real(17.6);

/// A line of a hint, relative to its group.
struct HintLine {
    std::string text;
    Real drop;   // m, of its base line below that of the first one
    Real height; // m
    Color color;
};

using HintGroup = std::vector<HintLine>;

Typeface faceOf(const HintLine& line) {
    return line.height > 1 ? Typeface::Display : Typeface::Bold;
}

/// Width (m) of a line, rather too large.
Real hintWidth(const Canvas& canvas, const HintLine& line) {
    constexpr Real kLetter = Real(0.7); // of its height: mean width of a bold letter
    const auto laid = faceOf(line) == Typeface::Display ? layStones(line.text, 1) : std::nullopt;
    if (laid) {
        return Real(0.72) * line.height / kCapital * laid->width;
    }
    const auto letters =
        static_cast<Real>(std::count_if(line.text.begin(), line.text.end(), [](char sign) {
            return (static_cast<unsigned char>(sign) & 0xC0u) != 0x80u;
        }));
    return kLetter * line.height * canvas.textScale() * std::max(letters, Real(1));
}

/// Bounds of each line of a group whose first base line has its middle at the origin.
std::vector<Aabb> hintBoxes(const Canvas& canvas, const HintGroup& group) {
    std::vector<Aabb> boxes;
    for (const HintLine& line : group) {
        const Real half = std::min(hintWidth(canvas, line) / 2, kHintEdge);
        const Real high = line.height * (faceOf(line) == Typeface::Bold ? canvas.textScale() : 1);
        boxes.push_back(
            {{-half, -line.drop - Real(0.25) * high}, {half, -line.drop + Real(0.85) * high}});
    }
    return boxes;
}

/// Where a point of a body (m, world) was at the start of the level. Texts then stay where they are
/// while machines run.
Vec2 atStart(const Game& game, kodo::BodyId body, Vec2 point) {
    const Block* block = game.state().findBlock(body);
    const bool moves = block != nullptr &&
                       (block->support == Support::Standing || block->support == Support::Moving);
    return moves ? block->home * toLocal(game.world()[body].transform(), point) : point;
}

Aabb boundsAtStart(const Game& game, const Block& block) {
    if (!block.ownsBody()) {
        const Aabb now = boundsOf(game, block);
        const auto drift = static_cast<Real>(game.level().bossDrift) / 1000;
        const Real middle = game.world()[block.body].position().x;
        const Vec2 side{drift + std::abs(middle), 0}; // a boss moves about the middle
        return {now.lower - side, now.upper + side};
    }
    std::vector<Vec2> corners;
    const kodo::BodyView body = game.world()[block.body];
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        for (const Vec2 corner : cornersOf(body.part(i).convex, body.massFrame())) {
            corners.push_back(atStart(game, block.body, corner));
        }
    }
    return kodo::aabbOf(std::span<const Vec2>(corners));
}

/// What no word may cover: blocks, ropes, springs, and the dots of a serve from the middle that is
/// not aimed. None of it moves before a serve.
std::vector<Aabb> keptFree(const Game& game) {
    constexpr int kPieces = 8;          // of a rope
    constexpr Real kDotted = Real(4.4); // m, of the serve
    std::vector<Aabb> free;
    const auto add = [&](kodo::Aabb bounds) { free.push_back(bounds.grown(kHintMargin)); };
    for (const Block& block : game.blocks()) {
        add(boundsAtStart(game, block));
    }
    for (const Link& link : game.links()) {
        const kodo::JointDef& def = game.world().joint(link.joint);
        if (const auto* line = std::get_if<kodo::DistanceJoint>(&def)) {
            const auto end = [&](kodo::BodyId body, Vec2 anchor) {
                return atStart(game, body, game.world()[body].transform() * anchor);
            };
            const Vec2 a = end(line->ends.a, line->ends.anchorA);
            const Vec2 b = end(line->ends.b, line->ends.anchorB);
            for (int i = 0; i < kPieces; ++i) {
                const Vec2 from = a + static_cast<Real>(i) / kPieces * (b - a);
                const Vec2 to = from + Real(1) / kPieces * (b - a);
                add({{std::min(from.x, to.x), std::min(from.y, to.y)},
                     {std::max(from.x, to.x), std::max(from.y, to.y)}});
            }
        }
    }
    for (int i = 1; i <= 9; ++i) {
        const Real way = Real(0.5) * static_cast<Real>(i);
        const Real arc = std::sqrt(std::max(kDotted * kDotted - way * way, Real(0)));
        const Real half = std::min(kServeSlope * way, arc) + Real(0.16);
        const Real y = kPaddleY + domeHeight(0) + kBallRadius + way;
        add({{-half, y - Real(0.25)}, {half, y + Real(0.25)}});
    }
    return free;
}

/// The ground, which words cover only where there is no other place.
void addGround(std::vector<Aabb>& free, const Game& game) {
    for (const Obstruction& obstruction : game.obstructions()) {
        const kodo::BodyView body = game.world()[obstruction.body];
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            const std::vector<Vec2> corners = cornersOf(body.part(i).convex, body.massFrame());
            free.push_back(kodo::aabbOf(std::span<const Vec2>(corners)).grown(kHintMargin));
        }
    }
}

Real commonArea(const Aabb& a, const Aabb& b) {
    const Real width = std::min(a.upper.x, b.upper.x) - std::max(a.lower.x, b.lower.x);
    const Real height = std::min(a.upper.y, b.upper.y) - std::max(a.lower.y, b.lower.y);
    return std::max(width, Real(0)) * std::max(height, Real(0));
}

struct HintPlace {
    Vec2 place;       // of the first base line's middle
    Real covered = 0; // m^2
};

/// The place that covers the least; of equal ones the nearest to the usual one.
HintPlace placeOfHint(const std::vector<Aabb>& boxes, const std::vector<Aabb>& free) {
    constexpr Vec2 kUsualPlace{0, Real(7.3)};
    Aabb all = boxes.front();
    for (const Aabb& box : boxes) {
        all = unite(all, box);
    }
    HintPlace best{kUsualPlace};
    Real least = std::numeric_limits<Real>::max();
    const auto consider = [&](Vec2 place) {
        const Real far = std::abs(place.y - kUsualPlace.y) + Real(1.5) * std::abs(place.x);
        Real covered = 0;
        Real cost = Real(0.001) * far;
        for (std::size_t i = 0; i < free.size() && cost < least; ++i) {
            for (const Aabb& box : boxes) {
                const Real area = commonArea({place + box.lower, place + box.upper}, free[i]);
                covered += area;
                cost += area > 0 ? 1 + area : 0;
            }
        }
        if (cost < least) {
            least = cost;
            best = {place, covered};
        }
    };
    const Real side = std::max(kHintEdge - all.upper.x, Real(0));
    for (Real y = kHintLowest - all.lower.y; y + all.upper.y < kHintHighest; y += Real(0.3)) {
        for (Real x = 0; x <= side; x += Real(0.8)) {
            consider({x, y});
            consider({-x, y});
        }
    }
    return best;
}

/// Title and idea: in long lines, in shorter ones, and the title alone.
std::vector<HintGroup> titleGroups(const Canvas& canvas, const Level& level) {
    const HintGroup title = {{shortened(level.title, 48), 0, Real(1.1), palette::kAccent}};
    std::vector<HintGroup> groups;
    struct Column {
        std::size_t lines;
        std::size_t letters;
        std::size_t most;
    };
    for (const auto& [lines, letters, most] : {Column{4, 48, 64}, {6, 32, 40}, {8, 22, 30}}) {
        HintGroup group = title;
        for (const std::string& part :
             wrappedInto(lines, level.idea, fitting(canvas, letters), most)) {
            group.push_back({part, group.back().drop + Real(0.85), Real(0.52), palette::kText});
        }
        groups.push_back(std::move(group));
    }
    groups.push_back(title);
    return groups;
}

/// Paints the first of the groups that has a free place. False if none has.
bool paintTitle(Canvas& canvas, std::span<const HintGroup> groups, const std::vector<Aabb>& free) {
    return std::any_of(groups.begin(), groups.end(), [&](const HintGroup& group) {
        const std::vector<Aabb> boxes = hintBoxes(canvas, group);
        const HintPlace found = placeOfHint(boxes, free);
        if (found.covered > 0) {
            return false;
        }
        for (std::size_t i = 0; i < group.size(); ++i) {
            const HintLine& line = group[i];
            const Vec2 at = found.place - Vec2{0, line.drop};
            const Real room = boxes[i].extent().x;
            const Typeface face = faceOf(line);
            canvas.text(line.text, at + Vec2{Real(0.04), Real(-0.04)},
                        {line.height, palette::kInk, face, Align::Middle, room});
            canvas.text(line.text, at, {line.height, line.color, face, Align::Middle, room});
        }
        return true;
    });
}

/// A line below the paddle, where nothing else is.
void paintFoot(Canvas& canvas, const std::string& text, Real x, Align align, Color color) {
    const Real room = align == Align::Middle ? Real(10.4) : Real(6);
    canvas.text(text, {x, Real(0.06)}, {Real(0.42), color, Typeface::Bold, align, room});
}

} // namespace

void paintServeHint(Canvas& canvas, const Game& game, const Bindings& keys) {
    const bool falls =
        std::any_of(game.blocks().begin(), game.blocks().end(), [&](const Block& block) {
            return block.support == Support::Fallen && !game.world()[block.body].isAsleep();
        });
    if (!game.serving() || game.result() != Result::Playing || falls) {
        return; // not over what falls
    }
    const float pulse = 0.75f + 0.25f * std::sin(0.07f * static_cast<float>(game.ticks() % 12000));
    const bool first = game.score() == 0;
    const bool hollow = std::any_of(game.balls().begin(), game.balls().end(),
                                    [](const Ball& ball) { return ball.hollow; });
    const std::string serve =
        keys.anyPrompt(Act::Serve) + (first && hollow ? " to serve hollow" : " to serve");
    paintFoot(canvas, serve + (first ? ", held: aim" : ""), 0, Align::Middle,
              faded(palette::kText, pulse));
    if (!first) {
        return;
    }
    paintFoot(canvas, keys.anyPrompt(Act::Pull) + ": pull", -kHintEdge, Align::Left,
              palette::kQuiet);
    paintFoot(canvas, keys.anyPrompt(Act::Push) + ": push", kHintEdge, Align::Right,
              palette::kQuiet);
    const std::vector<HintGroup> titles = titleGroups(canvas, game.level());
    const std::span<const HintGroup> whole(titles.data(), titles.size() - 1); // with the idea
    std::vector<Aabb> free = keptFree(game);
    const std::size_t blocks = free.size();
    addGround(free, game);
    if (!paintTitle(canvas, whole, free)) {
        free.resize(blocks);
        paintTitle(canvas, titles, free); // else the panel has it
    }
}

} // namespace apart
