# SPDX-License-Identifier: MIT
"""Shared by tools/bench and tools/trade: interleaved runs of kodo-bench on one core, medians."""
import argparse
import csv
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import time

import options

BENCH = pathlib.Path("build/bench/bin/kodo-bench")


class Options(options.Options):
    """Options of a shell script. It prints --help itself, and checks them with --check-options."""

    def __init__(self, prog):
        super().__init__(prog, add_help=False)
        self.add_argument("--check-options", action="store_true")

    def parse_args(self, args=None, namespace=None):
        chosen = super().parse_args(args, namespace)
        self.check(chosen)
        if chosen.check_options:
            sys.exit(0)
        return chosen

    def check(self, chosen):
        """Refuses options that do not go together, by error()."""


def refuse_quick(parser, chosen):
    """--quick means one run each."""
    if chosen.quick and chosen.repeat:
        parser.error("--quick is one run each: give no --repeat")


def runs(text):
    """Value of --repeat: 1 to 1000."""
    count = int(text) if text.isdecimal() else 0
    if not 1 <= count <= 1000:
        raise argparse.ArgumentTypeError(f"must be a whole number from 1 to 1000, not {text}")
    return count


class Progress:
    """One line on stderr that is overwritten; silent if stderr is not a terminal."""

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
    """Selects the last core: most systems handle interrupts on the first one."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


def run_once(arguments):
    """One run of kodo-bench: its JSON object, or a SystemExit with its error message."""
    words = [str(BENCH), "--json", *map(str, arguments)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(words)} ended with {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def run_in_turn(jobs, repeat):
    """jobs: groups of lists of arguments. The runs of a group are interleaved, `repeat` times,
    because the speed of a machine varies over time. Returns groups of summaries (summary_of)."""
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
    """The last run, with the median, least and greatest time of all runs. The runs must end in
    equal states."""
    if len({run["stateHash"] for run in runs}) > 1:
        sys.exit(f"{runs[0]['scene']} in {runs[0]['engine']}: two runs end in different states")
    times = [run["cpuMsPerStep"] for run in runs]
    result = dict(runs[-1])
    result["runs"] = len(runs)
    result["cpuMsPerStep"] = statistics.median(times)
    result["cpuMsPerStepLeast"], result["cpuMsPerStepMost"] = min(times), max(times)
    worst = [run["worstStepMs"] for run in runs if run.get("worstStepMs") is not None]
    result["worstStepMs"] = statistics.median(worst) if worst else None
    result["spread"] = (max(times) - min(times)) / result["cpuMsPerStep"]
    result["nsPerBodyStep"] = 1e6 * result["cpuMsPerStep"] / max(result["bodies"], 1)
    return result


def number(value, digits=3):
    """Three significant digits, without an exponent."""
    if value is None:
        return ""
    if value == 0:
        return "0"
    places = max(digits - 1 - math.floor(math.log10(abs(value))), 0)
    return f"{value:,.{places}f}"


def write_csv(path, rows):
    """Columns are in the order of their first occurrence."""
    path.parent.mkdir(parents=True, exist_ok=True)
    names = list(dict.fromkeys(name for row in rows for name in row))
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, names, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
