#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the links of all Markdown pages: the file exists, and the heading behind a `#` too. Links to
other hosts are not followed. Checks also how long the manual and the README take to read: half an
hour at 240 words a minute, code included, and 800 words. Exit code 0: all are well."""
import functools
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
WORDS_A_MINUTE = 240
LONGEST = {"README.md": 800, "engine/docs/manual.md": 30 * WORDS_A_MINUTE}


def prose_of(page):
    """A page without its fenced blocks."""
    return re.sub(r"^(```|~~~).*?^\1", "", page.read_text(encoding="utf-8"), flags=re.S | re.M)


@functools.cache
def anchors_of(page):
    """Anchors of the headings, as public hosts make them."""
    found, counts = set(), {}
    for title in re.findall(r"^#+ +(.*?) *$", prose_of(page), flags=re.M):
        title = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", title)
        anchor = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        counts[anchor] = counts.get(anchor, -1) + 1
        found.add(f"{anchor}-{counts[anchor]}" if counts[anchor] else anchor)
    return found


def main():
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"], cwd=ROOT,
                            capture_output=True, text=True, check=False).stdout.split()
    pages = [ROOT / name for name in listed] or sorted(ROOT.glob("*.md")) + sorted(ROOT.glob("engine/**/*.md"))
    links, bad = 0, []
    for page in (page for page in pages if page.exists()):
        for target in re.findall(r"\]\(([^)\s]+)\)", prose_of(page)):
            if re.match(r"\w+:", target):
                continue
            links += 1
            name, _, anchor = target.partition("#")
            place = (page.parent / name).resolve() if name else page
            if not place.exists():
                bad.append(f"{page.relative_to(ROOT)}: {target}: no such file")
            elif anchor and place.suffix == ".md" and anchor not in anchors_of(place):
                bad.append(f"{page.relative_to(ROOT)}: {target}: no such heading")
    for name, limit in LONGEST.items():
        words = len((ROOT / name).read_text(encoding="utf-8").split())
        print(f"{name}: {words} words of at most {limit}")
        if words > limit:
            bad.append(f"{name}: {words - limit} words too long")
    print("\n".join([*bad, f"{links} links of {len(pages)} pages, {len(bad)} mistakes"]))
    return 1 if bad or not links else 0


if __name__ == "__main__":
    sys.exit(main())
