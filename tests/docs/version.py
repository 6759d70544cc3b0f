#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that the changelog, kodo/version.hpp and the lines find_package(kodo ...) of all pages name one
version, that versions fall from the top, and that all below the first are closed by a date. --tag vX.Y.Z also asks that the first is closed and has
that name; --notes prints its text, for a release. Exit code 0: all are well, 1: something is not."""
import argparse
import datetime
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PACKAGE = re.compile(r"find_package\(kodo (\d+)\.(\d+)")
HEADING = re.compile(r"^## (\d+)\.(\d+)\.(\d+) - (.+)$", re.M)


def dated(text):
    try:
        return bool(datetime.date.fromisoformat(text))
    except ValueError:
        return False


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tag", metavar="vX.Y.Z", help="the tag of a release")
    parser.add_argument("--notes", action="store_true", help="prints what the first version changes")
    options = parser.parse_args()

    header = (ROOT / "engine/include/kodo/version.hpp").read_text(encoding="utf-8")
    declared = tuple(int(number) for number in re.findall(r"define KODO_VERSION_[A-Z]+ (\d+)", header))
    log = (ROOT / "engine/CHANGELOG.md").read_text(encoding="utf-8")
    headings = list(HEADING.finditer(log))
    versions = [tuple(map(int, heading.groups()[:3])) for heading in headings]
    if not versions:
        print("engine/CHANGELOG.md has no heading such as '## 0.2.0 - 2026-11-28'.")
        return 1
    if options.notes:
        end = headings[1].start() if len(headings) > 1 else len(log)
        print(log[headings[0].end():end].strip())
        return 0

    name = ".".join(map(str, versions[0]))
    bad = []
    if versions[0] != declared:
        bad.append(f"version.hpp declares {'.'.join(map(str, declared))}, the changelog begins with {name}.")
    if versions != sorted(set(versions), reverse=True):
        bad.append("The versions of the changelog do not fall from the top.")
    for page in [ROOT / "README.md", *ROOT.glob("engine/**/*.md")]:
        for found in PACKAGE.finditer(page.read_text(encoding="utf-8")):
            if tuple(map(int, found.groups())) != versions[0][:2]:
                bad.append(f"{page.relative_to(ROOT)} says {found[0]}: {name} does not accept that.")
    for version, heading in zip(versions[1:], headings[1:]):
        if not dated(heading[4]):
            bad.append(f"{'.'.join(map(str, version))} has no date such as 2026-11-28: {heading[4]!r}.")
    if not dated(headings[0][4]) and (options.tag or headings[0][4] != "unreleased"):
        bad.append(f"{name} is neither closed by a date nor 'unreleased': {headings[0][4]!r}.")
    if options.tag and options.tag != f"v{name}":
        bad.append(f"The tag is {options.tag}, the changelog begins with {name}.")
    print("\n".join(bad) or f"version: ok, {name}, {headings[0][4]}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
