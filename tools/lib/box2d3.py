# SPDX-License-Identifier: MIT
"""The comparison of tools/bench --box2d3: Kodo beside Box2D 3, scene by scene."""
import argparse
import pathlib
import typing

import measure
from measure import number

# Substeps of Box2D 3 for equal errors. It caps the stiffness, so that more substeps alone change
# little: both are raised to their caps, an eighth of the substep rate for contacts, a quarter for
# joints.
SUBSTEPS = (4, 8, 16, 32, 64)
LARGER = 1.1  # error that counts as equal, relative to that of Kodo
STEP_RATE = 60  # 1/s
# Errors that more substeps make smaller. Others depend on the scene as well.
ERRORS = ("depth, mean", "largest gap at a joint")


def folder(text):
    """Value of --box2d3: a folder with an installed Box2D 3, as an absolute path."""
    path = pathlib.Path(text).resolve()
    if not (path / "include/box2d/id.h").is_file():
        raise argparse.ArgumentTypeError(f"no installed Box2D 3 in {text}")
    return path


def way_of(substeps):
    """Arguments of kodo-bench for Box2D 3 with contacts and joints as stiff as it allows."""
    rate = STEP_RATE * substeps
    return ["--engine", "box2d3", "--substeps", substeps,
            "--set", f"contactHertz={rate / 8:g},jointHertz={rate / 4:g}"]


class Equal(typing.NamedTuple):
    """Settings of Box2D 3 for an error of the size of Kodo's."""

    substeps: int
    reached: bool  # False: not even the largest number of substeps suffices


def equal_error(common, run):
    """The least number of substeps for an error of the size of Kodo's. None if the scene does not
    measure overlap or gaps."""
    kodo = run(common)
    if kodo["errorName"] not in ERRORS:
        return None
    for substeps in SUBSTEPS:
        if run(common + way_of(substeps))["error"] <= LARGER * kodo["error"]:
            return Equal(substeps, True)
    return Equal(SUBSTEPS[-1], False)


def jobs_of(scene, run):
    """(arguments of each engine, Equal or None)"""
    common = ["--scene", scene.name, "--size", scene.size]
    jobs = [common, common + ["--engine", "box2d3"]]
    equal = equal_error(common, run)
    if equal and equal.substeps > SUBSTEPS[0]:  # else the defaults do
        jobs.append(common + way_of(equal.substeps))
    return jobs, equal


def equal_of(group, equal):
    """The cell of the ratio at equal error, with the number of substeps."""
    if not equal:
        return ""
    kodo, other = group[0], group[-1]
    ratio = number(kodo["cpuMsPerStep"] / other["cpuMsPerStep"])
    if equal.reached:
        return f"{ratio} ({equal.substeps})"
    return f"{ratio} ({equal.substeps}, not equal: {number(other['error'])} {other['errorUnit']})"


def row_of(scene, group, equal):
    kodo, other = group[:2]

    def pair(key):
        return " / ".join("-" if one[key] is None else number(one[key]) for one in (kodo, other))

    def ratio(key, than):
        return number(kodo[key] / than[key]) if kodo[key] and than[key] else ""

    fields = [
        f"{scene.name} {scene.size}",
        f"{kodo['bodies']:,}",
        pair("cpuMsPerStep"),
        ratio("cpuMsPerStep", other),
        equal_of(group, equal),
        pair("worstStepMs") if kodo["worstStepMs"] else "",
        ratio("worstStepMs", other),
        pair("depthMeanMm"),
        f"{kodo['errorName']}: {pair('error')} {kodo['errorUnit']}" if kodo["errorName"] else "",
        pair("escaped") if kodo["escaped"] is not None else "",
        f"{100 * kodo['spread']:.0f} / {100 * other['spread']:.0f}",
    ]
    return "| " + " | ".join(fields) + " |"


HEAD = """| scene | bodies | ms a step, Kodo / Box2D 3 | ratio | ratio at equal error (substeps) \
| longest step, ms | ratio | mean overlap, mm | error | escaped | spread, % |
|---|--:|--:|--:|--:|--:|--:|--:|---|--:|--:|
"""


def compare(scenes, repeat, out):
    """Prints and writes the table, row by row as the scenes are done."""
    out.mkdir(parents=True, exist_ok=True)
    rows = []
    with (out / "box2d3.md").open("w", encoding="utf-8") as page:
        page.write(HEAD)
        print(HEAD, end="")
        for scene in scenes:
            jobs, equal = jobs_of(scene, measure.run_once)
            group = measure.run_in_turn([jobs], repeat)[0]
            row = row_of(scene, group, equal)
            print(row, flush=True)
            page.write(row + "\n")
            page.flush()
            rows += group
    measure.write_csv(out / "box2d3.csv", rows)
    print(f"\nWritten: {out / 'box2d3.csv'}, {out / 'box2d3.md'}")
