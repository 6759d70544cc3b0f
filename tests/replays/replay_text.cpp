// SPDX-License-Identifier: MIT
#include "replay_text.hpp"

#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace apart {

namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + '\n';
    }
    return text;
}

bool isInput(const std::string& line) {
    return !line.empty() && std::isdigit(static_cast<unsigned char>(line.front())) != 0;
}

/// Target of an input line; nullopt: none.
std::optional<int> targetIn(const std::string& line) {
    std::istringstream words(line);
    std::string tick;
    std::string paddle;
    std::string target;
    words >> tick >> paddle >> target;
    return target.empty() || target == "-" ? std::nullopt : std::optional(std::stoi(target));
}

std::string withTarget(const std::string& line, int target) {
    static const std::regex kPattern(R"(^(\d+\s+\S+\s+)(\S+)(\s*))");
    std::smatch found;
    if (!std::regex_search(line, found, kPattern)) {
        return line;
    }
    std::string word = std::to_string(target);
    const std::size_t width = static_cast<std::size_t>(found.length(2) + found.length(3));
    word.resize(std::max(width, word.size() + 1), ' ');
    return found.str(1) + word + found.suffix().str();
}

/// `line` with another tick and value, if it expects this field.
void expectInstead(std::string& line, const std::string& field, std::uint32_t tick,
                   std::int32_t value) {
    const std::regex pattern(R"(^(expect\s+)(\d+)(\s+)" + field + R"(\s*\S+\s*)(-?\d+))");
    std::smatch found;
    if (std::regex_search(line, found, pattern)) {
        line = found.str(1) + std::to_string(tick) + found.str(3) + std::to_string(value) +
               found.suffix().str();
    }
}

int clamped(int target) {
    constexpr int kMost = 12000; // 1/1000 m: the side walls
    return std::clamp(target, -kMost, kMost);
}

} // namespace

FirstHit firstHitOf(const std::string& text) {
    static const std::regex kPattern(R"(#\s*first hit:\s*(left of (-?\d+)|\w+))");
    std::smatch found;
    FirstHit hit;
    if (std::regex_search(text, found, kPattern)) {
        if (found[2].matched) {
            hit.leftOf = std::stod(found.str(2));
        } else {
            hit.stuff = found.str(1);
        }
    }
    return hit;
}

std::string withCollapse(const std::string& text, const Collapsing& collapse) {
    constexpr std::uint32_t kSpare = kTicksPerSecond / 2;
    const std::uint32_t end = collapse.largestTick + kSpare;
    const std::string falls = std::to_string(collapse.largest) +
                              " blocks fall; balls half a ball further left and right bring down " +
                              std::to_string(collapse.besideLeft) + " and " +
                              std::to_string(collapse.besideRight) + ".";
    std::vector<std::string> lines = linesOf(text);
    // Hashes of the former game may lie beyond the end of this one.
    std::erase_if(lines, [](const std::string& line) { return line.starts_with("hash "); });
    for (std::string& line : lines) {
        if (line.starts_with("seed ")) {
            line = "seed " + std::to_string(collapse.seed);
        } else if (line.starts_with("end ")) {
            line = "end " + std::to_string(end);
        } else if (line.starts_with("#") && line.find(" blocks fall; ") != std::string::npos) {
            line = "# " + falls;
        } else if (isInput(line)) {
            line = withTarget(line, collapse.target);
        }
        expectInstead(line, "blocksLeft", collapse.hitTick - 1, collapse.blocks);
        expectInstead(line, "letGo", std::min(collapse.fallTick + kSpare, end), 1);
        expectInstead(line, "largestFall", end, (3 * collapse.largest + 3) / 4);
    }
    return joined(lines);
}

void moveTargets(Replay& replay, int shift) {
    for (InputChange& change : replay.inputs) {
        if (change.input.target) {
            change.input.target =
                static_cast<std::int16_t>(clamped(int{*change.input.target} + shift));
        }
    }
}

std::size_t targetGroups(const Replay& replay) {
    std::size_t groups = 0;
    std::optional<std::int16_t> last;
    for (const InputChange& change : replay.inputs) {
        groups += change.input.target && change.input.target != last ? 1 : 0;
        last = change.input.target;
    }
    return groups;
}

void moveGroups(Replay& replay, const std::vector<int>& shifts) {
    std::size_t groups = 0;
    std::optional<std::int16_t> last;
    for (InputChange& change : replay.inputs) {
        const std::optional<std::int16_t> target = change.input.target;
        groups += target && target != last ? 1 : 0;
        last = target;
        if (target) {
            change.input.target =
                static_cast<std::int16_t>(clamped(int{*target} + shifts[groups - 1]));
        }
    }
}

std::string withTargets(const std::string& text, std::uint32_t seed,
                        const std::vector<int>& shifts) {
    std::vector<std::string> lines = linesOf(text);
    std::size_t groups = 0;
    std::optional<int> last;
    for (std::string& line : lines) {
        if (line.starts_with("seed ")) {
            line = "seed " + std::to_string(seed);
        }
        if (!isInput(line)) {
            continue;
        }
        const std::optional<int> target = targetIn(line);
        groups += target && target != last ? 1 : 0;
        last = target;
        if (target) {
            line = withTarget(line, clamped(*target + shifts[groups - 1]));
        }
    }
    return joined(lines);
}

} // namespace apart
