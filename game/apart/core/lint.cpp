// SPDX-License-Identifier: MIT
#include <apart/core/bot.hpp>
#include <apart/core/field.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/tuning.hpp>
#include <apart/core/watch.hpp>
#include <kodo/world/queries.hpp>

#include <algorithm>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

// The ball is moved in steps of this (m), so that its middle comes to that of every row and column.
constexpr Real kStride = Real(0.1);
// Where it fits so much larger (m), the smaller true ball fits between two such places as well: a
// corner can reach kStride^2 / (8 kBallRadius) = 0.0042 m into the way between them.
constexpr Real kSpare = Real(0.01);
constexpr int kAcross = 241;   // places, from wall to wall
constexpr int kUp = 181;       // places, from the paddle's floor to the top
constexpr int kServeRow = 25;  // place above the paddle where the flood begins
constexpr int kServeColumn = kAcross / 2;

// Visits of bodies and contacts per tick. A level twice as busy would still be played in real time
// by a machine ten times slower than the one that the levels were made on.
constexpr std::uint64_t kMostWork = 4000;

Vec2 placeOf(int column, int row) {
    return {static_cast<Real>(column) * kStride - kFieldWidth / 2,
            static_cast<Real>(row) * kStride};
}

/// Which of the places a ball can come to.
class Flood {
public:
    explicit Flood(const kodo::World& world) : world_(world), seen_(kAcross * kUp, 0) {
        visit(kServeColumn, kServeRow);
        while (!open_.empty()) {
            const int place = open_.back();
            open_.pop_back();
            const int column = place % kAcross;
            const int row = place / kAcross;
            visit(column - 1, row);
            visit(column + 1, row);
            visit(column, row - 1);
            visit(column, row + 1);
        }
    }

    /// Can the middle of a ball come to some place inside the body?
    bool reaches(const kodo::BodyView& body) const {
        const kodo::Aabb bounds = body.bounds();
        const auto index = [](Real way) { return static_cast<int>(way / kStride); };
        const int last = std::min(index(bounds.upper.x + kFieldWidth / 2) + 1, kAcross - 1);
        const int top = std::min(index(bounds.upper.y) + 1, kUp - 1);
        for (int row = std::max(index(bounds.lower.y), 0); row <= top; ++row) {
            for (int column = std::max(index(bounds.lower.x + kFieldWidth / 2), 0); column <= last;
                 ++column) {
                if (seen_[indexOf(column, row)] == kFree && body.contains(placeOf(column, row))) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    static constexpr char kFree = 1;
    static constexpr char kTaken = 2;

    static std::size_t indexOf(int column, int row) {
        return static_cast<std::size_t>(row * kAcross + column);
    }

    void visit(int column, int row) {
        if (column < 0 || column >= kAcross || row < 0 || row >= kUp) {
            return;
        }
        char& mark = seen_[indexOf(column, row)];
        if (mark != 0) {
            return;
        }
        const bool taken = closestPoint(world_, placeOf(column, row), kBallRadius + kSpare)
                               .has_value();
        mark = taken ? kTaken : kFree;
        if (!taken) {
            open_.push_back(row * kAcross + column);
        }
    }

    const kodo::World& world_;
    std::vector<char> seen_;
    std::vector<int> open_;
};

/// What stays for ever: walls and steel.
kodo::World lastingWorld(const Game& game) {
    kodo::World world = game.world();
    world.remove(game.paddle());
    for (const Ball& ball : game.balls()) {
        world.remove(ball.body);
    }
    for (const Block& block : game.blocks()) {
        if (block.kind.breakable()) {
            world.remove(block.body);
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

void judgeReach(LintReport& report) {
    for (const Cell& cell : report.outOfReach) {
        report.problems.push_back("no ball can come to the block in " + cellText(cell));
    }
}

void judgeRun(const BotRun& run, LintReport& report) {
    const std::string who = "the bot's game with seed " + std::to_string(run.seed);
    if (run.result == Result::Lost) {
        report.problems.push_back(who + " is lost after " + secondsText(run.ticks));
    } else if (run.result == Result::Playing) {
        report.problems.push_back(who + " is not won after " + secondsText(run.ticks));
    }
    if (run.faults > 0) {
        report.problems.push_back("in " + who + " a ball halted, escaped or left its straight path");
    }
}

} // namespace

BotRun runBot(const Level& level, std::uint32_t seed, std::uint32_t mostTicks) {
    Game game(level, seed);
    Watch watch;
    BotRun run{.seed = seed};
    while (game.result() == Result::Playing && game.ticks() < mostTicks) {
        game.tick(bot(game));
        watch.look(game);
        run.mostBodies = std::max(run.mostBodies, game.world().bodyCount());
        run.work += game.world().bodyVisits() + game.world().contactVisits();
    }
    run.ticks = game.ticks();
    run.result = game.result();
    run.livesLost = level.lives - game.lives();
    run.longestWait = watch.longestWait();
    run.faults = watch.halts() + watch.escapes() + watch.bends();
    return run;
}

std::vector<Cell> outOfReach(const Level& level) {
    const Game game(level, 1);
    const kodo::World lasting = lastingWorld(game);
    const Flood flood(lasting);
    std::vector<Cell> cells;
    for (const Block& block : game.blocks()) {
        if (block.kind.breakable() && !flood.reaches(game.world()[block.body])) {
            cells.push_back({static_cast<std::uint8_t>(block.key / kColumns),
                             static_cast<std::uint8_t>(block.key % kColumns), 0});
        }
    }
    return cells;
}

LintReport lint(const Level& level, const LintOptions& options) {
    LintReport report{.level = level.name};
    report.blocks = Game(level, 1).blocksAtStart();
    report.outOfReach = outOfReach(level);
    judgeReach(report);
    std::uint64_t ticks = 0;
    std::uint64_t work = 0;
    for (std::uint32_t seed = 1; seed <= options.seeds; ++seed) {
        report.runs.push_back(runBot(level, seed, options.mostTicks));
        judgeRun(report.runs.back(), report);
        ticks += report.runs.back().ticks;
        work += report.runs.back().work;
    }
    report.workPerTick = ticks > 0 ? work / ticks : 0;
    if (report.workPerTick > kMostWork) {
        report.problems.push_back("a tick visits " + std::to_string(report.workPerTick) +
                                  " bodies and contacts on the mean; more than " +
                                  std::to_string(kMostWork) + " are too many");
    }
    return report;
}

} // namespace apart
