// SPDX-License-Identifier: MIT
#include "bodies/line_links.hpp"

#include "collide/chain_line.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// One end of a line.
struct LineEnd {
    Vec2 at; // m
    std::size_t part;
    std::size_t end; // vertex, 0 or 1
};

Real lengthOf(const ConvexShape& line) {
    return length(line.vertices[1] - line.vertices[0]);
}

/// The lines of a body while they are linked.
class Links {
public:
    explicit Links(std::span<Part> parts)
        : parts_(parts), next_(parts.size(), kNone), last_(parts.size(), kNone) {}

    /// Links the lines that end at one vertex.
    void link(std::span<const LineEnd> ends) {
        std::array<const LineEnd*, 2> twoSided{};
        std::size_t count = 0;
        for (const LineEnd& own : ends) {
            if (line(own).oneSided) {
                linkOneSided(own, ends);
            } else {
                twoSided[count % 2] = &own;
                ++count;
            }
        }
        if (count == 2) {
            join(*twoSided[0], *twoSided[1]);
            join(*twoSided[1], *twoSided[0]);
        }
    }

    /// Sets the valleys of one-sided lines, from each line that ends one backwards, and from it
    /// forwards. A closed outline may be one valley; then each line knows its neighbours alone.
    void findValleys() {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (!bendsUp(i, next_[i])) {
                Real valley = 0;
                for (std::size_t k = i; bendsUp(last_[k], k); k = last_[k]) {
                    valley += lengthOf(parts_[k].convex);
                    parts_[last_[k]].convex.valleyAfter = valley;
                }
            }
            if (!bendsUp(last_[i], i)) {
                Real valley = 0;
                for (std::size_t k = i; bendsUp(k, next_[k]); k = next_[k]) {
                    valley += lengthOf(parts_[k].convex);
                    parts_[next_[k]].convex.valleyBefore = valley;
                }
            }
        }
    }

private:
    ConvexShape& line(const LineEnd& e) { return parts_[e.part].convex; }

    /// Direction in which one walks along the line of `other` past its end, after or before that
    /// of another line.
    Vec2 wayOf(const LineEnd& other, std::size_t ownEnd) {
        const Vec2 along = alongOf(line(other));
        return other.end == ownEnd ? -along : along;
    }

    void join(const LineEnd& own, const LineEnd& other) {
        ConvexShape& convex = line(own);
        (own.end == 0 ? convex.before : convex.after) = wayOf(other, own.end);
        (own.end == 0 ? convex.valleyBefore : convex.valleyAfter) = lengthOf(line(other));
    }

    /// Of the one-sided lines that begin where this one ends, or end where it begins, the one that
    /// bends most to the front.
    void linkOneSided(const LineEnd& own, std::span<const LineEnd> ends) {
        const LineEnd* best = nullptr;
        Real most = -std::numeric_limits<Real>::infinity();
        const Vec2 along = alongOf(line(own));
        for (const LineEnd& other : ends) {
            if (!line(other).oneSided || other.end == own.end) {
                continue;
            }
            const Vec2 way = wayOf(other, own.end);
            const Real turn = own.end == 0 ? turnBetween(way, along) : turnBetween(along, way);
            if (turn > most) {
                most = turn;
                best = &other;
            }
        }
        if (best != nullptr) {
            join(own, *best);
            (own.end == 0 ? last_ : next_)[own.part] = best->part;
            Real& valley = own.end == 0 ? line(own).valleyBefore : line(own).valleyAfter;
            valley = most > 0 ? valley : 0;
        }
    }

    /// True if two lines are neighbours of each other and bend to the front at their vertex.
    bool bendsUp(std::size_t first, std::size_t second) const {
        return first != kNone && second != kNone && next_[first] == second &&
               last_[second] == first && turnAt(parts_[first].convex, 1) > 0;
    }

    std::span<Part> parts_;
    std::vector<std::size_t> next_; // by part; one-sided lines
    std::vector<std::size_t> last_;
};

} // namespace

void linkLines(std::span<Part> parts) {
    std::vector<LineEnd> ends;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t end = 0; parts[i].convex.isLine() && end < 2; ++end) {
            ends.push_back({parts[i].convex.vertices[end], i, end});
        }
    }
    std::sort(ends.begin(), ends.end(), [](const LineEnd& a, const LineEnd& b) { // total order
        return std::tie(a.at.x, a.at.y, a.part, a.end) < std::tie(b.at.x, b.at.y, b.part, b.end);
    });
    Links links(parts);
    for (std::size_t first = 0; first < ends.size();) {
        std::size_t last = first;
        while (last < ends.size() && ends[last].at == ends[first].at) {
            ++last;
        }
        links.link(std::span(ends).subspan(first, last - first));
        first = last;
    }
    links.findValleys();
}

} // namespace KODO_PRECISION
} // namespace kodo
