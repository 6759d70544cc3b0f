#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares engine/docs/pictures and engine/examples/README.md with what the programs draw and print.

  pictures.py --examples FOLDER --manual PROGRAM           exit code 1, and what differs
  pictures.py --examples FOLDER --manual PROGRAM --write   writes pictures and outputs

FOLDER holds the built examples, PROGRAM draws the pictures of the manual. Each picture is a
well-formed SVG below 12 kB that a page shows, and each program of engine/examples has fewer than 60
lines, a row in the table, and its output in its section if it has one."""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "engine/examples"
PICTURES = ROOT / "engine/docs/pictures"
PAGES = (EXAMPLES / "README.md", ROOT / "engine/docs/manual.md")
MAX_BYTES = 12_000
MAX_LINES = 59
SHAPES = ("polygon", "polyline", "circle")
NAMESPACE = "{http://www.w3.org/2000/svg}"


def draw(programs, manual, folder):
    """The pictures that the programs draw, by name."""
    subprocess.run([manual, folder], check=True)
    for source in sorted(EXAMPLES.glob("*.cpp")):
        if "argv[1]) <<" in source.read_text(encoding="utf-8"):
            picture = folder / f"{source.stem}.svg"
            subprocess.run([programs / source.stem, picture], check=True, stdout=subprocess.DEVNULL,
                           cwd=folder)
    return {path.name: path.read_bytes() for path in sorted(folder.glob("*.svg"))}


def faults_of_picture(name, data):
    """Yields sentences."""
    if len(data) >= MAX_BYTES:
        yield f"{name}: {len(data)} bytes, must be fewer than {MAX_BYTES}"
    try:
        root = ElementTree.fromstring(data)
    except ElementTree.ParseError as error:
        yield f"{name}: {error}"
        return
    if not any(root.iter(NAMESPACE + tag) for tag in SHAPES) or root.tag != NAMESPACE + "svg":
        yield f"{name}: no shape in an svg"


def with_outputs(page):
    """The page of examples with the output of each program, and what is missing."""
    sections = re.split(r"(?m)^(?=### )", page)
    faults = []
    for source in sorted(EXAMPLES.glob("*.cpp")):
        lines = len(source.read_text(encoding="utf-8").splitlines())
        if lines > MAX_LINES:
            faults.append(f"{source.name}: {lines} lines, must be at most {MAX_LINES}")
        if f"| [{source.name}]({source.name}) |" not in page:
            faults.append(f"README.md: no row of {source.name}")
        found = [i for i, each in enumerate(sections) if each.startswith(f"### [{source.name}](")]
        if not found:
            continue  # a row is enough
        output = source.with_suffix(".txt").read_text(encoding="utf-8")
        block = f"```text\n{output}```"
        sections[found[0]] = re.sub(r"```text\n.*?```", lambda _, new=block: new, sections[found[0]],
                                    flags=re.S)
        if block not in sections[found[0]]:
            faults.append(f"README.md: no output of {source.name}")
    return "".join(sections), faults


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--examples", required=True, type=pathlib.Path)
    parser.add_argument("--manual", required=True, type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="kodo-pictures-") as work:
        drawn = draw(given.examples.resolve(), given.manual.resolve(), pathlib.Path(work))
    page = PAGES[0].read_text(encoding="utf-8")
    text, faults = with_outputs(page)
    if given.write:
        PAGES[0].write_text(text, encoding="utf-8")
        for name, data in drawn.items():
            (PICTURES / name).write_bytes(data)
    elif text != page:
        faults.append("README.md: an output differs from its .txt file")
    stored = {path.name: path.read_bytes() for path in PICTURES.glob("*.svg")}
    shown = {name for page in PAGES
             for name in re.findall(r"pictures/(\w+\.svg)", page.read_text(encoding="utf-8"))}
    for name in sorted(set(drawn) | set(stored) | shown):
        if stored.get(name) != drawn.get(name):
            faults.append(f"{name}: differs from what is drawn now; build the target pictures")
        if name not in shown:
            faults.append(f"{name}: no page shows it")
        faults += faults_of_picture(name, drawn.get(name, b""))
    print("\n".join(faults) or f"pictures: ok, {len(drawn)}")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
