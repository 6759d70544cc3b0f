#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the short experiments and judges the page of tools/thesis: page_test.py PROGRAM FOLDER

Each number holds by its law, but the known differences; no figure of the thesis is missing; and a
number that is moved out of its range changes the verdict. Exit code: 0 all held, 1 not."""
import copy
import json
import pathlib
import re
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/lib"))
import thesis  # noqa: E402


def moved(experiments):
    """Sentences: numbers out of their range by a hair that no verdict notices."""
    for e, one in enumerate(experiments):
        for r, row in enumerate(one["rows"]):
            if not thesis.holds(row):
                continue
            for side, sign in (("low", -1), ("high", 1)):
                if row[side] is None:
                    continue
                changed = copy.deepcopy(one)
                changed["rows"][r]["value"] = row[side] + sign * (1e-3 * abs(row[side]) + 1e-9)
                kind, words = thesis.verdict(changed)
                if kind == "good" or "differs" not in words:
                    yield f"{one['id']}: {row['what']} may be {side}"
                book = [*experiments[:e], changed, *experiments[e + 1:]]
                isKnown = thesis.known(one["id"], row) is not None
                if not isKnown and not any(row["what"] in fault for fault in thesis.faults(book)):
                    yield f"{one['id']}: {row['what']} may be {side} without a fault"


def missing(text):
    """Sentences: what the page does not show."""
    for figure in thesis.FIGURES:
        if not re.search(rf"Figures? {re.escape(figure)}:", text):
            yield f"figure {figure} is not listed"
    for words in thesis.SECTIONS:
        part = re.search(rf'<section id="{words.id}">.*?</section>', text, re.DOTALL)
        if part is None or "verdict" not in part[0]:
            yield f"{words.id} has no section with a verdict"
        elif words.figures and "thesis2006()" not in part[0] and words.id not in (
                "climb", "plate", "bisection", "sweep", "apart"):
            yield f"{words.id} has no number of thesis2006()"
    for asked in re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', text):
        yield f"the page needs another file: {asked}"


def main(program, folder):
    start = time.monotonic()
    run = subprocess.run([program, "--quick"], stdout=subprocess.PIPE, check=True)
    experiments = json.loads(run.stdout)
    text = thesis.page(experiments, quick=True)
    (folder / "thesis.html").write_text(text, encoding="utf-8")
    found = [*thesis.faults(experiments), *moved(experiments), *missing(text)]
    for fault in found:
        print(fault)
    count = sum(len(one["rows"]) for one in experiments)
    print(f"{count} numbers in {time.monotonic() - start:.1f} s, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
