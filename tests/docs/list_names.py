#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lists the public names of another engine, for the pages of engine/docs/migration.

    list_names.py FOLDER > LIST     FOLDER: its headers (.h), or declaration files (.d.ts)

Headers need Universal Ctags. A line of the list is a type with its members; `*` stands for what is
outside of all types:

    * b2Body b2_pi b2Distance
    b2Body GetPosition GetAngle

Left out: private and protected members, constructors, destructors, operators, include guards, macros
of export and inlining, and names with an underscore in front or behind. Members of a type within a
type belong to the outer one."""
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

NOISE = re.compile(r"^(_|operator|~|__anon)|_$|_H(_|$)|_API$|_EXPORT$|_INLINE$|^unused$|^internalValue$")
MACROS = r"(?<!define )\b(B2_API|B2_INLINE|B2_FORCE_INLINE|CP_EXPORT)\b"


def headers(folder):
    """Pairs of owner and name from C and C++ headers, by Universal Ctags."""
    tags, hidden, typedefs = [], set(), {}
    with tempfile.TemporaryDirectory() as copies:
        for number, path in enumerate(sorted(pathlib.Path(folder).glob("*.h"))):
            text = path.read_text(encoding="utf-8", errors="replace")
            text = re.sub(MACROS, "", text)  # they hide declarations from ctags
            text = re.sub(r"\bB2_LITERAL\(\s*(\w+)\s*\)", r"(\1)", text)
            language = "C++" if re.search(r"^class |^\s*public:", text, re.M) else "C"
            copy = pathlib.Path(copies, f"{number:03}.h")
            copy.write_text(text, encoding="utf-8")
            kinds = "cdefgmpstuvx" if language == "C++" else "defgmpstuvx"
            result = subprocess.run(
                ["ctags", "--output-format=json", "--fields=+nKaSZ", f"--language-force={language}",
                 f"--kinds-{language}={kinds}", "-f", "-", str(copy)],
                capture_output=True, text=True, check=True)
            for tag in map(json.loads, result.stdout.splitlines()):
                tag["text"] = text.splitlines()[tag["line"] - 1]
                tags.append(tag)
    for tag in tags:
        if tag.get("access") in ("private", "protected"):
            hidden.add(tag["name"])
        typeref = str(tag.get("typeref", "")).split(":")[-1]
        if tag["kind"] == "typedef" and typeref.startswith("__anon"):
            typedefs[typeref] = tag["name"]  # typedef struct { ... } name;
    for tag in tags:
        name = tag["name"]
        scopes = [typedefs.get(s, s) for s in tag.get("scope", "").split("::") if s]
        if (NOISE.search(name) or "operator" in tag["text"] or tag.get("access") in ("private", "protected")
                or f"::{name}" in tag["text"] or re.match(r"\s*friend ", tag["text"])
                or tag.get("scopeKind") in ("function", "prototype")
                or any(s in hidden and s.startswith("__anon") for s in scopes)):
            continue
        scopes = [s for s in scopes if not s.startswith("__anon")]
        if name not in scopes:
            yield (scopes[0] if scopes else "*"), name


def declarations(folder):
    """Pairs of owner and name from the declaration files (.d.ts) of a package."""
    for path in sorted(pathlib.Path(folder).rglob("*.d.ts")):
        text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.S)
        depth, owner = 0, None
        for line in text.splitlines():
            line = re.sub(r"//.*|\"[^\"]*\"|'[^']*'", "", line)
            outer = re.match(r"\s*(?:export )?(?:declare )?(?:default )?(?:abstract )?"
                             r"(class|interface|enum|type|function|const|let|namespace)\s+(\w+)", line)
            member = re.match(r"\s*(?:(?:static|readonly|abstract|get|set)\s+)*(\w+)\s*[?]?\s*(?:<.*?>)?[(:=,]|"
                              r"\s*(\w+)\s*=?[^(]*,?$", line)
            if depth == 0 and outer:
                kind, owner = outer.groups()
                yield "*", owner
                if kind in ("function", "const", "let", "namespace"):
                    owner = None
            elif depth == 0 and "{" in line:
                owner = None
            elif depth == 1 and owner and member and not re.match(r"\s*(private|protected|#)", line):
                name = member.group(1) or member.group(2)
                if name not in ("constructor", "new") and not NOISE.search(name):
                    yield owner, name
            depth += line.count("{") - line.count("}")


def main():
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir():
        print(__doc__)
        return 2
    typed = any(pathlib.Path(sys.argv[1]).rglob("*.d.ts"))
    members = collections.defaultdict(set)
    for owner, name in (declarations if typed else headers)(sys.argv[1]):
        members[owner].add(name)
    print("*", *sorted(members.pop("*")))
    for owner in sorted(members):
        print(owner, *sorted(members[owner]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
