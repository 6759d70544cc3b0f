#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the table of mechanisms in engine/README.md: each file of the folders in it has one row, and
its lines of code are right to a fifth. Also counts what one must know to change the contact pass.
mechanisms.py --write counts the lines again."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from check_sizes import code_lines  # noqa: E402

PAGE = ROOT / "engine/README.md"
HEAD = "## Mechanisms\n"
FOLDER = re.compile(r"\*\*([\w/]+)\*\*")
FILE = re.compile(r"`(\w+)`")
COUNT = 3  # cell of the lines
KNOW = "To change the contact pass, one must know:\n"
MOST_TO_KNOW = 20


def lines_by_file(folder):
    """Lines of code of the files of a folder by their names without suffix."""
    lines = {}
    for path in sorted((ROOT / "engine/src" / folder).glob("*.?pp")) + sorted(
        (ROOT / "engine/src" / folder).glob("*.inl")
    ):
        name = path.stem.removesuffix("_avx2")
        lines[name] = lines.get(name, 0) + code_lines(path)
    return lines


class Table:
    """Counts the lines of each row, and collects what is wrong."""

    def __init__(self):
        self.faults = []
        self.folder, self.files, self.named = "", {}, set()

    def leave(self):
        """Ends a folder: files that no row names are a fault, if some are named."""
        if self.named:
            self.faults += [f"{self.folder}/{name}: no row" for name in self.files.keys() - self.named]
        self.named = set()

    def count_of(self, cell):
        """The lines of the files that the first cell of a row names; of all, if it is a folder."""
        names = FILE.findall(cell)
        folder = FOLDER.match(cell.strip())
        if folder:
            self.leave()
            self.folder, _, first = folder[1].partition("/")
            self.files = lines_by_file(self.folder)
            names = [first, *names] if first else list(self.files)
        else:
            self.named |= set(names)
        self.faults += [f"{self.folder}/{name}: no such file" for name in names if name not in self.files]
        return sum(self.files.get(name, 0) for name in names)

    def row(self, line):
        """The row with its lines counted."""
        cells = line.split("|")[1:-1]
        if len(cells) <= COUNT or not (FILE.search(cells[0]) or FOLDER.search(cells[0])):
            return line
        count = self.count_of(cells[0])
        written = int(re.sub(r"\D", "", cells[COUNT]) or 0)
        if abs(count - written) > max(20, count / 5):
            self.faults.append(f"{cells[0].strip()}: {count} lines, not {written}")
        mark = "**" if "**" in cells[0] else ""
        cells[COUNT] = f" {mark}{count:,}{mark} "
        return "|" + "|".join(cells) + "|"


def faults_of_list(page):
    """The numbered list of what one must know is there, in order and not too long."""
    items = re.findall(r"^(\d+)\. ", page.partition(KNOW)[2].partition("\n## ")[0], re.MULTILINE)
    if not items or [int(item) for item in items] != list(range(1, len(items) + 1)):
        return ["the list of what one must know to change the contact pass is not numbered in order"]
    few = len(items) <= MOST_TO_KNOW
    return [] if few else [f"{len(items)} things to know to change the contact pass, not {MOST_TO_KNOW}"]


def main():
    """Prints the faults; exit code 1 if there are any."""
    before, head, rest = PAGE.read_text(encoding="utf-8").partition(HEAD)
    body, mark, after = rest.partition("\n## ")
    table = Table()
    counted = "\n".join(table.row(line) for line in body.split("\n"))
    table.leave()
    table.faults += faults_of_list(before)
    if "--write" in sys.argv:
        PAGE.write_text(before + head + counted + mark + after, encoding="utf-8")
    for fault in sorted(table.faults):
        print(fault, file=sys.stderr)
    return 1 if table.faults or not head else 0


if __name__ == "__main__":
    sys.exit(main())
