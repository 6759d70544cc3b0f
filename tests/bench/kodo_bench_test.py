#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Command-line tests of kodo-bench: kodo_bench_test.py PATH-OF-KODO-BENCH"""
import json
import resource
import subprocess
import sys

WANTED = (
    "scene engine profile bodies steps cpuMsPerStep nsPerBodyStep depthMaxMm depthMeanMm escaped"
    " stood kineticEnergyJ stateHash bytesPerBody"
).split()


def run(*arguments):
    return subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True, check=False)


def bench(*arguments):
    """(exit code, stdout)"""
    done = run(*arguments)
    return done.returncode, done.stdout


def check(holds, what):
    if not holds:
        sys.exit(f"kodo-bench: {what}")


SCENES = (
    "pyramid circles debris tumbler breakout stack massratio rain joints spinner asleep shots tiles rays churn empty"
    " columns pushed removals particles events contacts heavypair slab plank pairs balls ragdolls"
    " chains shortchains bridge bridgecars hub arm crane wheel cars ring shards sparks smash crowdpoint"
).split()
code, text = bench("--list")
check(code == 0, f"--list ends with {code}")
listed = [line.split()[0] for line in text.splitlines() if not line.startswith(" ")]
missing = [name for name in SCENES if name not in listed]
check(not missing, f"--list does not name {missing}")

choice = ("--scene", "pyramid", "--size", "5", "--steps", "20", "--json")
code, text = bench(*choice, "--repeat", "3", "--against", "box2d", "--stages", "--peak")
check(code == 0, f"a good run ends with {code}")
kodo, box2d = (json.loads(line) for line in text.splitlines())
for result in (kodo, box2d):
    missing = [name for name in WANTED if name not in result]
    check(not missing, f"no {missing} in {result}")
    check(result["bodies"] == 15 and result["steps"] == 20, f"another scene: {result}")
    check(result["cpuMsPerStep"] > 0 and result["runs"] == 3, f"no times: {result}")
    stages = result["stagesMsPerStep"]
    check(stages and min(stages.values()) >= 0, f"no times of stages: {stages}")
    # Same clock and same run: the sum of the stages cannot exceed the whole step.
    check(sum(stages.values()) <= 1.000001 * result["cpuMsPerStep"], f"stages take more: {result}")
check((kodo["engine"], box2d["engine"]) == ("kodo", "box2d"), "engines out of order")
check(abs(kodo["ratio"] - kodo["cpuMsPerStep"] / box2d["cpuMsPerStep"]) < 1e-9, "wrong ratio")

wanted = {"substeps": 3, "steps": 4, "size": 6, "seed": 7, "threads": 1}
words = [word for name, value in wanted.items() for word in (f"--{name}", str(value))]
for engine in ("kodo", "kodo64"):
    code, text = bench("--scene", "debris", "--engine", engine, "--profile", "fast", "--json", *words)
    check(code == 0, f"{words} ends with {code}")
    printed = json.loads(text)
    wanted |= {"scene": "debris", "engine": engine, "profile": "fast", "bodies": 6}
    check(wanted.items() <= printed.items(), f"wanted {wanted}, printed {printed}")
    # At most 100 bytes per row in float.
    rows = printed["bytesPerContactRow"]
    check(0 < rows <= (120 if engine == "kodo" else 232), f"rows: {printed}")
    check(printed["bytesPerContact"] > printed["bytesPerContactRow"], f"contacts: {printed}")
    bytes_printed = printed["bytesPerBody"]  # None without a count, as under a sanitizer
    check(bytes_printed is None or bytes_printed > 50, f"bytes of bodies: {printed}")

done = run(*choice, "--engine", "box2d3", "--substeps", "8")
if done.returncode:
    check(done.returncode == 2 and "KODO_BENCH_BOX2D3=" in done.stderr, f"no way to box2d3: {done}")
else:
    printed = json.loads(done.stdout)
    step = (printed["engine"], printed["bodies"], printed["substeps"])
    check(step == ("box2d3", 15, 8), f"printed {printed}")

code, text = bench(*choice)
check(json.loads(text)["stateHash"] == kodo["stateHash"], "another state in another process")

code, text = bench(*choice, "--worst")
printed = json.loads(text)
check(printed["worstStepMs"] >= printed["cpuMsPerStep"], f"worst step: {printed}")
check(kodo["worstStepMs"] is None, f"a worst step that was not measured: {kodo}")

for threads in ("1", "2"):
    code, text = bench("--scene", "debris", "--size", "6", "--steps", "4", "--threads", threads)
    printed = "ms on the wall" in text
    check(code == 0 and printed == (threads == "2"), f"{threads} threads: {text}")

# The text names each figure, and leaves out what has no meaning in the scene.
text = bench("--scene", "pyramid", "--size", "5", "--steps", "20")[1]
for words in ("kodo balanced: ", "overlaps, largest", "kinetic energy", "15 of 15 bodies have kept their places"):
    check(words in text, f"the text has no '{words}': {text}")
text = bench("--scene", "slide", "--profile", "balanced")[1]
check("places" not in text and "stop distance: " in text and " %\n" in text, f"slide: {text}")
text = bench("--scene", "pyramid", "--size", "5", "--steps", "2", "--engine", "box2d")[1]
check(", box2d: " in text, f"Box2D has a profile: {text}")

for wrong in (["--scene", "nowhere"], ["--engine", "nothing"], ["--threads", "0"],
              ["--substeps", "0"], ["--seed", "-1"], ["--nonesuch"], ["--set", "mass=3"],
              ["--set", "contactHertz=abc"], ["--against-profile", "fast"]):
    done = run(*wrong)
    check(done.returncode == 2 and not done.stdout, f"{wrong} ends with {done.returncode}, not 2")
    word = wrong[0] if wrong[0].startswith("--against") else wrong[-1]
    check(word in done.stderr, f"{wrong} is refused without a word of it: {done.stderr}")
    if wrong[1:] in (["0"], ["-1"]):
        check(wrong[0] in done.stderr, f"{wrong} is refused without its name: {done.stderr}")
check("NUMBER" in run("--set", "contactHertz=abc").stderr, "a wrong number is not reported as one")


def refuses(words, sentence):
    done = run(*words)
    check(done.returncode == 2 and not done.stdout, f"{words} ends with {done.returncode}, not 2")
    check(sentence in done.stderr, f"{words} is refused without '{sentence}': {done.stderr}")


THESIS = ["--profile", "thesis2006", "--set"]
for words, sentence in (
    (["--set", "mass=3"], "these are impactPasses, contactHertz"),
    ([*THESIS, "contactHertz=30"], "the solver of the profile thesis2006 has no contactHertz: it has"),
    (["--set", "contactPasses=4"], "the solver of the profile balanced has no contactPasses"),
    (["--set", "contactHertz=nan"], "contactHertz: nan is no finite number"),
    (["--set", "contactHertz=inf"], "contactHertz: inf is no finite number"),
    (["--set", "contactHertz=1e10"], "contactHertz: 1e10 is out of range: up to 1e9"),
    ([*THESIS, "contactPasses=2.5"], "contactPasses: 2.5 is no whole number"),
    (["--set", "contactHertz=60,contactHertz=30"], "--set: contactHertz is set twice"),
    (["--set", "contactHertz=60", "--set", "contactHertz=60"], "--set: contactHertz is set twice"),
    (["--engine", "box2d", "--snapshot"], "--snapshot: box2d has no snapshot"),
    (["--engine", "box2d", "--profile", "balanced"], "Box2D 2.4.1 takes passes"),
    (["--profile", "default"], "--profile"),
    (["--list", "--json"], "--list"),
    (["--list", "--scene", "pyramid"], "--list"),
):
    refuses(words, sentence)

# One name of the default profile; Box2D has none.
check((kodo["profile"], box2d["profile"]) == ("balanced", None), f"profiles: {kodo}, {box2d}")
code, text = bench(*choice, "--profile", "balanced")
check(json.loads(text)["stateHash"] == kodo["stateHash"], "balanced is not the default")
code, text = bench(*choice, "--snapshot", "--against", "box2d")
sizes = [json.loads(line)["snapshotBytes"] for line in text.splitlines()]
check(code == 0 and sizes[0] > 0 and sizes[1] is None, f"sizes of snapshots: {sizes}")


def limited(*arguments):
    """With 1 GB of addresses; a sanitizer needs more even to start."""
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
    return subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True, check=False,
                          preexec_fn=limit)


if limited("--list").returncode == 0:
    done = limited("--scene", "pyramid", "--size", "9000")
    check(done.returncode == 1, f"without memory it ends with {done.returncode}, not 1: {done}")
    check("the memory is not enough for --scene pyramid --size 9000" in done.stderr, f"{done}")
