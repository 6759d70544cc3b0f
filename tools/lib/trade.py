# SPDX-License-Identifier: MIT
"""Measurements of tools/trade; see its --help."""
import math
import pathlib
import shutil
import sys
import typing

import box2d3
import chart
import dials
import measure

OUT = pathlib.Path("build/trade")
DOCS = pathlib.Path("engine/docs")
PICTURES = ("pyramid",)  # of the scenes, in engine/docs


class Question(typing.NamedTuple):
    """A scene, small enough to run all settings within minutes, and the error measured in it."""

    name: str
    scene: str
    size: int
    lost: float  # error from which on the scene counts as lost, for example collapsed
    key: str = "error"  # of the results; default: the error of the scene
    says: str = ""  # name of another error
    unit: str = ""  # of another error


QUESTIONS = [
    Question("pyramid", "pyramid", 30, 100),
    Question("pyramid-drift", "pyramid", 30, 0.5, "driftSidewaysM", "drift sideways", "m"),
    Question("circles", "circles", 1000, 100),
    Question("debris", "debris", 500, 100),
    Question("tumbler", "tumbler", 500, 100),
    Question("breakout", "breakout", 200, 0.5),
    Question("stack", "stack", 20, 1000),
    Question("massratio", "massratio", 1000, 50),
    Question("joints", "joints", 20, 500),
    Question("spinner", "spinner", 300, 100),
    Question("forces", "forces", 10, 0.5),
    Question("slide", "slide", 1, 0.5),
    Question("bounce", "bounce", 1, 0.5),
    Question("pendulum", "pendulum", 1, 0.5),
]
# By unit: smaller errors are rounding and drawn as this value.
LEAST_ERROR = {"": 1e-6, "mm": 1e-3, "%": 1e-3, "m": 1e-6}
# Without sleep: no scene here contains sleeping bodies.
FEATURES = ("friction", "rolling", "restitution", "rotation", "continuous", "records")


class Family(typing.NamedTuple):
    """A group of settings, and its look in a figure."""

    colour: str
    form: str
    says: str
    joined: bool = False  # by a line: the settings are values of one parameter


BALANCED = "balanced"  # the default profile
FAMILIES = {  # no colour twice
    "substeps": Family("#1f6feb", "dot", "substeps", True),
    "stiffness": Family("#0a3069", "ring", "substeps at contactHertz"),
    "impacts": Family("#0aa2c0", "triangle", "impactPasses"),
    "profile": Family("#24292f", "diamond", "profiles"),
    "double": Family("#2da44e", "dot", "substeps, double precision", True),
    "left out": Family("#6b8e23", "square", "default without a feature"),
    "propagation": Family("#bf3989", "dot", "Propagation: contactPasses"),
    "shock": Family("#8250df", "triangle", "Propagation with shockPasses"),
    "box2d": Family("#d1570b", "square", "Box2D 2.4.1: velocity iterations / 3", True),
    "positions": Family("#ff9d7a", "triangle", "Box2D 2.4.1: 8 / position iterations"),
    "box2d3": Family("#e0a800", "square", "Box2D 3: substeps", True),
    "box2d3 stiff": Family("#7a4a1e", "ring", "Box2D 3: the same, contacts at rate / 8"),
}


# Shown for comparison, not part of the front. A feature that is left out is needed in other scenes.
FOREIGN = ("box2d", "positions", "box2d3", "box2d3 stiff", "left out")


def settings(has_v3=False):
    """(family, label, arguments) of every setting. `has_v3`: kodo-bench has Box2D 3."""
    ways = [("substeps", f"{n}", ["--substeps", n]) for n in (1, 2, 3, 4, 6, 8, 12, 16, 32)]
    ways += [
        ("stiffness", f"{n} at {hertz} Hz", ["--substeps", n, "--set", f"contactHertz={hertz}"])
        for n, hertz in ((4, 30), (8, 30), (8, 96), (16, 96), (16, 192), (32, 384))
    ]
    ways += [("impacts", f"{n} impacts", ["--set", f"impactPasses={n}"]) for n in (1, 4, 64)]
    ways += [("profile", name, ["--profile", name]) for name in (BALANCED, "fast", "accurate")]
    double = ["--engine", "kodo64", "--substeps"]
    ways += [("double", f"{n}", [*double, n]) for n in (1, 2, 4, 8, 16)]
    ways += [("left out", f"no {name}", ["--leave-out", name]) for name in FEATURES]
    thesis = ["--profile", "thesis2006", "--set"]
    ways += [
        ("propagation", f"{n}", [*thesis, f"contactPasses={n}"]) for n in (4, 10, 20, 40)
    ]
    ways += [
        ("shock", f"{n} + {n}", [*thesis, f"contactPasses={n},shockPasses={n}"]) for n in (4, 10)
    ]
    box2d = ["--engine", "box2d", "--passes"]
    ways += [("box2d", f"{n} / 3", [*box2d, n]) for n in (1, 2, 4, 8, 16, 32, 64)]
    positions = ["--engine", "box2d", "--position-passes"]
    ways += [("positions", f"8 / {n}", [*positions, n]) for n in (10, 30)]
    if has_v3:
        v3 = ["--engine", "box2d3", "--substeps"]
        ways += [("box2d3", f"v3: {n}", [*v3, n]) for n in (2, 4, 8, 16)]
        ways += [("box2d3 stiff", f"v3: {n} stiff", box2d3.way_of(n)) for n in (8, 16)]
    return ways


class Options(measure.Options):
    def check(self, chosen):
        measure.refuse_quick(self, chosen)
        if chosen.dials:
            for name in ("scenes", "repeat", "quick"):
                if getattr(chosen, name):
                    self.error(f"--dials has scenes and runs of its own: give no --{name}")


def options():
    parser = Options("tools/trade")
    names = [question.name for question in QUESTIONS]
    parser.add_argument("--scenes", nargs="+", choices=names)
    parser.add_argument("--repeat", type=measure.runs)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--box2d3", metavar="DIR", type=box2d3.folder)
    parser.add_argument("--dials", action="store_true")
    parser.add_argument("--docs", action="store_true")
    chosen = parser.parse_args()
    chosen.scenes = chosen.scenes or names
    chosen.repeat = 1 if chosen.quick else chosen.repeat or 3
    return chosen


def ask(question, ways, results):
    """The results with an error, extended by its name, its unit, family and label. A result has no
    error if positions are not finite."""
    answered = []
    for (family, label, _), result in zip(ways, results):
        result = dict(result, question=question.name, family=family, label=label)
        if question.key != "error":
            result["errorName"], result["errorUnit"] = question.says, question.unit
            result["error"] = result[question.key]
        if result["error"] is not None:
            result["lost"] = result["error"] >= question.lost
            answered.append(result)
    return answered


def error_of(result):
    return max(result["error"], LEAST_ERROR[result["errorUnit"]])


def front_of(results):
    """The Pareto front: results that no other one beats in both time and error, by time. Gains in
    error below 1 % do not count. Empty if all settings have lost the scene."""
    front = []
    holding = [result for result in results if not result["lost"]]
    for result in sorted(holding, key=lambda one: (one["cpuMsPerStep"], error_of(one))):
        if not front or error_of(result) < 0.99 * error_of(front[-1]):
            front.append(result)
    return front


def is_beaten(result, others):
    """True if another result is both faster and more accurate, beyond the noise."""
    return result["lost"] or any(
        1.05 * one["cpuMsPerStep"] < result["cpuMsPerStep"]
        and 1.02 * error_of(one) < error_of(result)
        for one in others
    )


def knee_of(front):
    """The point of diminishing returns: the point of the front farthest below the line between its
    ends. Both axes are logarithmic and scaled to the extent of the front."""
    if len(front) < 3:
        return None  # a line has no knee
    times = [math.log(one["cpuMsPerStep"]) for one in front]
    errors = [math.log(error_of(one)) for one in front]
    width, height = times[-1] - times[0], errors[0] - errors[-1]
    gains = [
        1 - (time - times[0]) / width - (error - errors[-1]) / height
        for time, error in zip(times, errors)
    ]
    return front[gains.index(max(gains))]


def heading(page, first):
    runs = f"medians of {first['runs']} runs in turn" if first["runs"] > 1 else "one run"
    page.text(
        16,
        46,
        f"{first['bodies']} bodies, {first['steps']} steps of 1/60 s; CPU time of one thread, {runs}."
        " Lower left is better.",
        colour="#57606a",
    )


def legend(page, x, y, shown):
    for name, family in FAMILIES.items():
        if name not in shown:
            continue
        if family.joined:
            page.line([(x - 10, y), (x + 10, y)], family.colour, 1)
        page.mark(x, y, family.colour, family.form)
        page.text(x + 16, y + 4, family.says)
        y += 21
    page.line([(x - 10, y + 12), (x + 10, y + 12)], chart.INK, 1.5, "5 3")
    page.text(x + 16, y + 16, "Pareto front: not beaten by any setting of Kodo")
    page.ring(x, y + 33, 8, "#cf222e")
    page.text(x + 16, y + 37, "point of diminishing returns")
    page.mark(x, y + 54, "#8c959f", "cross")
    page.text(x + 16, y + 58, "scene lost")


def draw(results, front, knee, path):
    first = results[0]
    title = f"{first['scene']} {first['size']}: {first['errorName']} against CPU time"
    page = chart.Page(1060, 600, title)
    heading(page, first)
    # What is lost stretches no axis: it is drawn at the border.
    holding = [result for result in results if not result["lost"]] or results
    times = [1e3 * result["cpuMsPerStep"] for result in holding]
    errors = [error_of(result) for result in results if not result["lost"]] or [1]
    across = chart.LogScale(min(times) / 1.3, max(times) * 1.3, 90, 770)
    up = chart.LogScale(min(errors) / 1.6, max(errors) * 2, 540, 66)
    unit = first["errorUnit"] or "relative"
    chart.axes(page, across, up, "microseconds a step", f"{first['errorName']} ({unit})")
    legend(page, 796, 80, {result["family"] for result in results})
    page.room = (across.start + 2, up.end - 8, across.end + 16, up.start - 2)

    def place(result):
        return across(1e3 * result["cpuMsPerStep"]), up(error_of(result))

    for name, family in FAMILIES.items():
        mine = [one for one in results if one["family"] == name and not one["lost"]]
        if family.joined:
            page.line([place(result) for result in mine], family.colour, 0.8)
    page.line([place(result) for result in front], chart.INK, 1.5, "5 3")
    last = sorted(results, key=lambda one: one["label"] == BALANCED)  # drawn on top
    for result in last:
        family = FAMILIES[result["family"]]
        hint = (
            f"{family.says}, {result['label']}: {result['cpuMsPerStep'] * 1e3:.3g} us,"
            f" {result['error']:.3g} {result['errorUnit']}"
        )
        lost = ("#8c959f", "cross") if result["lost"] else (family.colour, family.form)
        size = 7 if result["label"] == BALANCED else 5
        page.mark(*place(result), *lost, size, hint)
    if knee:
        page.ring(*place(knee), 11, "#cf222e")
    important = [one for one in results if one["label"] == BALANCED]
    for result in [*important, *front, *results]:
        if "labelled" not in result:
            result["labelled"] = True
            bold = "bold" if result in important else "normal"
            page.label(*place(result), result["label"], FAMILIES[result["family"]].colour, bold)
    for result in results:
        del result["labelled"]
    page.write(path)


def row_of(result, remark):
    return (
        f"| {result['family']}: {result['label']} | {1e3 * result['cpuMsPerStep']:.3g}"
        f" | {result['error']:.3g} {result['errorUnit']} | {remark} |"
    )


def front_table(front, knee, ours):
    """Table of the front by time, and of the default."""
    lines = [
        f"\n**{ours[0]['scene']}**: {ours[0]['errorName']}\n",
        "| setting | us a step | error | |",
        "|---|--:|--:|---|",
    ]
    lines += [row_of(result, "knee" if result is knee else "") for result in front]
    default = next(one for one in ours if one["label"] == BALANCED)
    if default not in front:
        beaten = is_beaten(default, ours)
        remark = "**lost**" if default["lost"] else "**not on the front**"
        lines.append(row_of(default, remark if beaten else "as good as the front"))
    return "\n".join(lines) + "\n"


def verdict_of(question, ours):
    """Says whether any setting is both faster and more accurate than the default."""
    default = next(one for one in ours if one["label"] == BALANCED)
    if default["lost"]:
        return f"- {question.name}: **lost**, {default['error']:.3g} {default['errorUnit']}"
    beaters = [one for one in ours if not one["lost"] and is_beaten(default, [one])]
    if not beaters:
        return f"- {question.name}: nothing is both faster and more accurate"
    best = min(beaters, key=lambda one: one["cpuMsPerStep"])
    time = best["cpuMsPerStep"] / default["cpuMsPerStep"]
    return (
        f"- {question.name}: {best['family']} {best['label']} takes {time:.2f} of the time and has"
        f" an error of {best['error']:.3g} instead of {default['error']:.3g} {best['errorUnit']}"
    )


def main():
    chosen = options()
    if chosen.dials:
        dials.draw(DOCS if chosen.docs else OUT)
        return 0
    measure.stay_on_one_core()
    ways = settings(chosen.box2d3 is not None)
    questions = [question for question in QUESTIONS if question.name in chosen.scenes]
    scenes = list(dict.fromkeys((question.scene, question.size) for question in questions))
    jobs = [
        [["--scene", scene, "--size", size, *arguments] for _, _, arguments in ways]
        for scene, size in scenes
    ]
    measured = dict(zip(scenes, measure.run_in_turn(jobs, chosen.repeat)))
    rows, text, verdicts = [], "", ["\n**The default profile**\n"]
    for question in questions:
        results = ask(question, ways, measured[question.scene, question.size])
        ours = [result for result in results if result["family"] not in FOREIGN]
        front = front_of(ours)
        knee = knee_of(front)
        for result in results:
            result["onFront"], result["isKnee"] = result in front, result is knee
        draw(results, front, knee, OUT / f"{question.name}.svg")
        text += front_table(front, knee, ours)
        verdicts.append(verdict_of(question, ours))
        rows += results
    if chosen.docs:
        dials.draw(DOCS)
        for name in set(chosen.scenes) & set(PICTURES):
            shutil.copy(OUT / f"{name}.svg", DOCS / f"tuning-{name}.svg")
    text += "\n".join(verdicts) + "\n"
    measure.write_csv(OUT / "trade.csv", rows)
    (OUT / "trade.md").write_text(text, encoding="utf-8")
    print(text)
    print(f"Written: {', '.join(sorted(str(path) for path in OUT.iterdir()))}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
