#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the pages of engine/docs/migration.

    migration.py [LIST=HEADERS ...]     for example box2d_2_4=/usr/include/box2d
    migration.py --write                writes the last table of the glossary

Each page has a row for each name of its list in tests/docs/names, and for no other name. A first cell
is groups of names, separated by `;`. A group is names outside of all types or, after `Type:` or below
a heading with a type, members of that type. Names of Kodo in the second cell exist in the public
headers, in kodo.h or in kodo_sfml; files exist. The last table of the glossary has the names of both
Box2D pages without a counterpart; of a type that has none, its members are left out. With HEADERS and Universal Ctags, a list is compared
with the names of installed headers, where their version is that of the list. Exit code 0: all is well."""
import collections
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PAGES = {"box2d_2_4": "box2d-2.4.md", "box2d_3": "box2d-3.md", "chipmunk": "chipmunk.md", "planck": "planck.md",
         "rapier": "rapier.md"}
# Of the examples in the answers, and of the language.
OTHER_WORDS = {"world", "id", "i", "a", "b", "t", "impulse", "pool", "primitive", "sensor", "categories", "std", "kodo",
               "sizeof", "auto", "double", "float", "flags", "vector", "kodo64"}


def names_of(path):
    """Set of (owner, name); the owner of what is outside of all types is `*`."""
    rows = (line.split() for line in path.read_text(encoding="utf-8").splitlines())
    return {(row[0], name) for row in rows for name in row[1:]}


def own_words():
    """Identifiers of the public headers of Kodo, without comments."""
    words = set(OTHER_WORDS)
    for path in [*ROOT.glob("engine/include/kodo/*.hpp"), ROOT / "engine/c/kodo.h",
                 *ROOT.glob("engine/sfml/kodo_sfml/*.hpp")]:
        text = re.sub(r"//.*|/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.S if path.suffix == ".h" else 0)
        words |= set(re.findall(r"[A-Za-z_]\w*", text))
    return words


def rows_of(page):
    """Line, owner of the heading, first and second cell of each row."""
    owner = None
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("#"):
            heading = re.match(r"#+ `(\w+)`$", line)
            owner = heading.group(1) if heading else None
            if owner:
                yield number, None, f"`{owner}`", ""
        elif line.startswith("| `"):
            cells = line.strip("| ").split(" | ")
            yield number, owner, cells[0], " | ".join(cells[1:])


def named_in(cell, heading, known, counts):
    """Counts the names of a first cell; returns those that the list has not."""
    unknown = []
    for group in cell.split("; "):
        head = re.match(r"`(\w+)`: ", group)
        owner = head.group(1) if head else heading
        if head:
            counts["*", owner] += 1
            if ("*", owner) not in known:
                unknown.append(owner)
            group = group[head.end():]
        for name in re.findall(r"`(\w+)`", group):
            key = (owner, name) if (owner, name) in known else ("*", name)
            counts[key] += 1
            if key not in known:
                unknown.append(f"{owner}: {name}" if owner else name)
    return unknown


def wrong_words(answer, words, page):
    """Names in an answer that Kodo has not, and files that do not exist."""
    wrong = [target for target in re.findall(r"\]\(([^)#]+)", answer) if not (page.parent / target).exists()]
    for code in re.findall(r"`([^`]+)`", re.sub(r"\[`[^`]*`\]", "", answer)):
        if re.fullmatch(r"[\w/]+\.[ch]pp", code):
            wrong += [] if (ROOT / "engine/include/kodo" / code).exists() else [code]
            continue
        code = re.sub(r"std::\w+(::\w+)*|\b\d[\w.]*|\"[^\"]*\"", "", code)
        wrong += [word for word in re.findall(r"[A-Za-z_]\w*", code) if word not in words]
    return wrong


def check_page(page, known, words):
    counts, bad, rows = collections.Counter(), [], 0
    for number, heading, cell, answer in rows_of(page):
        rows += 1
        bad += [f"{number}: the list has no {name}" for name in named_in(cell, heading, known, counts)]
        answer = re.sub(r"as of `\w+`", "", answer)  # another section of the page
        bad += [f"{number}: Kodo has no {name}" for name in wrong_words(answer, words, page)]
    bad += [f"no row for {owner}: {name}" for owner, name in sorted(known) if counts[owner, name] == 0]
    # A type may head several rows; what is within a type has one answer.
    bad += [f"two rows for {owner}: {name}" for (owner, name), count in sorted(counts.items())
            if count > 1 and owner != "*"]
    for line in bad:
        print(f"{page.relative_to(ROOT)}:{line}")
    print(f"{page.name}: {len(known)} names in {rows} rows, {len(bad)} wrong")
    return len(bad)


def check_list(name, headers):
    """Compares a list with installed headers; 0 if they are not there."""
    if not pathlib.Path(headers).is_dir() or shutil.which("ctags") is None:
        print(f"{name}: not compared with headers: ctags or {headers} is missing")
        return 0
    found = subprocess.run([sys.executable, "-B", str(HERE / "list_names.py"), headers], capture_output=True,
                           text=True, check=True).stdout
    listed = (HERE / "names" / f"{name}.txt").read_text(encoding="utf-8")
    if found == listed:
        print(f"{name}: as in {headers}")
        return 0
    new = set(found.split()) - set(listed.split())
    gone = set(listed.split()) - set(found.split())
    print(f"{name}: {headers} has {sorted(new)}, the list has {sorted(gone)}")
    return 1


LACKING = re.compile(r"no |none|does not exist|do not exist|not public|not needed|not told|not stored|the engine |always on")
GLOSSARY = ROOT / "engine/docs/glossary.md"


def lacking_names():
    """Names of both Box2D pages without a counterpart, by what to do instead."""
    found = collections.defaultdict(list)
    for name in ("box2d_2_4", "box2d_3"):
        page = ROOT / "engine/docs/migration" / PAGES[name]
        known = names_of(HERE / "names" / f"{name}.txt")
        answers = collections.defaultdict(set)  # of all that belongs to a type
        rows = []
        for _, heading, cell, answer in rows_of(page):
            for group in cell.split("; ") if answer else []:
                head = re.match(r"`(\w+)`: ", group)
                owner = head.group(1) if head else heading
                for each in re.findall(r"`(\w+)`", group[head.end():] if head else group):
                    inside = (owner, each) in known
                    rows.append((owner if inside else None, each, answer))
                    answers[owner if inside else each].add(answer)
        for owner, each, answer in rows:
            if not LACKING.match(answer):
                continue
            whole = owner is not None and all(map(LACKING.match, answers[owner]))
            shown = f"`{owner}`" if whole else f"`{owner}::{each}`" if owner else f"`{each}`"
            answer = re.sub(r"\]\(\.\./", "](", answer).replace("](#", f"](migration/{page.name}#")
            if shown not in found[answer]:
                found[answer].append(shown)
    return found


def glossary_table():
    found = lacking_names()
    rows = [f"| {', '.join(sorted(found[answer]))} | {answer} |" for answer in sorted(found)]
    return "\n".join(["| Box2D | instead |", "|---|---|", *rows]) + "\n"


def check_glossary(write):
    text = GLOSSARY.read_text(encoding="utf-8")
    start = text.rindex("| Box2D | instead |")
    if text[start:] == glossary_table():
        return 0
    if write:
        GLOSSARY.write_text(text[:start] + glossary_table(), encoding="utf-8")
        return 0
    print("the last table of glossary.md is not that of the pages: run tests/docs/migration.py --write")
    return 1


def main():
    if sys.argv[1:] == ["--write"]:
        return check_glossary(write=True)
    words = own_words()
    bad = 0
    for name, page in PAGES.items():
        bad += check_page(ROOT / "engine/docs/migration" / page, names_of(HERE / "names" / f"{name}.txt"), words)
    bad += check_glossary(write=False)
    for argument in sys.argv[1:]:
        bad += check_list(*argument.split("=", 1))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
