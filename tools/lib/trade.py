# SPDX-License-Identifier: MIT
"""Run by tools/trade, which says what it does."""
import argparse
import math
import pathlib
import sys

import chart
import measure

OUT = pathlib.Path("build/trade")

# Scenes with an error measure, small enough that all settings are through in minutes.
SCENES = {
    "pyramid": 30,
    "circles": 1000,
    "debris": 500,
    "tumbler": 500,
    "breakout": 200,
    "stack": 20,
    "massratio": 1000,
    "joints": 20,
    "spinner": 300,
    "forces": 10,
    "slide": 1,
    "bounce": 1,
    "pendulum": 1,
}
LEAST_ERROR = 1e-7  # a share, mm or %: below that, rounding is all that is left
FEATURES = ("friction", "rolling", "restitution", "sweep", "records")

# Family: (colour, hollow?). A family is what one question sweeps over.
FAMILIES = {
    "substeps": ("#1f6feb", False),
    "stiffness": ("#1f6feb", True),
    "profile": ("#8250df", False),
    "double": ("#2da44e", False),
    "left out": ("#2da44e", True),
    "thesis": ("#bf3989", False),
    "box2d": ("#d1570b", False),
}


def settings():
    """(family, label, arguments) of every way of stepping."""
    ways = [("substeps", f"{n}", ["--substeps", n]) for n in (1, 2, 3, 4, 6, 8, 12, 16, 32)]
    ways += [
        ("stiffness", f"{n} at {hertz} Hz", ["--substeps", n, "--contact-hertz", hertz])
        for n, hertz in ((4, 30), (8, 30), (8, 120), (16, 120), (16, 240), (32, 480))
    ]
    ways += [("profile", name, ["--profile", name]) for name in ("default", "quick", "accurate")]
    double = ["--engine", "kodo64", "--substeps"]
    ways += [("double", f"{n}, double", [*double, n]) for n in (1, 2, 4, 8, 16)]
    ways += [("left out", f"no {name}", ["--leave-out", name]) for name in FEATURES]
    ways += [
        ("thesis", f"thesis {n}", ["--profile", "thesis", "--passes", n]) for n in (4, 10, 20, 40)
    ]
    box2d = ["--engine", "box2d", "--passes"]
    ways += [("box2d", f"{n} / 3", [*box2d, n]) for n in (1, 2, 4, 8, 16, 32, 64)]
    ways.append(("box2d", "8 / 10", ["--engine", "box2d", "--position-passes", 10]))
    return ways


def options():
    parser = argparse.ArgumentParser(prog="tools/trade", add_help=False)
    parser.add_argument("--scenes", nargs="+", choices=list(SCENES), default=list(SCENES))
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--quick", action="store_true")
    chosen = parser.parse_args()
    if chosen.quick:
        chosen.repeat = 1
    return chosen


def error_of(result):
    """None: it could not be measured, as where bodies are no longer anywhere."""
    return None if result["error"] is None else max(result["error"], LEAST_ERROR)


def front_of(results):
    """What no other setting beats in both time and error, from fast to true."""
    front = []
    for result in sorted(results, key=lambda one: (one["cpuMsPerStep"], error_of(one))):
        if not front or error_of(result) < error_of(front[-1]):
            front.append(result)
    return front


def is_beaten(result, others):
    """Is there one that is both faster and truer, by more than the noise of a measurement?"""
    return any(
        1.05 * one["cpuMsPerStep"] < result["cpuMsPerStep"]
        and 1.02 * error_of(one) < error_of(result)
        for one in others
    )


def knee_of(front):
    """Where more time begins to buy less: the point of the front that lies farthest below the line
    between its ends, both axes in powers of ten and as wide as the front is."""
    times = [math.log(one["cpuMsPerStep"]) for one in front]
    errors = [math.log(error_of(one)) for one in front]
    width, height = times[-1] - times[0], errors[0] - errors[-1]
    if len(front) < 3:
        return front[-1]
    gains = [
        1 - (time - times[0]) / width - (error - errors[-1]) / height
        for time, error in zip(times, errors)
    ]
    return front[gains.index(max(gains))]


def draw(scene, results, front, knee, path):
    page = chart.Page(900, 560, f"{scene}: {results[0]['errorName']} against CPU time")
    times = [1e3 * result["cpuMsPerStep"] for result in results]
    errors = [error_of(result) for result in results]
    across = chart.LogScale(min(times) / 1.3, max(times) * 1.3, 90, 740)
    up = chart.LogScale(min(errors) / 1.6, max(errors) * 1.6, 490, 50)
    unit = results[0]["errorUnit"] or "share"
    chart.axes(page, across, up, "microseconds a step", f"{results[0]['errorName']} ({unit})")

    def place(result):
        return across(1e3 * result["cpuMsPerStep"]), up(error_of(result))

    page.line([place(result) for result in front], chart.INK, 1.5, "5 3")
    for result in results:
        colour, hollow = FAMILIES[result["family"]]
        hint = f"{result['label']}: {result['cpuMsPerStep'] * 1e3:.3g} us, {result['error']:.3g}"
        page.dot(*place(result), 5, colour, hollow, hint)
        if result in front or result["family"] in ("substeps", "box2d"):
            x, y = place(result)
            page.text(x + 7, y - 6, result["label"], size=10, colour=colour)
    x, y = place(knee)
    page.dot(x, y, 10, "#cf222e", True)
    page.dot(x, y, 5, FAMILIES[knee["family"]][0], FAMILIES[knee["family"]][1], knee["label"])
    for i, (name, (colour, hollow)) in enumerate(FAMILIES.items()):
        page.dot(762, 70 + 20 * i, 5, colour, hollow)
        page.text(774, 74 + 20 * i, name)
    page.line([(756, 220), (768, 220)], chart.INK, 1.5, "5 3")
    page.text(774, 224, "front")
    page.dot(762, 240, 8, "#cf222e", True)
    page.text(774, 244, "its knee")
    page.write(path)


def front_table(scene, front, knee, ours):
    """What a user reads: from fast to true, the front of Kodo's settings."""
    lines = [
        f"\n**{scene}**: {front[0]['errorName']}\n",
        "| setting | us a step | error | |",
        "|---|--:|--:|---|",
    ]
    for result in front:
        mark = "knee" if result is knee else ""
        lines.append(
            f"| {result['family']}: {result['label']} | {1e3 * result['cpuMsPerStep']:.3g}"
            f" | {result['error']:.3g} {result['errorUnit']} | {mark} |"
        )
    default = next(one for one in ours if one["label"] == "default")
    if is_beaten(default, ours):
        lines.append(
            f"| profile: default | {1e3 * default['cpuMsPerStep']:.3g}"
            f" | {default['error']:.3g} {default['errorUnit']} | not on the front |"
        )
    return "\n".join(lines) + "\n"


def main():
    chosen = options()
    measure.stay_on_one_core()
    ways = settings()
    jobs = [
        [["--scene", scene, "--size", SCENES[scene], *arguments] for _, _, arguments in ways]
        for scene in chosen.scenes
    ]
    rows, text = [], ""
    for scene, results in zip(chosen.scenes, measure.run_in_turn(jobs, chosen.repeat)):
        for (family, label, _), result in zip(ways, results):
            result["family"], result["label"] = family, label
        measured = [result for result in results if error_of(result) is not None]
        ours = [result for result in measured if result["engine"] != "box2d"]
        front = front_of(ours)
        knee = knee_of(front)
        for result in measured:
            result["onFront"], result["isKnee"] = result in front, result is knee
        draw(scene, measured, front, knee, OUT / f"{scene}.svg")
        text += front_table(scene, front, knee, ours)
        rows += results
    measure.write_csv(OUT / "trade.csv", rows)
    (OUT / "trade.md").write_text(text, encoding="utf-8")
    print(text)
    print(f"Written: {', '.join(sorted(str(path) for path in OUT.iterdir()))}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
