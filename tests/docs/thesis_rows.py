#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the tables of engine/docs/thesis.md: the files and tests of a row exist, and each row of
the projects (A1 to A8) and the further rows (X1 to X9) is named in a comment of such a test."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROW = re.compile(r"^\| ([A-Z]\d+) \|.*\|([^|]*)\|([^|]*)\|$", re.MULTILINE)
FILE = re.compile(r"`([\w/]+\.\w+)`")
NAMED = re.compile(r"`([\w/]+_test\.(?:cpp|py))(?:: ([^`]*))?`")


def faults():
    """Yields a sentence for each fault."""
    page = (ROOT / "engine/docs/thesis.md").read_text(encoding="utf-8")
    rows = ROW.findall(page)
    if len(rows) < 55:
        yield f"thesis.md: only {len(rows)} rows were found"
    for row, files, tests in rows:
        for file in FILE.findall(files):
            if not (ROOT / "engine" / file).is_file() and not (ROOT / file).is_file():
                yield f"row {row}: {file} does not exist"
        isMarked = False
        for file, names in NAMED.findall(tests):
            path = ROOT / "tests" / file
            if not path.is_file():
                yield f"row {row}: tests/{file} does not exist"
                continue
            text = path.read_text(encoding="utf-8")
            isMarked = isMarked or re.search(rf"(?://|#|\"\"\").*\b{row}\b", text) is not None
            for name in filter(None, (n.strip() for n in names.split(","))):
                suite, test = name.split(".")
                if not re.search(rf"TEST(?:_[PF])?\(\s*{suite},\s*{test}\s*\)", text):
                    yield f"row {row}: tests/{file} has no test {name}"
        if row[0] in "AX" and not isMarked:
            yield f"row {row}: no test that it names has the comment {row}"


def main():
    """Prints the faults; exit code 1 if there are any."""
    found = list(faults())
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
