# SPDX-License-Identifier: MIT
"""Run by tools/bench, which says what it does."""
import argparse
import math
import pathlib
import sys

import chart
import measure

OUT = pathlib.Path("build/bench")

# Scene, size, and what is wanted of the default profile: the ratio to Box2D at most, at a mean
# depth (mm) of at most. None: no limit.
SCENES = [
    ("pyramid", 60, 0.13, 1.2),
    ("pyramid", 100, 0.073, 7.5),
    ("circles", 5000, 0.092, 10),
    ("debris", 2000, 0.072, 12),
    ("tumbler", 2000, 0.036, 12),
    ("breakout", 200, 0.11, None),
    ("stack", 20, 0.23, None),
    ("massratio", 1000, None, None),
    ("rain", 1000, None, None),
    ("joints", 40, None, None),
    ("spinner", 1000, None, None),
    ("resting", 10000, None, None),
    ("smallroom", 1, None, None),
    ("empty", 1, None, None),
]
GROWTH = {"pyramid": (60, 120, 240), "circles": (5000, 20000, 80000), "debris": (2000, 8000, 32000)}


def options():
    parser = argparse.ArgumentParser(prog="tools/bench", add_help=False)
    parser.add_argument("--scenes", nargs="+", choices=sorted({scene[0] for scene in SCENES}))
    parser.add_argument("--engines", nargs="+", choices=["kodo", "kodo64"])
    parser.add_argument("--profiles", nargs="+", default=["default"])
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--no-growth", dest="growth", action="store_false")
    parser.add_argument("--quick", action="store_true")
    chosen = parser.parse_args()
    chosen.engines = chosen.engines or ["kodo", "kodo64"]
    if chosen.quick:
        chosen.repeat, chosen.growth = 1, False
    return chosen


def jobs_of(scene, size, chosen):
    """Box2D first, then every way of Kodo."""
    common = ["--scene", scene, "--size", size]
    ways = [["--engine", "box2d"]]
    for engine in chosen.engines:
        ways += [["--engine", engine, "--profile", profile] for profile in chosen.profiles]
    return [common + way for way in ways]


def with_ratios(results):
    """Adds the ratio of each result to the first, Box2D's, of the same scene."""
    for result in results:
        result["ratio"] = result["cpuMsPerStep"] / results[0]["cpuMsPerStep"]
    return results


def way_of(result):
    profile = result["profile"]
    return result["engine"] + ("" if profile == "default" else f" {profile}")


def number(value, digits=3):
    """Three digits that count, and no exponent."""
    if value is None:
        return ""
    if value == 0:
        return "0"
    places = max(digits - 1 - math.floor(math.log10(abs(value))), 0)
    return f"{value:,.{places}f}"


def table(scenes, results):
    lines = [
        "| scene | bodies | engine | ms a step | spread | ns a body and step | ratio | wanted"
        " | depth max / mean mm | stood | escaped | error |",
        "|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|---|",
    ]
    for (name, size, wanted, depth), group in zip(scenes, results):
        for result in group:
            mine = way_of(result) == "kodo"
            limit = f"{wanted:g}" if mine and wanted else ""
            limit += f" at {depth:g} mm" if limit and depth else ""
            error = f"{result['errorName']} {number(result['error'])} {result['errorUnit']}"
            lines.append(
                f"| {name} {size} | {result['bodies']:,} | {way_of(result)}"
                f" | {number(result['cpuMsPerStep'])} | {100 * result['spread']:.0f} %"
                f" | {number(result['nsPerBodyStep']) if result['bodies'] else ''}"
                f" | {number(result['ratio'])} | {limit}"
                f" | {number(result['depthMaxMm'])} / {number(result['depthMeanMm'])}"
                f" | {result['stood']:,} | {'' if result['escaped'] is None else result['escaped']}"
                f" | {error if result['error'] is not None else ''} |"
            )
    return "\n".join(lines) + "\n"


def draw_ratios(scenes, results, path):
    """A bar for each way in each scene, from 1 (as long as Box2D) to its ratio."""
    ways = [way_of(result) for result in results[0][1:]]
    bar, gap, top = 13, 14, 76
    height = top + len(scenes) * (bar * len(ways) + gap) + 60
    page = chart.Page(860, height, "CPU time of a step, as a ratio to Box2D 2.4.1 (short is fast)")
    for i, way in enumerate(ways):
        page.legend(20 + 150 * i, 52, [(way, chart.COLOURS[i])])
    ratios = [result["ratio"] for group in results for result in group]
    across = chart.LogScale(min(0.01, *ratios), max(2, *ratios), 150, 800)
    up = height - 44
    for value in across.ticks():
        page.line([(across(value), up), (across(value), top - 6)], chart.FAINT)
        page.text(across(value), up + 16, f"{value:g}", "middle", 11)
    for i, ((name, size, wanted, _), group) in enumerate(zip(scenes, results)):
        y = top + i * (bar * len(ways) + gap)
        page.text(142, y + bar * len(ways) / 2 + 4, f"{name} {size}", "end")
        for k, result in enumerate(group[1:]):
            end = across(result["ratio"])
            page.bar(across.start, y + k * bar, end - across.start, bar - 2, chart.COLOURS[k])
            page.text(end + 4, y + k * bar + 9, number(result["ratio"]), size=10)
        if wanted:
            x = across(wanted)
            page.line([(x, y - 3), (x, y + bar * len(ways) + 1)], "#cf222e", 2)
    page.line([(across(1), up), (across(1), top - 6)], chart.INK, 1.5)
    page.text(across.start, up + 34, "red: wanted; black line: as long as Box2D", size=11)
    page.write(path)


def draw_growth(groups, path):
    """ns a body and step over the number of bodies; dashed: n log n from the smallest."""
    page = chart.Page(760, 460, "Cost of a body and step as scenes grow")
    results = [result for group in groups for result in group]
    bodies = [result["bodies"] for result in results]
    times = [result["nsPerBodyStep"] for result in results]
    across = chart.LogScale(min(bodies) / 1.2, max(bodies) * 1.2, 80, 600)
    up = chart.LogScale(min(times) / 1.5, max(times) * 1.5, 400, 50)
    chart.axes(page, across, up, "bodies", "ns a body and step")
    names = []
    for i, group in enumerate(groups):
        colour = chart.COLOURS[i % len(chart.COLOURS)]
        for engine in dict.fromkeys(result["engine"] for result in group):
            mine = [result for result in group if result["engine"] == engine]
            points = [(across(one["bodies"]), up(one["nsPerBodyStep"])) for one in mine]
            page.line(points, colour, 2, "" if engine == "kodo" else "2 4")
            for point in points:
                page.dot(*point, 4, colour, hollow=engine != "kodo")
            if engine == "kodo":
                first = mine[0]
                grown = [
                    first["nsPerBodyStep"] * math.log(one["bodies"]) / math.log(first["bodies"])
                    for one in mine
                ]
                line = [(across(one["bodies"]), up(time)) for one, time in zip(mine, grown)]
                page.line(line, colour, 1, "7 4")
        names.append((group[0]["scene"], colour))
    page.legend(616, 70, names)
    page.text(610, 140, "full: kodo", size=11)
    page.text(610, 156, "dotted, hollow: Box2D", size=11)
    page.text(610, 172, "dashed: n log n", size=11)
    page.write(path)


def growth(chosen, repeat):
    wanted = [name for name in GROWTH if not chosen.scenes or name in chosen.scenes]
    jobs = []
    for name in wanted:
        for size in GROWTH[name]:
            common = ["--scene", name, "--size", size]
            jobs.append([common + ["--engine", "box2d"], common + ["--engine", "kodo"]])
    results = measure.run_in_turn(jobs, repeat)
    flat = [result for group in results for result in group]
    groups = [[result for result in flat if result["scene"] == name] for name in wanted]
    if groups:
        measure.write_csv(OUT / "growth.csv", flat)
        draw_growth(groups, OUT / "growth.svg")


def main():
    chosen = options()
    measure.stay_on_one_core()
    scenes = [scene for scene in SCENES if not chosen.scenes or scene[0] in chosen.scenes]
    jobs = [jobs_of(name, size, chosen) for name, size, *_ in scenes]
    results = [with_ratios(group) for group in measure.run_in_turn(jobs, chosen.repeat)]
    measure.write_csv(OUT / "bench.csv", [result for group in results for result in group])
    text = table(scenes, results)
    (OUT / "bench.md").write_text(text, encoding="utf-8")
    draw_ratios(scenes, results, OUT / "bench.svg")
    print(text)
    if chosen.growth:
        growth(chosen, min(chosen.repeat, 3))
    print(f"Written: {', '.join(sorted(str(path) for path in OUT.iterdir()))}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
