// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/headless/refusal.hpp>
#include <apart/headless/replay_commands.hpp>
#include <apart/headless/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <unistd.h>

namespace apart {

namespace {

constexpr std::string_view nameOf(Role role) {
    switch (role) {
    case Role::Wall:
        return "wall";
    case Role::Paddle:
        return "paddle";
    case Role::Block:
        return "block";
    case Role::Ball:
        return "ball";
    case Role::Shard:
        return "shard";
    case Role::Part:
        return "part";
    case Role::Obstruction:
        return "obstruction";
    }
    return "body"; // of no role
}

/// The numbers that an event has, in units of metre, kilogram and second.
template <typename E>
std::string numbersOf(const E& event) {
    std::string text;
    const auto add = [&](std::string_view name, const auto& value) {
        text += fmt::format(" {} {}", name, value);
    };
    if constexpr (requires { event.key; }) {
        add("block", event.key);
    }
    if constexpr (requires { event.what; }) {
        text += fmt::format(" {}", nameOf(event.what));
    }
    if constexpr (requires { event.power; }) {
        add("power", kPowerNames[static_cast<std::size_t>(event.power)]);
    }
    if constexpr (requires { event.point; }) {
        text += fmt::format(" at ({:.3f}, {:.3f})", event.point.x, event.point.y);
    }
    if constexpr (requires { event.normal; }) {
        text += fmt::format(" normal ({:.3f}, {:.3f})", event.normal.x, event.normal.y);
    }
    if constexpr (requires { event.impulse; }) {
        text += fmt::format(" impulse {:.4g}", event.impulse);
    }
    if constexpr (requires { event.force + kodo::Real(0); }) {
        text += fmt::format(" force {:.4g}", event.force);
    }
    if constexpr (requires { event.shards; }) {
        add("pieces", event.shards);
    }
    if constexpr (requires { event.pieces; }) {
        add("pieces", event.pieces);
    }
    if constexpr (requires { event.strengthLeft; }) {
        text += fmt::format(" left {:.3f}", event.strengthLeft);
    }
    if constexpr (requires { event.blocks; }) {
        add("blocks", event.blocks);
    }
    if constexpr (requires { event.points; }) {
        add("points", event.points);
    }
    if constexpr (requires { event.balls; }) {
        add("balls", event.balls);
    }
    if constexpr (requires { event.untilTick; }) {
        add("until", event.untilTick);
    }
    return text;
}

std::vector<Field> fieldsOf(const std::vector<std::string>& names) {
    std::vector<Field> fields;
    for (const std::string& name : names) {
        const auto found = std::find(kFieldNames.begin(), kFieldNames.end(), name);
        if (found == kFieldNames.end()) {
            throw Refusal{"there is no field " + name};
        }
        fields.push_back(static_cast<Field>(found - kFieldNames.begin()));
    }
    return fields;
}

/// Returns the number of lines.
std::size_t printEvents(const Game& game) {
    for (const Event& event : game.events()) {
        const std::string numbers =
            std::visit([](const auto& one) { return numbersOf(one); }, event);
        fmt::print("{} {}{}\n", game.ticks(), kFieldNames[kValueFields + event.index()], numbers);
    }
    return game.events().size();
}

/// At most four a replay, so that a change of them stays small.
std::string hashLine(const std::string& file, const Replay& replay) {
    Playback playback = openReplay(file, replay);
    const std::uint32_t end = playback.replay().end;
    Progress progress;
    std::string line = "hash";
    for (std::uint32_t part = 1; part <= 4; ++part) {
        const std::uint32_t tick = part * end / 4;
        while (playback.game().ticks() < tick) {
            playback.tick();
            progress.show(playback.game(), end);
        }
        if (tick > (part - 1) * end / 4) {
            line += fmt::format(" {} {}", tick, toHex(playback.game().stateHash()));
        }
    }
    return line;
}

void trace(Playback playback, const TraceCommand& command, const std::vector<Field>& fields) {
    std::map<Field, std::int64_t> before;
    Progress progress(STDOUT_FILENO);
    const std::uint32_t last = playback.replay().end;
    if (command.from > last) {
        fmt::print("# The replay ends at tick {}, before tick {}.\n", last, command.from);
        return;
    }
    const std::uint32_t end = std::min(command.to.value_or(last), last);
    std::size_t lines = 0;
    while (playback.game().ticks() < end) {
        playback.tick();
        progress.show(playback.game(), end);
        if (playback.game().ticks() < command.from) {
            continue;
        }
        lines += printEvents(playback.game());
        for (const Field field : fields) {
            const std::int64_t now = playback.valueOf(field);
            const auto known = before.find(field);
            if (known == before.end() || known->second != now) {
                fmt::print("{} {} = {}\n", playback.game().ticks(),
                           kFieldNames[static_cast<std::size_t>(field)], now);
                before[field] = now;
                ++lines;
            }
        }
    }
    if (lines == 0) {
        fmt::print("# Nothing happens from tick {} to {}.\n", command.from, end);
    }
    if (command.to > last) {
        fmt::print("# The replay ends at tick {}, before tick {}.\n", last, *command.to);
    }
}

} // namespace

ReplayRun readRun(const std::string& file) {
    return valueOrRefuse(readRunFile(file));
}

Playback openReplay(const std::string& file, const Replay& replay, const std::string& own) {
    auto level = std::make_shared<const Level>(
        valueOrRefuse(own.empty() ? loadLevelOf(file, replay.level) : readLevelFile(own)));
    if (const std::optional<std::string> reason = refusal(replay, *level)) {
        throw Refusal{file + ": " + *reason};
    }
    return Playback(replay, std::move(level));
}

std::optional<std::uint32_t> playToEnd(Playback& playback) {
    Progress progress;
    std::optional<std::uint32_t> ended;
    while (!playback.done()) {
        playback.tick();
        if (!ended && playback.game().result() != Result::Playing) {
            ended = playback.game().ticks();
        }
        progress.show(playback.game(), playback.replay().end);
    }
    return ended;
}

int runTrace(const TraceCommand& command) {
    if (command.to && command.from > *command.to) {
        throw Refusal{fmt::format("--from {} is after --to {}. Try apart-headless trace --help.",
                                  command.from, *command.to)};
    }
    const std::vector<Field> fields = fieldsOf(command.fields);
    const ReplayRun run = readRun(command.file);
    fmt::print("# tick event ... in m, kg, s, N, N s; tick field = value in the units of "
               "game/replays.md; 120 ticks are a second\n");
    for (const Replay& replay : run) {
        if (run.size() > 1) {
            fmt::print("level {}\n", replay.level);
        }
        trace(openReplay(command.file, replay, command.level), command, fields);
    }
    return 0;
}

int runHash(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        const std::string text = valueOrRefuse(readTextFile(file, kLargestReplay));
        const Replay replay = valueOrRefuse(parseReplay(text, file));
        if (!replay.handwritten) {
            throw Refusal{file + ": was recorded, and has the hashes of its recording"};
        }
        std::istringstream lines(text);
        std::string result;
        const std::string hashes = hashLine(file, replay);
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("end ")) {
                result += hashes + "\n";
            }
            result += line.starts_with("hash ") ? "" : line + "\n";
        }
        if (const auto problem = writeTextFile(file, result)) {
            throw Refusal{problem->text()};
        }
        fmt::print("{}: {}\n", file, hashes);
    }
    return 0;
}

} // namespace apart
