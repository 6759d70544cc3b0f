#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program itself, from the outside: kodo_bench_test.py PATH-OF-KODO-BENCH"""
import json
import subprocess
import sys

WANTED = (
    "scene engine profile bodies steps cpuMsPerStep nsPerBodyStep depthMaxMm depthMeanMm escaped"
    " stood kineticEnergyJ stateHash"
).split()


def bench(*arguments):
    """(exit code, stdout)"""
    done = subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def check(holds, what):
    if not holds:
        sys.exit(f"kodo-bench: {what}")


code, text = bench("--list")
check(code == 0 and "pyramid" in text, "--list names no scenes")

choice = ("--scene", "pyramid", "--size", "5", "--steps", "20", "--json")
code, text = bench(*choice, "--repeat", "3", "--against", "box2d", "--stages", "--peak")
check(code == 0, f"a good run ends with {code}")
kodo, box2d = (json.loads(line) for line in text.splitlines())
for result in (kodo, box2d):
    missing = [name for name in WANTED if name not in result]
    check(not missing, f"no {missing} in {result}")
    check(result["bodies"] == 15 and result["steps"] == 20, f"another scene: {result}")
    check(result["cpuMsPerStep"] > 0 and result["runs"] == 3, f"no times: {result}")
    check(result["stagesMsPerStep"], "no stages")
check((kodo["engine"], box2d["engine"]) == ("kodo", "box2d"), "engines out of order")
check(abs(kodo["ratio"] - kodo["cpuMsPerStep"] / box2d["cpuMsPerStep"]) < 1e-9, "wrong ratio")

code, text = bench(*choice)
check(json.loads(text)["stateHash"] == kodo["stateHash"], "another state in another process")

for wrong in (["--scene", "nowhere"], ["--engine", "nothing"], ["--threads", "0"], ["--nonesuch"]):
    code, text = bench(*wrong)
    check(code == 2 and not text, f"{wrong} ends with {code}, not 2")
