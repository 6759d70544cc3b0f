// SPDX-License-Identifier: MIT
#include "bench_scenes.hpp"

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

double widestPin(const scenes::SceneDef& scene, const Engine& engine) {
    const auto now = [&](std::size_t body, scenes::Vec2 point) {
        const scenes::BodyDef& def = scene.bodies[body]; // the initial rotation of the frame is 0
        const BodyState state = engine.state(body);
        return state.position + state.rotation * (point - def.position);
    };
    double widest = 0;
    for (const scenes::RevoluteJointDef& joint : scene.joints) {
        const scenes::Vec2 gap = now(joint.a, joint.point) - now(joint.b, joint.point);
        widest = std::max(widest, std::sqrt(dot(gap, gap)));
    }
    return widest;
}

} // namespace

Stage::Stage(Engine& engine, const scenes::SceneDef& scene) : engine_(engine) {
    for (const scenes::BodyDef& body : scene.bodies) {
        defs_.push_back(std::make_shared<const scenes::BodyDef>(body));
    }
}

void Stage::add(const scenes::BodyDef& body) {
    engine_.add(body);
    defs_.push_back(std::make_shared<const scenes::BodyDef>(body));
}

void Stage::remove(std::size_t body) {
    engine_.remove(body);
    defs_[body].reset();
}

std::vector<Placed> Stage::bodies() const {
    std::vector<Placed> list;
    for (std::size_t i = 0; i < defs_.size(); ++i) {
        if (defs_[i]) {
            list.push_back({i, defs_[i].get(), engine_.state(i)});
        }
    }
    return list;
}

std::span<const Recipe> recipes() {
    static const Recipe kRecipes[] = {
        {"pyramid", "1 m boxes, each row one shorter", "boxes in the lowest row", 60, 300, pyramid},
        {"circles", "balls of radius 0.25 m fall into a container", "balls", 5000, 600, circles},
        {"debris", "polygons of 3 to 7 corners and Ls fall into a container", "bodies", 2000, 600,
         debris},
        {"tumbler", "0.25 m boxes in a drum that turns", "boxes", 2000, 600, tumbler},
        {"breakout", "fast balls among locked blocks, and falling shards", "shards", 200, 1200,
         breakout},
        {"stack", "1 m boxes, one on the other", "boxes", 20, 600, stack},
        {"massratio", "a heavy box on ten light ones", "times the density of the light", 1000, 600,
         massRatio},
        {"rain", "drops fall on roofs; they are added above and removed below", "drops in the air",
         1000, 600, rain},
        {"joints", "a hanging net of balls with revolute joints swings", "balls along a side", 40,
         300, joints},
        {"spinner", "a bar with a motor stirs balls, boxes and polygons", "bodies", 1000, 600,
         spinner},
        {"asleep", "boxes on shelves, asleep before the measurement starts", "boxes", 10000, 6000,
         asleep},
        {"shots", "boxes asleep on shelves; each step adds a ball above and removes the last",
         "boxes", 10000, 600, shots},
        {"tiles", "200 balls and boxes bounce on static tiles", "tiles", 10000, 600, tiles},
        {"rays", "100 rays of 20 m in every step, among boxes that do not move", "boxes", 10000,
         200, rays},
        {"flying", "balls fly about in a closed box; 10 rays of 20 m in every step", "balls", 2000,
         300, flying},
        {"churn", "a heap of balls; each step removes 100 and adds 100 above", "balls", 500, 300,
         churn},
        {"columns", "balls fall on sleeping columns of four boxes, one every 2 s", "columns", 2000,
         1200, columns},
        {"pushed", "boxes asleep on shelves; each step pushes one", "boxes", 10000, 600, pushed},
        {"removals", "all boxes are removed at once; only that is timed", "boxes", 10000, 1,
         removals},
        {"particles", "balls that live for a second over a floor", "balls in the air", 500, 600,
         particles},
        {"events", "pyramid; each step reads begins, ends and hits of contacts",
         "boxes in the lowest row", 60, 300, events},
        {"contacts", "pyramid; each step reads all touching pairs", "boxes in the lowest row", 60,
         300, contacts},
        {"heavypair", "a pyramid of 820 boxes, and a heavy box on a light one far away",
         "times the density of the light", 1000, 300, heavyPair},
        {"slab", "a heavy slab carries light boxes", "light boxes", 1000, 300, slab},
        {"plank", "one plank lies on discs", "discs", 3000, 300, plank},
        {"pairs", "separate pairs of boxes", "pairs", 1000, 300, pairs},
        {"balls", "separate balls", "balls", 300, 600, balls},
        {"ragdolls", "figures of 11 bodies with joint limits fall", "figures", 10, 600, ragdolls},
        {"chains", "chains of 100 links swing", "chains", 10, 300, chains},
        {"shortchains", "chains of ten links swing", "chains", 10, 300, shortChains},
        {"bridge", "four bridges of planks", "planks", 50, 600, bridge},
        {"bridgecars", "four bridges, three cars on each", "planks", 50, 600, bridgeCars},
        {"hub", "bars hang on joints around a light hub", "bars", 300, 600, hub},
        {"arm", "arms of five segments with motors and limits", "arms", 20, 600, arm},
        {"crane", "jibs with a load on a rope of 20 links", "cranes", 10, 600, crane},
        {"wheel", "bars hang on joints around a hub that a motor turns", "bars", 300, 600, wheel},
        {"cars", "cars with two motors on uneven ground", "cars", 100, 600, cars},
        {"ring", "bodies in a closed ring get 40 m/s again and again", "bodies", 400, 300, ring},
        {"shards", "a burst of small polygons", "polygons", 500, 300, shards},
        {"sparks", "small balls fly apart and touch nothing", "balls", 2000, 300, sparks},
        {"smash", "a heavy ball flies through a wall of boxes", "boxes", 500, 300, smash},
        {"crowdpoint", "boxes that start on one point", "boxes", 100, 300, crowdPoint},
        {"stream", "static tiles are added ahead and removed behind; 500 balls rest",
         "tiles a step, each way", 100, 300, stream},
        {"cleared", "the steps after all boxes were removed", "boxes", 10000, 10, cleared},
        {"woken", "an island of sleeping boxes wakes", "boxes", 10000, 10, woken},
        {"explosion", "a wall of boxes is blown apart", "boxes", 3000, 60, explosion},
        {"fracture", "blocks of a wall break into five, twenty a step", "blocks", 2000, 100,
         fracture},
        {"loaded", "the first ray after a load; only that is timed", "boxes", 10000, 20, loaded},
        {"unlike", "large balls on 2,000 small ones", "times their radius", 10, 600, unlike},
        {"empty", "nothing", "", 1, 100000, empty},
        {"smallroom", "a ball bounces between ten walls", "", 1, 60000, smallRoom},
        {"forces", "ten boxes, the top one heavy: what each contact carries", "times the density",
         10, 300, forces},
        {"slide", "a box slides until friction has stopped it", "", 1, 180, slide},
        {"bounce", "a ball bounces three times", "", 1, 300, bounce},
        {"pendulum", "a bar swings from 90 degrees for a minute", "", 1, 3600, pendulum},
    };
    return kRecipes;
}

Recipe recipeOf(const std::string& name) {
    const std::vector<Recipe> sandbox = sandboxRecipes();
    for (const std::span<const Recipe> list : {recipes(), std::span<const Recipe>(sandbox)}) {
        for (const Recipe& recipe : list) {
            if (name == recipe.name) {
                return recipe;
            }
        }
    }
    throw WrongUse("there is no scene '" + name + "'; --list names them all");
}

scenes::BodyDef wall(double width, double height, scenes::Vec2 center, scenes::Material material) {
    scenes::BodyDef def = scenes::box(width, height, center, material);
    def.locked = true;
    return def;
}

std::vector<scenes::BodyDef> ringOfWalls(double radius) {
    constexpr int kSides = 48;
    std::vector<scenes::BodyDef> walls;
    for (int i = 0; i < kSides; ++i) {
        const scenes::Vec2 from = radius * scenes::direction(static_cast<double>(i) / kSides);
        const scenes::Vec2 to = radius * scenes::direction(static_cast<double>(i + 1) / kSides);
        const scenes::Vec2 middle = 0.5 * (from + to);
        const double reach = std::sqrt(dot(middle, middle));
        scenes::BodyDef side =
            wall(std::sqrt(dot(to - from, to - from)) + 0.5, 1, ((reach + 0.5) / reach) * middle);
        side.rotation = scenes::slope(to.y - from.y, to.x - from.x);
        walls.push_back(side);
    }
    return walls;
}

std::vector<scenes::Vec2> addShelves(scenes::SceneDef& scene, int places, scenes::Vec2 pitch) {
    const int shelves = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(places))));
    for (int shelf = 0; shelf < shelves; ++shelf) {
        const double width = pitch.x * shelves + 2;
        scene.bodies.push_back(wall(width, 0.5, {0, pitch.y * shelf - 0.25}));
    }
    std::vector<scenes::Vec2> list;
    for (int i = 0; i < places; ++i) {
        const double x = pitch.x * (i % shelves - 0.5 * (shelves - 1));
        list.push_back({x, pitch.y * (i / shelves)});
    }
    return list;
}

scenes::Polygon shard(scenes::Dice& dice, double radius) {
    return randomPolygon(dice, 3 + dice.below(5), 2 * radius, 2 * radius);
}

double stretch(int size, int usual) {
    return std::sqrt(static_cast<double>(size) / usual);
}

Error meanDepth() {
    return {"depth, mean", "mm",
            [](const Stage&, const Depths& depths) { return 1000 * depths.mean; }};
}

Error widestJoint(const scenes::SceneDef& scene) {
    return {"largest gap at a joint", "mm", [scene](const Stage& stage, const Depths&) {
                return 1000 * widestPin(scene, stage.engine());
            }};
}

Error speedLost(std::vector<std::size_t> bodies, double speed) {
    return {"speed lost or won", "", [=](const Stage& stage, const Depths&) {
                double sum = 0;
                for (const std::size_t body : bodies) {
                    const scenes::Vec2 v = stage.engine().state(body).velocity;
                    sum += dot(v, v) / static_cast<double>(bodies.size());
                }
                return std::abs(std::sqrt(sum) / speed - 1);
            }};
}

} // namespace bench
