# SPDX-License-Identifier: MIT
"""The comparison of tools/bench --box2d3: Kodo beside Box2D 3, scene by scene."""
import argparse
import pathlib

import measure
from measure import number

# Substeps of Box2D 3 for equal depth. It caps the stiffness of contacts, so that more substeps
# alone change no depth: contactHertz is raised to the cap, an eighth of the substep rate.
SUBSTEPS = (4, 8, 16, 32)
DEEPER = 1.1  # overlap that counts as equal, relative to that of Kodo
STEP_RATE = 60  # 1/s


def folder(text):
    """Value of --box2d3: a folder with an installed Box2D 3, as an absolute path."""
    path = pathlib.Path(text).resolve()
    if not (path / "include/box2d/id.h").is_file():
        raise argparse.ArgumentTypeError(f"no installed Box2D 3 in {text}")
    return path


def way_of(substeps):
    """Arguments of kodo-bench for Box2D 3 with contacts as stiff as it allows."""
    return ["--engine", "box2d3", "--substeps", substeps,
            "--set", f"contactHertz={STEP_RATE * substeps / 8:g}"]


def equal_depth(common, run):
    """The least number of substeps for an overlap of the size of Kodo's. None if the scene does not
    measure overlap, or if no number suffices."""
    kodo = run(common)
    if kodo["errorName"] != "depth, mean":
        return None
    for substeps in SUBSTEPS:
        if run(common + way_of(substeps))["error"] <= DEEPER * kodo["error"]:
            return substeps
    return None


def jobs_of(scene, run):
    """(arguments of each engine, substeps for equal depth or None)"""
    common = ["--scene", scene.name, "--size", scene.size]
    jobs = [common, common + ["--engine", "box2d3"]]
    substeps = equal_depth(common, run)
    if substeps and substeps > SUBSTEPS[0]:  # else the defaults do
        jobs.append(common + way_of(substeps))
    return jobs, substeps


def row_of(scene, group, substeps):
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
        f"{ratio('cpuMsPerStep', group[-1])} ({substeps})" if substeps else "",
        pair("worstStepMs") if kodo["worstStepMs"] else "",
        ratio("worstStepMs", other),
        pair("depthMeanMm"),
        f"{kodo['errorName']}: {pair('error')} {kodo['errorUnit']}" if kodo["errorName"] else "",
        pair("escaped") if kodo["escaped"] is not None else "",
        f"{100 * kodo['spread']:.0f} / {100 * other['spread']:.0f}",
    ]
    return "| " + " | ".join(fields) + " |"


HEAD = """| scene | bodies | ms a step, Kodo / Box2D 3 | ratio | ratio at equal depth (substeps) \
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
            jobs, substeps = jobs_of(scene, measure.run_once)
            group = measure.run_in_turn([jobs], repeat)[0]
            row = row_of(scene, group, substeps)
            print(row, flush=True)
            page.write(row + "\n")
            page.flush()
            rows += group
    measure.write_csv(out / "box2d3.csv", rows)
    print(f"\nWritten: {out / 'box2d3.csv'}, {out / 'box2d3.md'}")
