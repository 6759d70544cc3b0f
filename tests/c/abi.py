#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the ABI of kodo.h with the list engine/c/abi.txt, for both precisions: version, values of
enumerators, sizes of types, offsets of members, functions; and the functions that the libraries
export. Numbers of types stand as float, double. The list is for systems with 64 bits.

  abi.py --compiler cc                       exit code 1, and the lines that differ
  abi.py --compiler cc --library libkodo_c.so ...   also what these libraries export
  abi.py --compiler cc --write               writes the list

Before --write: raise KODO_C_VERSION if the list of the last release differs."""
import argparse
import difflib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "engine/c"
PRECISIONS = ((), ("-DKODO_DOUBLE",))


def members(body):
    """Names of the members of a struct, those of anonymous unions among them."""
    body = re.sub(r"\bunion\s*\{(.*?)\}\s*;", r"\1", body, flags=re.DOTALL)
    for declaration in filter(None, (part.strip() for part in body.split(";"))):
        pointer = re.search(r"\(\*(\w+)\)\s*\(", declaration)
        yield pointer.group(1) if pointer else re.search(r"(\w+)(\[\w+\])?$", declaration).group(1)


class Header:
    """What kodo.h declares, by its text."""

    def __init__(self, path):
        text = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
        self.version = re.search(r"#define KODO_C_VERSION (\d+)", text).group(1)
        bodies = r"typedef struct (kodo_\w+) \{(.*?)\n\} \1;"
        self.structs = [
            (name, list(members(body))) for name, body in re.findall(bodies, text, re.DOTALL)
        ]
        self.types = list(dict.fromkeys(re.findall(r"typedef \w+ (kodo_\w+);", text)))
        enums = re.findall(r"\nenum \{(.*?)\};", text, re.DOTALL)
        self.enumerators = [name for body in enums for name in re.findall(r"(\w+) =", body)]
        declarations = re.findall(r"KODO_C_API (?!__)([^;{]*?\)) *;", text)
        callbacks = re.findall(r"typedef (\w+ \(\*\w+\)\([^;]*\));", text)
        self.functions = [" ".join(declaration.split()) for declaration in declarations + callbacks]
        self.exported = {re.search(r"(kodo_\w+)\(", line).group(1) for line in declarations}

    def program(self):
        """A program in C that prints a number for each enumerator, type and member."""
        lines = [f"(long long){name}" for name in self.enumerators]
        lines += [f"(long long)sizeof({name})" for name in self.types]
        for name, fields in self.structs:
            lines.append(f"(long long)sizeof({name})")
            lines += [f"(long long)offsetof({name}, {field})" for field in fields]
        prints = "".join(f'    printf("%lld\\n", {line});\n' for line in lines)
        return f"#include <kodo.h>\n#include <stdio.h>\nint main(void) {{\n{prints}    return 0;\n}}\n"

    def listed(self, numbers):
        """The lines of the list; numbers: those of each precision, in the order of program()."""
        pairs = zip(*numbers)
        yield f"version {self.version}"
        for name in self.enumerators:
            yield f"enumerator {name} {next(pairs)[0]}"
        for name in self.types:
            yield "type {} {} {}".format(name, *next(pairs))
        for name, fields in self.structs:
            yield "struct {} {} {}".format(name, *next(pairs))
            for field in fields:
                yield "    {} {} {}".format(field, *next(pairs))
        for declaration in self.functions:
            yield f"function {declaration}"


def numbers_of(header, compiler, definitions, work):
    source = work / "abi.c"
    source.write_text(header.program())
    program = work / "abi"
    library = work / "library.c"  # an empty definition of each function that inline ones call
    library.write_text("".join(f"void {name}(void) {{}}\n" for name in sorted(header.exported)))
    subprocess.run(
        [compiler, "-std=c11", f"-I{FOLDER}", *definitions, source, library, "-o", program], check=True
    )
    return subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()


def check_exports(header, library):
    """Yields sentences."""
    done = subprocess.run(
        ["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True
    )
    exported = {line.split()[-1].partition("@")[0] for line in done.stdout.splitlines()}
    for name in sorted(header.exported - exported):
        yield f"{library.name} does not export {name}"
    for name in sorted(exported - header.exported):
        yield f"{library.name} exports {name}, which kodo.h does not declare"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--compiler", required=True, help="a C compiler")
    parser.add_argument("--library", type=pathlib.Path, action="append", default=[])
    parser.add_argument("--write", action="store_true", help="write the list")
    given = parser.parse_args()
    if sys.maxsize < 2**32:
        print("abi: not a system with 64 bits; nothing is compared")
        return 0
    header = Header(FOLDER / "kodo.h")
    with tempfile.TemporaryDirectory(prefix="kodo-abi-") as work:
        numbers = [
            numbers_of(header, given.compiler, definitions, pathlib.Path(work))
            for definitions in PRECISIONS
        ]
    lines = list(header.listed(numbers))
    path = FOLDER / "abi.txt"
    if given.write:
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return 0
    before = path.read_text(encoding="utf-8").splitlines()
    wrong = list(difflib.unified_diff(before, lines, "abi.txt", "kodo.h", lineterm="", n=0))
    if shutil.which("nm"):
        wrong += [line for library in given.library for line in check_exports(header, library)]
    print("\n".join(wrong) or f"abi: ok, {len(lines)} lines")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
