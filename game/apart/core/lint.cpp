// SPDX-License-Identifier: MIT
#include <apart/core/field.hpp>
#include <apart/core/font_coverage.hpp>
#include <apart/core/game_observer.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/player.hpp>
#include <apart/core/standing_trial.hpp>
#include <apart/core/tuning.hpp>
#include <apart/core/way_watch.hpp>
#include <kodo/query.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

// Spacing (m) of the grid points of the flood fill. The centres of all rows and columns are points.
constexpr Real kStride = Real(0.1);
// Extra radius (m) of the tested ball. A corner reaches at most kStride^2 / (8 kBallRadius) =
// 0.0042 m into the path between two free points, so the true ball passes there.
constexpr Real kSpare = Real(0.01);
constexpr int kAcross = 241;  // points, from wall to wall
constexpr int kUp = 181;      // points, from the bottom to the top
constexpr int kServeRow = 25; // row above the paddle where the fill begins
constexpr int kServeColumn = kAcross / 2;

// Most bodies and contacts visited per tick. Twice as many still run in real time on a machine ten
// times slower than the one that the levels were made on.
constexpr std::uint64_t kMostWork = 4000;

Vec2 placeOf(int column, int row) {
    return {static_cast<Real>(column) * kStride - kFieldWidth / 2,
            static_cast<Real>(row) * kStride};
}

/// Flood fill of the points that a ball can reach.
class Flood {
public:
    Flood(const kodo::World& world, const Level& level)
        : world_(world), level_(level), seen_(kAcross * kUp, kUnknown) {
        visit(kServeColumn, kServeRow);
        while (!open_.empty()) {
            const int place = open_.back();
            open_.pop_back();
            const int column = place % kAcross;
            const int row = place / kAcross;
            go(column, row, -1, 0);
            go(column, row, 1, 0);
            go(column, row, 0, -1);
            go(column, row, 0, 1);
        }
    }

    /// True if the centre of a ball can reach a point inside the cell.
    bool reaches(const Cell& cell) const {
        return reaches(centerOf(cell), {kCellWidth / 2, kCellHeight / 2});
    }

    /// The same of a rectangle within the field, by its middle and half of its extent.
    bool reaches(Vec2 center, Vec2 half) const {
        const auto index = [](Real way) { return static_cast<int>(way / kStride); };
        const int last = std::min(index(center.x + half.x + kFieldWidth / 2), kAcross - 1);
        const int top = std::min(index(center.y + half.y), kUp - 1);
        for (int row = index(center.y - half.y) + 1; row <= top; ++row) {
            for (int column = index(center.x - half.x + kFieldWidth / 2); column <= last;
                 ++column) {
                if (seen_[indexOf(column, row)] == kFree) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    static constexpr char kUnknown = 0;
    static constexpr char kFree = 1;
    static constexpr char kTaken = 2;

    static std::size_t indexOf(int column, int row) {
        return static_cast<std::size_t>(row * kAcross + column);
    }

    void go(int column, int row, int right, int up) {
        const Vec2 from = placeOf(column, row);
        const Vec2 to = placeOf(column + right, row + up);
        const bool shut = std::any_of(
            level_.obstructions.begin(), level_.obstructions.end(), [&](const ObstructionDef& def) {
                return def.kind == ObstructionKind::Gate && isShut(def, from, to);
            });
        if (!shut) {
            visit(column + right, row + up);
        }
    }

    /// True if the step crosses the gate from its front.
    static bool isShut(const ObstructionDef& gate, Vec2 from, Vec2 to) {
        const bool level = gate.facing == Facing::Up || gate.facing == Facing::Down;
        const Real side = gate.facing == Facing::Up || gate.facing == Facing::Right ? 1 : -1;
        const Vec2 middle{static_cast<Real>(gate.x) / 1000, static_cast<Real>(gate.y) / 1000};
        const auto across = [&](Vec2 p) {
            return side * (level ? p.y - middle.y : p.x - middle.x);
        };
        const Real along = level ? from.x - middle.x : from.y - middle.y;
        return across(from) >= 0 && across(to) < 0 &&
               std::abs(along) <= static_cast<Real>(gate.size) / 2000 + kBallRadius;
    }

    void visit(int column, int row) {
        if (column < 0 || column >= kAcross || row < 0 || row >= kUp) {
            return;
        }
        char& mark = seen_[indexOf(column, row)];
        if (mark == kUnknown) {
            mark =
                closestPoint(world_, placeOf(column, row), kBallRadius + kSpare) ? kTaken : kFree;
            if (mark == kFree) {
                open_.push_back(row * kAcross + column);
            }
        }
    }

    const kodo::World& world_;
    const Level& level_;
    std::vector<char> seen_;
    std::vector<int> open_;
};

/// The world without bodies that move or break: walls, steel, and obstructions that do not turn.
/// Flood treats gates. Steel of a boss counts: it must leave a path to the blocks that it covers.
kodo::World lastingWorld(const Level& level) {
    kodo::World world;
    for (const kodo::BodyDef& def : wallDefs()) {
        world.add(def);
    }
    for (const ObstructionDef& def : level.obstructions) {
        if (def.kind != ObstructionKind::Gate && def.kind != ObstructionKind::Motor) {
            world.add(obstructionDef(def));
        }
    }
    for (const Cell& cell : level.cells) {
        const BlockKind& kind = level.kinds[cell.kind];
        if (!kind.breakable() && kind.support != Support::Hanging) {
            world.add(blockDef(kind, centerOf(cell)));
        }
    }
    return world;
}

std::string secondsText(std::uint32_t ticks) {
    return std::to_string(ticks / kTicksPerSecond) + " s";
}

std::string cellText(const Cell& cell) {
    return "row " + std::to_string(cell.row + 1) + ", column " + std::to_string(cell.column + 1);
}

/// True if a ball can come to a block of the building, or if there is none.
bool reachesBuilding(const Level& level) {
    const Game game(level, 1);
    const kodo::World lasting = lastingWorld(level);
    const Flood flood(lasting, level);
    bool any = false;
    for (const Block& block : game.blocks()) {
        if (block.counts() && block.key >= keyOfFree(0)) {
            const kodo::Aabb bounds = game.world()[block.body].bounds();
            if (flood.reaches((bounds.lower + bounds.upper) / 2, bounds.extent() / 2)) {
                return true;
            }
            any = true;
        }
    }
    return !any;
}

void judgeReach(const Level& level, LintReport& report) {
    for (const Cell& cell : report.outOfReach) {
        report.problems.push_back("no ball can come to the block in " + cellText(cell));
    }
    if (!reachesBuilding(level)) {
        report.problems.push_back("no ball can come to a block of the building");
    }
}

/// Names the ways that strike letters of no block.
void judgeWays(const Level& level, LintReport& report) {
    const auto stands = [&](char letter) {
        return std::any_of(
            level.freeBlocks.begin(), level.freeBlocks.end(),
            [&](const FreeBlock& block) { return level.kinds[block.kind].letter == letter; });
    };
    for (const WayDef& way : level.ways) {
        if (!way.strikes.empty() && std::none_of(way.strikes.begin(), way.strikes.end(), stands)) {
            report.problems.push_back("the way \"" + way.name +
                                      "\" can never be met: there is no " + "block of " +
                                      way.strikes);
        }
    }
}

void judgeRun(const BotRun& run, LintReport& report) {
    const std::string who = "the bot's game with seed " + std::to_string(run.seed);
    if (run.result == Result::Lost) {
        report.problems.push_back(who + " is lost after " + secondsText(run.ticks));
    } else if (run.result == Result::Playing) {
        report.problems.push_back(who + " is not won after " + secondsText(run.ticks));
    }
    if (run.longestWait > report.waitBound + 1) {
        report.problems.push_back("in " + who + " no block was damaged for " +
                                  secondsText(run.longestWait));
    }
    if (run.faults > 0) {
        report.problems.push_back("in " + who +
                                  " a ball halted, escaped or left its straight path");
    }
}

/// True if something happened for the player in the last tick.
bool isEventful(const Game& game) {
    return std::any_of(game.events().begin(), game.events().end(), [](const Event& event) {
        return std::holds_alternative<Cracked>(event) || std::holds_alternative<Broke>(event) ||
               std::holds_alternative<LetGo>(event) || std::holds_alternative<Landed>(event) ||
               std::holds_alternative<Caught>(event) || std::holds_alternative<ShardCaught>(event);
    });
}

/// True if a ball hit a block in the last tick.
bool isHit(const Game& game) {
    return std::any_of(game.events().begin(), game.events().end(), [](const Event& event) {
        const auto* struck = std::get_if<Struck>(&event);
        return struck != nullptr && struck->what == Role::Block;
    });
}

/// Measures the gaps between ticks in which something happens.
class GapMeter {
public:
    void tick(bool happens) {
        ++gap_;
        if (happens) {
            finish();
        }
    }
    Gaps finish() {
        gaps_.longest = std::max(gaps_.longest, gap_);
        gaps_.ticks += gap_ > kQuietGap ? gap_ : 0;
        gap_ = 0;
        return gaps_;
    }

private:
    Gaps gaps_;
    std::uint32_t gap_ = 0; // ticks
};

/// Names the standing block that moves farthest without a serve.
void judgeStanding(const Level& level, LintReport& report) {
    StandingTrial trial(std::make_shared<const Level>(level));
    trial.advance(StandingTrial::kTicks);
    if (const auto& moved = trial.farthest()) {
        const Vec2 home = moved->block.home.position;
        report.problems.push_back(
            "untouched, the block of " +
            std::string(kStuffNames[static_cast<std::size_t>(moved->block.kind.stuff)]) +
            " at x = " + std::to_string(std::lround(1000 * home.x)) +
            ", y = " + std::to_string(std::lround(1000 * home.y)) + " moves by " +
            std::to_string(std::lround(1000 * moved->way)) + " mm in 60 s");
    }
}

} // namespace

BotRun runBot(const Level& level, std::uint32_t seed, std::uint32_t mostTicks, BotKind kind) {
    Game game(level, seed);
    Player player(kind);
    GameObserver observer;
    WayWatch way;
    BotRun run{.seed = seed};
    GapMeter events;
    GapMeter clears;
    std::optional<std::uint32_t> served; // tick of the first serve
    bool hit = false;
    while (game.result() == Result::Playing && game.ticks() < mostTicks) {
        const std::int32_t left = game.blocksLeft();
        const std::int32_t largest = game.collapse().largest;
        game.tick(player.next(game));
        observer.observe(game);
        way.update(game);
        const bool over = game.result() != Result::Playing;
        events.tick(isEventful(game) || over);
        clears.tick(game.blocksLeft() < left || over);
        run.largestFallTick =
            game.collapse().largest > largest ? game.ticks() : run.largestFallTick;
        if (!served && !game.serving()) {
            served = game.ticks();
        }
        if (served && !hit) {
            hit = isHit(game);
            run.firstHit = game.ticks() - *served;
        }
        run.mostBodies = std::max(run.mostBodies, game.world().bodyCount());
        run.work += stepStats(game.world()).bodies + stepStats(game.world()).contacts;
    }
    run.quiet = events.finish();
    run.uncleared = clears.finish();
    run.ticks = game.ticks();
    run.result = game.result();
    run.score = game.score();
    run.ways = run.result == Result::Won ? way.ways(level) : 0;
    run.paddleHits = game.counts().hits;
    run.largestFall = game.collapse().largest;
    run.livesLost = level.lives - game.lives();
    run.cleared = 1 - static_cast<double>(game.blocksLeft()) / std::max(game.blocksAtStart(), 1);
    run.longestWait = observer.observations().longestWait;
    run.faults = observer.observations().faults();
    return run;
}

std::vector<Cell> outOfReach(const Level& level) {
    const kodo::World lasting = lastingWorld(level);
    const Flood flood(lasting, level);
    std::vector<Cell> cells;
    for (const Cell& cell : level.cells) {
        if (level.kinds[cell.kind].breakable() && !flood.reaches(cell)) {
            cells.push_back(cell);
        }
    }
    return cells;
}

LintReport lint(const Level& level, const LintOptions& options) {
    LintReport report{.level = level.name};
    report.blocks = Game(level, 1).blocksAtStart();
    report.outOfReach = outOfReach(level);
    report.warnings = lackingCharacters(level);
    report.waitBound = kFailTicks;
    report.clearBound = kFailTicks + kLooseTicks +
                        kFailEvery * static_cast<std::uint32_t>(std::max(report.blocks - 1, 0));
    judgeReach(level, report);
    judgeWays(level, report);
    judgeStanding(level, report);
    std::uint64_t ticks = 0;
    std::uint64_t work = 0;
    for (std::uint32_t game = 0; game < options.seeds; ++game) {
        report.runs.push_back(runBot(level, options.firstSeed + game, options.mostTicks));
        judgeRun(report.runs.back(), report);
        ticks += report.runs.back().ticks;
        work += report.runs.back().work;
    }
    report.workPerTick = ticks > 0 ? work / ticks : 0;
    if (report.workPerTick > kMostWork) {
        report.problems.push_back("a tick visits " + std::to_string(report.workPerTick) +
                                  " bodies and contacts on average; at most " +
                                  std::to_string(kMostWork) + " are allowed");
    }
    return report;
}

} // namespace apart
