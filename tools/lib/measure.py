# SPDX-License-Identifier: MIT
"""What tools/bench and tools/trade share: kodo-bench run in turn on one core, and its medians."""
import argparse
import csv
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

import options

BENCH = pathlib.Path("build/release/bin/kodo-bench")


class Options(options.Options):
    """Those of a shell script, which has its --help, and asks first whether they are right."""

    def __init__(self, prog):
        super().__init__(prog, add_help=False)
        self.add_argument("--check-options", action="store_true")

    def parse_args(self, args=None, namespace=None):
        chosen = super().parse_args(args, namespace)
        if chosen.check_options:
            sys.exit(0)
        return chosen


def runs(text):
    """What --repeat takes."""
    count = int(text) if text.isdecimal() else 0
    if not 1 <= count <= 1000:
        raise argparse.ArgumentTypeError(f"{text} is no number from 1 to 1000")
    return count


class Progress:
    """One line on stderr that is overwritten; silent unless that is a terminal."""

    def __init__(self, total):
        self.total, self.done, self.started = total, 0, time.monotonic()

    def show(self, words):
        if sys.stderr.isatty():
            spent = time.monotonic() - self.started
            left = spent / max(self.done, 1) * (self.total - self.done)
            count = f"{self.done}/{self.total}" + (f", {left:.0f} s left" if self.done else "")
            print(f"\r\033[K{count}  {words}", end="", file=sys.stderr)
            sys.stderr.flush()

    def step(self):
        self.done += 1

    def end(self):
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr)


def stay_on_one_core():
    """The last one: the first is where most systems handle their interrupts."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


def run_once(arguments):
    """One run of kodo-bench: its JSON object, or a SystemExit that says what it said."""
    words = [str(BENCH), "--json", *map(str, arguments)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(words)} ended with {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def run_in_turn(jobs, repeat):
    """jobs: groups of lists of arguments. Those of one group are run in turn, `repeat` times, since
    a machine is not as fast at one moment as at another. Returns groups of what summary_of makes
    of the runs of each."""
    progress = Progress(repeat * sum(map(len, jobs)))
    results = []
    for group in jobs:
        runs = [[] for _ in group]
        for _ in range(repeat):
            for arguments, mine in zip(group, runs):
                progress.show(" ".join(map(str, arguments)))
                mine.append(run_once(arguments))
                progress.step()
        results.append([summary_of(mine) for mine in runs])
    progress.end()
    return results


def summary_of(runs):
    """The last run, with the median, the least and the greatest time of all in it. Nothing but
    times may differ between runs of one thing."""
    if len({run["stateHash"] for run in runs}) > 1:
        sys.exit(f"{runs[0]['scene']} in {runs[0]['engine']}: two runs end in different states")
    times = [run["cpuMsPerStep"] for run in runs]
    result = dict(runs[-1])
    result["runs"] = len(runs)
    result["cpuMsPerStep"] = statistics.median(times)
    result["cpuMsPerStepLeast"], result["cpuMsPerStepMost"] = min(times), max(times)
    result["spread"] = (max(times) - min(times)) / result["cpuMsPerStep"]
    result["nsPerBodyStep"] = 1e6 * result["cpuMsPerStep"] / max(result["bodies"], 1)
    return result


def write_csv(path, rows):
    """Columns in the order in which the rows first name them."""
    path.parent.mkdir(parents=True, exist_ok=True)
    names = list(dict.fromkeys(name for row in rows for name in row))
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, names, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
