#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks engine/docs/tuning.md: each row and rule of advice names a test, each test that is named
exists, and each test of advice is named."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "engine/docs/tuning.md"
TEST = re.compile(r"TEST(?:_[PF])?\(\s*(\w+),\s*(\w+)\s*\)")
NAMED = re.compile(r"`((?:[A-Z]\w+)\.(?:[A-Z]\w+))`")
SUITES = ("Advice", "LimitAdvice")  # of advice alone: each of their tests is on the page
# Sections whose rows are advice; the names are in the last column.
TABLES = ("# Tuning: which settings to take", "## What to take", "### By symptom", "### What the profiles lose",
          "### Stack high", "### Put heavy on light")


def sections(text):
    """(heading, lines) of each section."""
    heading, lines = "", []
    for line in text.splitlines():
        if line.startswith("#"):
            yield heading, lines
            heading, lines = line, []
        else:
            lines.append(line)
    yield heading, lines


def faults(text, tests):
    """Yields a sentence for each fault."""
    found = dict(sections(text))
    for heading in TABLES:
        rows = [line for line in found.get(heading, []) if re.match(r"\| (?!---)", line)][1:]
        if not rows:
            yield f"tuning.md: no table below {heading}"
        for row in rows:
            if not NAMED.search(row.rsplit("|", 2)[1]):
                yield f"tuning.md: no test in the last column: {row[:60]}"
    rules = re.findall(r"^\d\. .*(?:\n {2,}.*)*", "\n".join(found.get("## What to take", [])), re.MULTILINE)
    for rule in rules:
        if not NAMED.search(rule):
            yield f"tuning.md: no test at the rule: {rule[:60]}"
    if len(rules) < 2:
        yield "tuning.md: the rules are missing"
    named = set(NAMED.findall(text))
    for name in sorted(named - tests):
        yield f"tuning.md: there is no test {name}"
    for name in sorted(tests - named):
        if name.split(".")[0] in SUITES:
            yield f"tuning.md: {name} is a test of advice, but not named"


def main():
    """Prints the faults; exit code 1 if there are any."""
    tests = set()
    for source in (ROOT / "tests").rglob("*_test.cpp"):
        tests |= {".".join(name) for name in TEST.findall(source.read_text(encoding="utf-8"))}
    found = list(faults(PAGE.read_text(encoding="utf-8"), tests))
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
