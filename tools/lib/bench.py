# SPDX-License-Identifier: MIT
"""Measurements of tools/bench; see its --help."""
import math
import pathlib
import sys
import typing

import box2d3
import chart
import measure
from measure import number

OUT = pathlib.Path("build/bench/report")

class Wanted(typing.NamedTuple):
    """A scene, its size, and the targets of the default profile. None: no limit."""

    name: str
    size: int
    ratio: float = None  # largest CPU time relative to Box2D
    depth: float = None  # mm, largest mean overlap
    error: float = None  # largest error, in the unit of the scene
    stands: bool = False  # no body may fall


SCENES = [
    Wanted("pyramid", 60, 0.13, 1.2, stands=True),
    Wanted("pyramid", 100, 0.073, 7.5, stands=True),
    Wanted("circles", 5000, 0.092, 10),
    Wanted("debris", 2000, 0.072, 12),
    Wanted("tumbler", 2000, 0.036, 12),
    Wanted("breakout", 200, 0.11, error=0.001),
    Wanted("stack", 20, 0.23, error=50, stands=True),
    Wanted("massratio", 1000, error=5, stands=True),
    Wanted("rain", 1000),
    Wanted("joints", 40),
    Wanted("spinner", 1000),
    Wanted("asleep", 10000),
    Wanted("shots", 10000),
    Wanted("tiles", 10000),
    Wanted("rays", 10000),
    Wanted("flying", 2000),
    Wanted("churn", 500),
    Wanted("smallroom", 1),
    Wanted("empty", 1),
]
# Loads of games, measured beside Box2D 3 or where --scenes names them.
LOADS = [
    Wanted("columns", 2000),
    Wanted("columns", 10000),
    Wanted("pushed", 10000),
    Wanted("removals", 10000),
    Wanted("removals", 50000),
    Wanted("particles", 500),
    Wanted("events", 60),
    Wanted("contacts", 60),
    Wanted("heavypair", 1000),
    Wanted("heavypair", 3000),
    Wanted("slab", 1000),
    Wanted("plank", 3000),
    Wanted("pairs", 1000),
    Wanted("balls", 300),
    Wanted("ragdolls", 10),
    Wanted("ragdolls", 100),
    Wanted("chains", 10),
    Wanted("shortchains", 10),
    Wanted("bridge", 50),
    Wanted("bridgecars", 50),
    Wanted("hub", 300),
    Wanted("arm", 20),
    Wanted("crane", 10),
    Wanted("wheel", 300),
    Wanted("cars", 100),
    Wanted("ring", 400),
    Wanted("shards", 500),
    Wanted("smash", 500),
    Wanted("crowdpoint", 100),
    Wanted("unlike", 10),
    Wanted("unlike", 100),
    Wanted("fracture", 2000),
    Wanted("woken", 10000),
    Wanted("explosion", 3000),
    Wanted("stream", 100),
    Wanted("cleared", 10000),
    Wanted("loaded", 10000),
]
PROFILES = ("balanced", "fast", "accurate", "thesis2006")
# 1, 4 and 16 times the bodies, and 100,000. Heaps grow in width, pyramids in height.
GROWTH = {
    "pyramid": (60, 120, 240),
    "circles": (5000, 20000, 80000, 100000),
    "debris": (2000, 8000, 32000),
}


class Options(measure.Options):
    def check(self, chosen):
        measure.refuse_quick(self, chosen)
        if chosen.box2d3 and (chosen.engines or chosen.profiles):
            self.error("--box2d3 compares Kodo in float with its defaults: give no --engines or --profiles")


def options():
    parser = Options("tools/bench")
    parser.add_argument("--scenes", nargs="+", choices=sorted({scene.name for scene in SCENES + LOADS}))
    parser.add_argument("--box2d3", metavar="DIR", type=box2d3.folder)
    parser.add_argument("--engines", nargs="+", choices=["kodo", "kodo64"])
    parser.add_argument("--profiles", nargs="+", choices=PROFILES)
    parser.add_argument("--repeat", type=measure.runs)
    parser.add_argument("--no-growth", dest="growth", action="store_false")
    parser.add_argument("--quick", action="store_true")
    chosen = parser.parse_args()
    chosen.engines = chosen.engines or ["kodo", "kodo64"]
    chosen.profiles = chosen.profiles or ["balanced"]
    chosen.repeat = 1 if chosen.quick else chosen.repeat or 5
    chosen.growth = chosen.growth and not chosen.quick
    return chosen


def jobs_of(scene, size, chosen):
    """Box2D first, then Kodo with every engine and profile."""
    common = ["--scene", scene, "--size", size]
    ways = [["--engine", "box2d"]]
    for engine in chosen.engines:
        ways += [["--engine", engine, "--profile", profile] for profile in chosen.profiles]
    return [common + way for way in ways]


def with_ratios(results):
    """Adds the ratio of each result to the first one of the scene, that of Box2D."""
    for result in results:
        result["ratio"] = result["cpuMsPerStep"] / results[0]["cpuMsPerStep"]
    return results


def way_of(result):
    profile = result["profile"]  # None of Box2D
    return result["engine"] + ("" if profile in (None, "balanced") else f" {profile}")


def limits_of(wanted):
    """(name, key in a result, largest value) of each target."""
    limits = [
        ("ratio", "ratio", wanted.ratio),
        ("mean depth", "depthMeanMm", wanted.depth),
        ("error", "error", wanted.error),
        ("escaped", "escaped", 0),
    ]
    return [limit for limit in limits if limit[2] is not None]


def missed(wanted, result):
    """The missed targets in words; empty if there are none."""
    words = []
    for what, key, limit in limits_of(wanted):
        if result[key] is not None and result[key] > limit:
            words.append(f"{what} at most {limit:g}")
    if wanted.stands and result["stood"] < result["bodies"]:
        words.append("all stand")
    return ", ".join(words)


def table(scenes, results):
    lines = [
        "| scene | bodies | engine | ms a step | spread | ns a body and step | ratio"
        " | overlap max / mean mm | stood | escaped | error | missed targets |",
        "|---|--:|---|--:|--:|--:|--:|--:|--:|--:|---|---|",
    ]
    for wanted, group in zip(scenes, results):
        for result in group:
            error = f"{result['errorName']} {number(result['error'])} {result['errorUnit']}"
            lines.append(
                f"| {wanted.name} {wanted.size} | {result['bodies']:,} | {way_of(result)}"
                f" | {number(result['cpuMsPerStep'])} | {100 * result['spread']:.0f} %"
                f" | {number(result['nsPerBodyStep']) if result['bodies'] else ''}"
                f" | {number(result['ratio'])}"
                f" | {number(result['depthMaxMm'])} / {number(result['depthMeanMm'])}"
                f" | {result['stood']:,} | {'' if result['escaped'] is None else result['escaped']}"
                f" | {error if result['error'] is not None else ''}"
                f" | {missed(wanted, result) if way_of(result) == 'kodo' else ''} |"
            )
    return "\n".join(lines) + "\n"


def draw_ratios(scenes, results, path):
    """Draws a bar with the ratio to Box2D for each scene, engine and profile."""
    ways = [way_of(result) for result in results[0][1:]]
    bar, gap, top = 13, 14, 76
    height = top + len(scenes) * (bar * len(ways) + gap) + 60
    page = chart.Page(860, height, "CPU time of a step relative to Box2D 2.4.1 (shorter is faster)")
    for i, way in enumerate(ways):
        page.legend(20 + 150 * i, 52, [(way, chart.COLOURS[i])])
    ratios = [result["ratio"] for group in results for result in group]
    across = chart.LogScale(min(0.01, *ratios), max(2, *ratios), 150, 800)
    up = height - 44
    for value in across.ticks():
        page.line([(across(value), up), (across(value), top - 6)], chart.FAINT)
        page.text(across(value), up + 16, f"{value:g}", "middle", 11)
    for i, (wanted, group) in enumerate(zip(scenes, results)):
        y = top + i * (bar * len(ways) + gap)
        page.text(142, y + bar * len(ways) / 2 + 4, f"{wanted.name} {wanted.size}", "end")
        for k, result in enumerate(group[1:]):
            end = across(result["ratio"])
            page.bar(across.start, y + k * bar, end - across.start, bar - 2, chart.COLOURS[k])
            page.text(end + 4, y + k * bar + 9, number(result["ratio"]), size=10)
        if wanted.ratio:
            x = across(wanted.ratio)
            page.line([(x, y - 3), (x, y + bar * len(ways) + 1)], "#cf222e", 2)
    page.line([(across(1), up), (across(1), top - 6)], chart.INK, 1.5)
    page.text(across.start, up + 34, "red: target; black: equal to Box2D", size=11)
    page.write(path)


def allowed(first, result):
    """ns a body and step for n log n growth from the first result on."""
    return first["nsPerBodyStep"] * math.log(result["bodies"]) / math.log(first["bodies"])


def draw_growth(groups, path):
    """ns a body and step against the number of bodies; dashed: n log n from the smallest."""
    page = chart.Page(860, 480, "Cost of a body against the number of bodies")
    page.text(16, 46, "Kodo, default settings, CPU time of one thread", colour="#57606a")
    results = [result for group in groups for result in group]
    bodies = [result["bodies"] for result in results]
    times = [result["nsPerBodyStep"] for result in results]
    across = chart.LogScale(min(bodies) / 1.4, max(bodies) * 1.4, 80, 690)
    up = chart.LogScale(min(times) / 1.5, max(times) * 1.5, 420, 66)
    chart.axes(page, across, up, "bodies", "ns a body and step")
    for group, colour in zip(groups, chart.COLOURS):
        places = [across(one["bodies"]) for one in group]
        page.line(
            list(zip(places, [up(allowed(group[0], one)) for one in group])), colour, 1, "7 4"
        )
        points = list(zip(places, [up(one["nsPerBodyStep"]) for one in group]))
        page.line(points, colour, 2)
        for point in points:
            page.mark(*point, colour)
    for group, colour in zip(groups, chart.COLOURS):
        for one in group:
            point = across(one["bodies"]), up(one["nsPerBodyStep"])
            page.label(*point, f"{one['nsPerBodyStep']:.0f}", colour, sides=chart.ABOVE)
    names = [group[0]["scene"] for group in groups]
    page.legend(716, 80, list(zip(names, chart.COLOURS)))
    page.line([(706, 80 + 18 * len(names)), (726, 80 + 18 * len(names))], chart.INK, 1, "7 4")
    page.text(732, 84 + 18 * len(names), "n log n", size=12)
    page.write(path)


def growth_table(groups):
    lines = [
        "| scene | bodies | ns a body and step | ratio to n log n |",
        "|---|--:|--:|--:|",
    ]
    for group in groups:
        for one in group:
            share = one["nsPerBodyStep"] / allowed(group[0], one)
            lines.append(
                f"| {one['scene']} {one['size']} | {one['bodies']:,}"
                f" | {number(one['nsPerBodyStep'])} | {share:.2f} |"
            )
    return "\n".join(lines) + "\n"


def growth(chosen):
    """Measures growth with the default profile. Returns the table."""
    wanted = [name for name in GROWTH if not chosen.scenes or name in chosen.scenes]
    if not wanted:
        return ""
    jobs = [[["--scene", name, "--size", size] for size in GROWTH[name]] for name in wanted]
    groups = measure.run_in_turn(jobs, min(chosen.repeat, 3))
    measure.write_csv(OUT / "growth.csv", [result for group in groups for result in group])
    draw_growth(groups, OUT / "growth.svg")
    return growth_table(groups)


def scenes_of(chosen):
    """The named scenes; without names all, the loads only beside Box2D 3."""
    if chosen.scenes:
        return [scene for scene in SCENES + LOADS if scene.name in chosen.scenes]
    return SCENES + LOADS if chosen.box2d3 else SCENES


def main():
    chosen = options()
    measure.stay_on_one_core()
    scenes = scenes_of(chosen)
    if chosen.box2d3:
        box2d3.compare(scenes, chosen.repeat, OUT)
        return 0
    jobs = [jobs_of(scene.name, scene.size, chosen) for scene in scenes]
    results = [with_ratios(group) for group in measure.run_in_turn(jobs, chosen.repeat)]
    measure.write_csv(OUT / "bench.csv", [result for group in results for result in group])
    draw_ratios(scenes, results, OUT / "bench.svg")
    text = table(scenes, results)
    print(text)
    if chosen.growth:
        more = growth(chosen)
        print(more)
        text += "\n" + more
    (OUT / "bench.md").write_text(text, encoding="utf-8")
    print(f"Written: {', '.join(sorted(str(path) for path in OUT.iterdir()))}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
