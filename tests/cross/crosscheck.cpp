// SPDX-License-Identifier: MIT
// Plays every scene of the book in Kodo (three profiles, float and double), in Box2D 2.4.1 and, if
// the build has it, in Box2D 3, and prints all as JSON for tools/lib/crosscheck.py; with a file
// .toml, or --sandbox and the name of a scene of the sandbox, only that one. --errors prints the
// table errors.txt instead. Exit code: 0 all figures hold, 1 some do not, 2 the scene has a
// mistake, or Box2D has no equal of it.
#include <catalogue/scene.hpp>
#include <scene_files/scene_file.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cross_scene.hpp"
#include "scene_reader.hpp"

namespace {

using namespace crosscheck;

/// One scene in one engine.
struct Play {
    std::string name;
    std::optional<Kodo> kodo; // else Box2D
    bool isV3 = false;
    Played played;
    std::string lacks; // why the engine does not play the scene; then nothing is played
};
using Plays = std::vector<Play>; // the first one is the reference; Box2D 2.4.1 follows Kodo

const char* const kProfiles[] = {"balanced", "accurate", "thesis2006"};
constexpr std::size_t kBox2d = 6; // the index of 2.4.1

std::string text(const std::string& words) {
    std::string result = "\"";
    for (const char c : words) {
        result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return result + '"';
}

std::string number(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    return std::isfinite(value) ? digits : "null";
}

template <typename List, typename Write>
std::string list(const List& all, Write write) {
    std::string result = "[";
    for (const auto& one : all) {
        result += (result.size() > 1 ? "," : "") + write(one);
    }
    return result + "]";
}

std::string point(scenes::Vec2 p) {
    return "[" + number(p.x) + "," + number(p.y) + "]";
}

/// The outline of a capsule, each end in eight edges.
std::vector<scenes::Vec2> outlineOf(const scenes::Capsule& capsule) {
    const scenes::Vec2 way = capsule.to - capsule.from;
    const double along = std::atan2(way.y, way.x);
    std::vector<scenes::Vec2> corners;
    for (int i = 0; i <= 17; ++i) {
        const double angle = along + kPi * ((i < 9 ? i : i - 1) / 8.0 - 0.5);
        corners.push_back((i < 9 ? capsule.to : capsule.from) +
                          capsule.radius * scenes::Vec2{std::cos(angle), std::sin(angle)});
    }
    return corners;
}

std::string partOf(const scenes::Part& part) {
    if (const auto* circle = std::get_if<scenes::Circle>(&part)) {
        return R"({"radius":)" + number(circle->radius) + R"(,"center":)" + point(circle->center) +
               "}";
    }
    if (const auto* capsule = std::get_if<scenes::Capsule>(&part)) {
        return R"({"corners":)" + list(outlineOf(*capsule), point) + "}";
    }
    const auto* box = std::get_if<scenes::Box>(&part);
    return R"({"corners":)" +
           list(box != nullptr ? cornersOf(*box) : std::get<scenes::Polygon>(part).corners, point) +
           "}";
}

std::string bodyOf(const scenes::BodyDef& body) {
    return R"({"position":)" + point(body.position) + R"(,"rotation":)" +
           point({body.rotation.c, body.rotation.s}) + R"(,"center":)" +
           point(massOf(body).center) + R"(,"locked":)" + (body.locked ? "true" : "false") +
           R"(,"parts":)" + list(body.parts, partOf) + "}";
}

std::string playOf(const Play& play) {
    const Played& played = play.played;
    return R"({"name":)" + text(play.name) + R"(,"lacks":)" + text(play.lacks) + R"(,"tracks":)" +
           list(played.tracks,
                [](const auto& one) {
                    return R"({"body":)" + number(static_cast<double>(one.first)) +
                           R"(,"points":)" +
                           list(one.second,
                                [](const TrackPoint& at) {
                                    return "[" + number(at.time) + "," + number(at.position.x) +
                                           "," + number(at.position.y) + "," + number(at.angle) +
                                           "]";
                                }) +
                           "}";
                }) +
           R"(,"impacts":)" +
           list(played.impacts,
                [](const Impact& one) {
                    return "[" + number(one.time) + "," + number(static_cast<double>(one.a)) + "," +
                           number(static_cast<double>(one.b)) + "," + number(one.impulse) + "]";
                }) +
           "}";
}

/// The box (m) around the paths of what is drawn, in the first play and in Box2D 2.4.1.
struct Extent {
    scenes::Vec2 middle;
    double size = 0; // of the longer side
};

Extent extentOf(const CrossScene& scene, const Plays& plays) {
    scenes::Vec2 low{1e9, 1e9};
    scenes::Vec2 high{-1e9, -1e9};
    for (const Played* played : {&plays.front().played, &plays[kBox2d].played}) {
        for (const auto& [body, points] : played->tracks) {
            const double reach = body < scene.def.bodies.size()
                                     ? reachOf(scene.def.bodies[body])
                                     : 0; // a piece is within the reach of its whole
            for (const TrackPoint& at : points) {
                low = {std::min(low.x, at.position.x - reach),
                       std::min(low.y, at.position.y - reach)};
                high = {std::max(high.x, at.position.x + reach),
                        std::max(high.y, at.position.y + reach)};
            }
        }
    }
    return {0.5 * (low + high), std::max(high.x - low.x, high.y - low.y)};
}

/// How far (share of the extent) a point is from its place in the reference when they part.
constexpr double kParted = 0.01;
/// Units of place, angle and time in the frames: a quarter of a pixel of the page or less.
constexpr double kPlacesPerExtent = 2000;
constexpr double kAnglesPerTurn = 4096;
constexpr double kTimesPerSecond = 1e4;
/// Bodies times frames of a play; above it only each second, third... frame is kept.
constexpr std::size_t kMostPlaces = 20'000;

bool canMove(const scenes::BodyDef& body) {
    return !body.locked || body.spin != 0 || dot(body.velocity, body.velocity) > 0;
}

std::string framesOf(const CrossScene& scene, const Played& played, const Extent& extent) {
    const std::size_t bodies = played.frames.back().size();
    const std::size_t stride = 1 + played.times.size() * bodies / kMostPlaces;
    std::vector<std::size_t> kept;
    for (std::size_t frame = 0; frame < played.times.size(); frame += stride) {
        kept.push_back(frame);
    }
    const auto whole = [](double value) {
        return std::to_string(std::lround(std::clamp(value, -30000.0, 30000.0)));
    };
    std::string moving;
    for (std::size_t body = 0; body < bodies; ++body) {
        if (body < scene.def.bodies.size() && !canMove(scene.def.bodies[body])) {
            continue;
        }
        std::string places;
        for (const std::size_t frame : kept) {
            if (body < played.frames[frame].size()) {
                const Place& at = played.frames[frame][body];
                const scenes::Vec2 p =
                    (kPlacesPerExtent / extent.size) * (at.position - extent.middle);
                places += (places.empty() ? "" : ",") + whole(p.x) + "," + whole(p.y) + "," +
                          whole(at.angle * kAnglesPerTurn / (2 * kPi));
            }
        }
        moving += (moving.empty() ? "[" : ",[") + std::to_string(body) + ",[" + places + "]]";
    }
    return R"({"times":)" +
           list(kept,
                [&](std::size_t frame) {
                    return std::to_string(std::lround(played.times[frame] * kTimesPerSecond));
                }) +
           R"(,"bodies":[)" + moving + R"(],"splits":)" +
           list(played.splits,
                [&](const Split& one) {
                    return "[" + std::to_string((one.frame + stride - 1) / stride) + "," +
                           std::to_string(one.body) + "," + std::to_string(one.part) + "]";
                }) +
           "}";
}

/// What the page needs to play the scene, of all that play it.
std::string filmOf(const CrossScene& scene, const Plays& plays) {
    const Extent extent = extentOf(scene, plays);
    std::string frames;
    std::string parted;
    for (const Play& play : plays) {
        if (!play.lacks.empty()) {
            continue;
        }
        const std::optional<double> time =
            partingTime(scene, plays.front().played, play.played, kParted * extent.size);
        parted += (parted.empty() ? "" : ",") + (time ? number(*time) : "null");
        frames += (frames.empty() ? "" : ",") + framesOf(scene, play.played, extent);
    }
    return R"({"middle":)" + point(extent.middle) + R"(,"unit":)" +
           number(extent.size / kPlacesPerExtent) + R"(,"angles":)" + number(kAnglesPerTurn) +
           R"(,"times":)" + number(kTimesPerSecond) + R"(,"distance":)" +
           number(kParted * extent.size) + R"(,"parted":[)" + parted + R"(],"plays":[)" + frames +
           "]}";
}

const char* ruleName(Rule rule) {
    switch (rule) {
    case Rule::Exact:
        return "exact";
    case Rule::KodoExact:
        return "kodo";
    case Rule::Agree:
        return "agree";
    case Rule::AtMost:
        return "most";
    case Rule::Show:
        break;
    }
    return "show";
}

/// The value, tolerance and verdict of one engine. A figure that is not judged has no tolerance.
std::string resultOf(const Figure& figure, const Play& play, std::size_t index, double box2d) {
    const double value = play.played.values[index];
    const double tolerance = play.kodo                     ? toleranceOf(figure, *play.kodo)
                             : figure.rule == Rule::AtMost ? figure.tolerance
                                                           : toleranceOfBox2d(figure, play.isV3);
    const bool right =
        play.kodo ? holds(figure, *play.kodo, value, box2d) : box2dHolds(figure, play.isV3, value);
    const bool judged = tolerance >= 0 && figure.rule != Rule::Show;
    return R"({"value":)" + number(value) + R"(,"tolerance":)" +
           (judged ? number(tolerance) : "null") + R"(,"holds":)" + (right ? "true" : "false") +
           "}";
}

/// The reasons of tolerances that engines have of their own.
std::string reasonsOf(const Figure& figure) {
    std::string result;
    const auto add = [&](const char* name, const std::optional<Own>& own) {
        if (own) {
            result += std::string(result.empty() ? "" : ",") + "[" + text(name) + "," +
                      number(own->tolerance) + "," + text(own->reason) + "]";
        }
    };
    add("accurate", figure.accurate);
    add("thesis2006", figure.withShock ? figure.withShock : figure.thesis);
    add("Box2D", figure.box2d);
    add("Box2D 3", figure.box2d3);
    return "[" + result + "]";
}

std::string figureOf(const Figure& figure, const Plays& plays, std::size_t index, bool& good) {
    const double box2d = plays[kBox2d].played.values[index];
    for (const Play& play : plays) {
        if (play.kodo) {
            good = good && holds(figure, *play.kodo, play.played.values[index], box2d);
        }
    }
    good = good && (figure.rule != Rule::Exact || box2dHolds(figure, false, box2d));
    const auto result = [&](const Play& play) {
        return play.lacks.empty() ? resultOf(figure, play, index, box2d) : "null";
    };
    return R"({"what":)" + text(figure.what) + R"(,"unit":)" + text(figure.unit) + R"(,"rule":")" +
           ruleName(figure.rule) + R"(","exact":)" + number(figure.exact) + R"(,"tolerance":)" +
           number(figure.tolerance) + R"(,"reason":)" + text(figure.reason) + R"(,"results":)" +
           list(plays, result) + R"(,"reasons":)" + reasonsOf(figure) + "}";
}

Plays playAll(const CrossScene& scene) {
    Plays plays;
    for (const Profile profile : {Profile::Balanced, Profile::Accurate, Profile::Thesis}) {
        const std::string name = kProfiles[static_cast<std::size_t>(profile)];
        plays.push_back({name + ", float", Kodo{profile, false}, false,
                         play(scene, *f32::makeKodo(scene.def, profile)), ""});
        plays.push_back({name + ", double", Kodo{profile, true}, false,
                         play(scene, *f64::makeKodo(scene.def, profile)), ""});
    }
    plays.push_back({"Box2D 2.4.1", std::nullopt, false,
                     play(scene, *makeBox2d(scene.def, scene.bounceThreshold)), ""});
    if (hasBox2d3()) {
        plays.push_back({"Box2D 3", std::nullopt, true, {}, ""});
        try {
            plays.back().played = play(scene, *makeBox2d3(scene.def, scene.bounceThreshold));
        } catch (const std::invalid_argument& problem) {
            plays.back().lacks = problem.what();
        }
    }
    return plays;
}

std::string sceneOf(const CrossScene& scene, bool& good) {
    const Plays plays = playAll(scene);
    std::string figures;
    for (std::size_t i = 0; i < scene.figures.size(); ++i) {
        figures += (i > 0 ? "," : "") + figureOf(scene.figures[i], plays, i, good);
    }
    return R"({"name":)" + text(scene.name) + R"(,"title":)" + text(scene.title) + R"(,"text":)" +
           text(scene.text) + R"(,"difference":)" + text(scene.difference) + R"(,"chains":)" +
           list(scene.def.chains,
                [](const scenes::ChainDef& chain) { return list(chain.points, point); }) +
           R"(,"bodies":)" + list(scene.def.bodies, bodyOf) + R"(,"figures":[)" + figures +
           R"(],"plays":)" + list(plays, playOf) + R"(,"film":)" + filmOf(scene, plays) + "}";
}

/// With two digits, rounded up.
std::string error(double value) {
    if (value == 0) {
        return "0";
    }
    char digits[32];
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    std::snprintf(digits, sizeof digits, "%.2g", unit * std::ceil(value / unit * (1 - 1e-9)));
    return digits;
}

/// The errors of all figures that have a closed form, as lines of the table.
int printErrors() {
    for (const CrossScene& scene : sceneBook()) {
        std::vector<Played> plays;
        for (const Profile profile :
             {Profile::Balanced, Profile::Accurate, Profile::Thesis, Profile::ThesisWithoutShock}) {
            plays.push_back(play(scene, *f32::makeKodo(scene.def, profile)));
            plays.push_back(play(scene, *f64::makeKodo(scene.def, profile)));
        }
        for (std::size_t i = 0; i < scene.figures.size(); ++i) {
            const Figure& figure = scene.figures[i];
            if (figure.rule != Rule::Exact && figure.rule != Rule::KodoExact) {
                continue;
            }
            std::cout << scene.name << " | " << figure.what << " |";
            for (const Played& played : plays) {
                std::cout << " " << error(std::abs(played.values[i] - figure.exact));
            }
            std::cout << "\n";
        }
    }
    return 0;
}

int print(const std::vector<CrossScene>& scenes) {
    bool good = true;
    std::string separator = "[";
    for (const CrossScene& scene : scenes) {
        std::cout << separator << sceneOf(scene, good) << "\n";
        separator = ",";
    }
    std::cout << "]\n";
    return good ? 0 : 1;
}

constexpr std::size_t kLongestFile = 1'000'000; // bytes

int refuse(const apart::FileProblem& problem) {
    for (const std::string& line : problem.texts()) {
        std::cerr << line << "\n";
    }
    return 2;
}

int printRead(const std::string& text, const std::string& file, const std::string& about) {
    apart::Read<CrossScene> read = readScene(text, file);
    if (const auto* problem = std::get_if<apart::FileProblem>(&read)) {
        return refuse(*problem);
    }
    auto& scene = std::get<CrossScene>(read);
    scene.text = about + scene.text;
    try {
        return print({scene});
    } catch (const std::exception& error) {
        return refuse({file, 0, error.what()});
    }
}

int printSandbox(const std::string& name) {
    for (const destructoooor::Scene& scene : destructoooor::catalogue()) {
        if (scene.name == name) {
            const scene_files::SceneHead head{name, static_cast<double>(scene.seconds)};
            std::string about = std::string(scene.question) + " ";
            about += scene.act != nullptr ? "Without what the scene does in each step. " : "";
            return printRead(scene_files::sceneText(stage(scene).world, head), name, about);
        }
    }
    return refuse({name, 0, "The sandbox has no such scene. destructoooor --list names them."});
}

int printFile(const std::string& file) {
    const apart::Read<std::string> text = apart::readTextFile(file, kLongestFile);
    if (const auto* problem = std::get_if<apart::FileProblem>(&text)) {
        return refuse(*problem);
    }
    return printRead(std::get<std::string>(text), file, "");
}

} // namespace

int main(int count, char** arguments) {
    if (count == 2 && std::string(arguments[1]) == "--errors") {
        return printErrors();
    }
    if (count == 3 && std::string(arguments[1]) == "--sandbox") {
        return printSandbox(arguments[2]);
    }
    return count == 2 ? printFile(arguments[1]) : print(sceneBook());
}
