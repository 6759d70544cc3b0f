#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads kodo.h and writes, for the module in JavaScript, into the folders PACKAGE and BUILD:

  layout.js         offsets of members on wasm32, enumerators, and how arguments of functions pass
  layout.d.ts       the same as types, with the comments of kodo.h
  layout_check.cpp  assertions that a compiler for wasm32 has the same offsets
  exports.txt       the functions that kodo.wasm exports

  layout.py KODO_H PACKAGE BUILD"""
import json
import pathlib
import re
import sys

# Sizes and alignments on wasm32 (bytes).
SCALARS = {
    "bool": 1, "uint8_t": 1, "uint16_t": 2, "int32_t": 4, "uint32_t": 4, "size_t": 4,
    "uint64_t": 8, "kodo_Real": 4,
}
HANDLES = ("World", "ThreadPool")
# Functions that kodo.js calls by itself.
BY_HAND = (
    "createWorld copyWorld assignWorld destroyWorld createThreadPool destroyThreadPool step stepWorlds"
    " poses velocities applyLoads setVelocities visitRay visitOverlaps draw fromBytes part decompose"
    " addBody addJoint joint setJoint addField setFields setSettings region setRegion bodyState"
    " containsBody worldSettings moveMover explode"
).split()


def lower(name):
    return name[0].lower() + name[1:]


def tidy(comment):
    return " ".join(comment.replace("*/", "").split())


class Header:
    def __init__(self, text):
        self.version = re.search(r"#define KODO_C_VERSION (\d+)", text)[1]
        self.exported = sorted(set(re.findall(r"KODO_C_API (?!__)[^;{]*?(kodo_\w+)\(", text)))
        self.enums = {}  # type: {name: value}
        found = re.findall(r"typedef (\w+) (kodo_\w+);", text)
        self.base = {name: base for base, name in found if base in SCALARS}
        self.aliases = SCALARS | {name: SCALARS[base] for name, base in self.base.items()}
        typed = r"typedef \w+ kodo_(\w+);\n(?:///[^\n]*\n)*enum \{(.*?)\};"
        for name, body in re.findall(typed, text, re.DOTALL):
            self.enums[name] = self.enumerators(body)
        self.structs = {}
        for doc, name, body in re.findall(
            r"((?:///[^\n]*\n)*)typedef struct kodo_(\w+) \{\n(.*?)\n\} kodo_\2;", text, re.DOTALL
        ):
            self.structs[name] = {"doc": tidy(doc.replace("///", "")), **self.layout(body)}
        self.functions = {}
        pattern = r"((?:///[^\n]*\n)*)KODO_C_API kodo_Status kodo_(\w+)\(([^;{]*?)\) *;"
        for doc, name, parameters in re.findall(pattern, text):
            self.functions[name] = (tidy(doc.replace("///", "")), self.parameters(parameters))

    @staticmethod
    def enumerators(body):
        found = {}
        for name, value in re.findall(r"KODO_(\w+) = ([^,/\n]+)", body):
            words = "".join(word.capitalize() for word in name.split("_"))
            found[words] = eval(value, {})  # a number, or 1 << number
        return found

    def size(self, kind):
        if kind in self.aliases:
            return self.aliases[kind], self.aliases[kind]
        struct = self.structs[kind.removeprefix("kodo_")]
        return struct["size"], struct["align"]

    @staticmethod
    def declarations(body):
        """(declaration, comment) of each member; a union is one of them."""
        body = re.sub(r"\bunion \{(.*?)\};", lambda m: "union{" + re.sub(
            r"//[^\n]*", "", m[1]).replace(";", "|").replace("\n", " ") + "};", body, flags=re.DOTALL)
        for match in re.finditer(r"((?:^ *///[^\n]*\n)*)^ *([^;/]+?);((?: *//[^\n]*\n?)*)",
                                 body, re.MULTILINE):
            yield " ".join(match[2].split()), tidy(re.sub(r"///?", "", match[1] + match[3]))

    def layout(self, body):
        fields, offset, largest, choices = [], 0, 1, None
        for declaration, doc in self.declarations(body):
            field = {"doc": doc}
            if declaration.startswith("union{"):
                members = [part.split() for part in declaration[6:-1].split("|") if part.strip()]
                sizes = [self.size(kind) for kind, _ in members]
                size, align = max(s for s, _ in sizes), max(a for _, a in sizes)
                size = -(-size // align) * align
                choices = [(name, kind.removeprefix("kodo_")) for kind, name in members]
                field.update(name="", kind="union")
            elif "(*" in declaration:
                size = align = 4
                field.update(name=re.search(r"\(\*(\w+)\)", declaration)[1], kind="pointer")
            else:
                kind, name, count = re.match(
                    r"(?:const )?(?:struct )?(\w+ ?\*?) ?(\w+)(?:\[(\d+)\])?$", declaration).groups()
                kind = kind.replace(" ", "")
                size, align = (4, 4) if kind.endswith("*") else self.size(kind)
                field.update(name=name, kind=kind, count=int(count or 1))
                size *= field["count"]
            offset = -(-offset // align) * align
            field.update(offset=offset)
            fields.append(field)
            offset += size
            largest = max(largest, align)
        return {"fields": fields, "choices": choices, "align": largest,
                "size": -(-offset // largest) * largest}

    def parameters(self, text):
        """(how, type, name) of what a caller in JavaScript passes or gets."""
        given = []
        for part in text.split(","):
            match = re.match(r"\s*(const )?(\w+) ?(\**)(?: ?const\*)? ?(\w+)\s*$", part)
            if match is None or match[2] == "void" and not match[3]:
                return None if part.strip() != "void" else []
            given.append((bool(match[1]), match[2], len(match[3]), match[4]))
        found, i = [], 0
        while i < len(given):
            const, kind, stars, name = given[i]
            short = kind.removeprefix("kodo_")
            following = [each[3] for each in given[i + 1:i + 3]]
            if short in HANDLES:
                found.append(("handle", short, name))
            elif stars and not const and following == ["capacity", "count"]:
                found.append(("list", short, name))
                i += 2
            elif stars and const and following and following[0] == name.rstrip("s") + "Count" \
                    or stars and const and following[:1] == ["count"]:
                found.append(("array", short, name))
                i += 1
            elif stars and not const:
                found.append(("out", short, name))
            elif short in self.structs or stars:
                found.append(("maybe" if stars else "in", short, name))
            else:
                found.append(("number", short, name))
            i += 1
        return found


class Writer:
    """The three files of a Header."""

    NAMES = {"bool": "b", "uint8_t": "u8", "uint16_t": "u16", "int32_t": "i32", "uint32_t": "u32",
             "size_t": "u32", "uint64_t": "u64", "kodo_Real": "f32", "char": "u8", "void": "u8"}

    def __init__(self, header):
        self.header = header

    def code(self, kind):
        """Name of a type in layout.js: that of a struct, or a letter with bits."""
        kind = kind.removeprefix("struct ").rstrip("*")
        short = kind.removeprefix("kodo_")
        if short in self.header.structs:
            return short
        full = kind if kind in self.NAMES else f"kodo_{short}"
        return self.NAMES.get(full) or self.NAMES[self.header.base[full]]

    def members(self, name):
        """(name, offset, code, how, extra offset, doc) as a user of JavaScript sees them."""
        fields = self.header.structs[name]["fields"]
        at = {field["name"]: field["offset"] for field in fields}
        hidden = set()
        for field in fields:
            plain, kind = field["name"], field["kind"]
            unseen = ("union", "pointer", "void*", "kodo_ThreadPool*")
            if plain in hidden or plain == "head" or kind in unseen and plain != "bytes":
                continue
            optional = "has" + plain[0].upper() + plain[1:]
            counter = plain.rstrip("s") + "Count"
            code, doc = self.code(kind), field["doc"]
            if kind.endswith("*"):
                hidden.add(counter)
                how = "items" if counter in at else "pointer"
                yield plain, field["offset"], code, how, at.get(counter, -1), doc
            elif plain.startswith("has") and lower(plain[3:]) in at:
                continue
            elif optional in at:
                yield plain, field["offset"], code, "optional", at[optional], doc
            elif field["count"] > 1:
                yield plain, field["offset"], code, "row", field["count"], doc
            elif plain == "ends":
                for end in self.members("JointEnds"):
                    yield (end[0], end[1] + field["offset"], *end[2:])
            else:
                yield plain, field["offset"], code, "value", -1, doc

    def structs(self):
        for name, struct in self.header.structs.items():
            made = {"size": struct["size"],
                    "fields": [list(member[:5]) for member in self.members(name)]}
            if struct["choices"]:
                made["union"] = next(f["offset"] for f in struct["fields"] if f["kind"] == "union")
                tag = next(f for f in struct["fields"]
                           if f["kind"] in ("kodo_ShapeKind", "kodo_JointKind", "kodo_FieldKind",
                                            "kodo_SolverKind"))
                made["tag"] = tag["offset"]
                made["fields"] = [each for each in made["fields"] if each[0] != tag["name"]]
                made["choices"] = struct["choices"]
            if f"init{name}" in self.header.functions:
                made["init"] = True
            yield name, made

    def functions(self):
        for name, (_, parameters) in self.header.functions.items():
            if parameters is not None and name not in BY_HAND and not name.startswith("init"):
                yield name, [[how, kind if kind in HANDLES else self.code("kodo_" + kind if
                              "kodo_" + kind in self.header.aliases else kind), given]
                             for how, kind, given in parameters]

    def javascript(self):
        yield "// Written by layout.py from kodo.h.\n"
        for name, values in self.header.enums.items():
            yield f"export const {name} = Object.freeze({json.dumps(values)});\n"
        yield f"export const cVersion = {self.header.version};\n"
        calls = {"World": [], "Body": [], None: []}
        for name, parameters in self.functions():
            calls[owner_of(parameters)].append((name, parameters))
        for what, items in (("structs", self.structs()), ("worldCalls", calls["World"]),
                            ("bodyCalls", calls["Body"]), ("calls", calls[None])):
            lines = ",\n".join(f"  {name}: {json.dumps(made)}" for name, made in items)
            yield f"export const {what} = {{\n{lines}\n}};\n"

    def typed(self, code):
        return {"b": "boolean", "u64": "number"}.get(
            code, code if code in self.header.structs else "number")

    def types(self):
        yield "// Written by layout.py from kodo.h.\nimport type {\n"
        yield "  BodyLike, Input, OwnFieldFunction, World,\n} from \"./kodo.js\";\n"
        for name, values in self.header.enums.items():
            if name == "Status":  # errors are exceptions
                continue
            body = "; ".join(f"readonly {each}: {value}" for each, value in values.items())
            yield f"export declare const {name}: {{ {body} }};\nexport type {name} = number;\n"
        for name, struct in self.header.structs.items():
            if name in ("Head", "JointEnds", "OwnField", "DebugDraw", "StepOptions", "Polygons"):
                continue
            lines = []
            dropped = {"kind", "solver"} if struct["choices"] else set()
            for plain, _, code, how, _, doc in self.members(name):
                if plain in dropped:
                    continue
                many = "[]" if how in ("items", "row") else ""
                mark = "?" if how == "optional" else ""
                comment = f"  /** {doc} */\n" if doc else ""
                lines.append(f"{comment}  {plain}{mark}: {self.typed(code)}{many};\n")
            doc = f"/** {struct['doc']} */\n" if struct["doc"] else ""
            base = f"{{\n{''.join(lines)}}}"
            if struct["choices"]:
                either = " | ".join(
                    f"{{ {each}: {'OwnFieldFunction' if kind == 'OwnField' else kind} }}"
                    for each, kind in struct["choices"])
                yield f"{doc}export type {name} = {base} & ({either});\n"
            else:
                yield f"{doc}export interface {name} {base}\n"
        for owner in ("World", "Body"):
            yield f"export interface {owner}Calls {{\n{''.join(self.methods(owner))}}}\n"

    def methods(self, owner):
        for name, parameters in self.functions():
            if owner_of(parameters) != owner:
                continue
            doc = self.header.functions[name][0]
            arguments, results = [], []
            for how, code, given in parameters[2 if owner == "Body" else 1:]:
                kind = {"BodyId": "BodyLike"}.get(code, self.typed(code))
                if how in ("list", "out"):
                    bytes_, text = (code, given) == ("u8", "bytes"), (code, given) == ("u8", "text")
                    kind = "Uint8Array" if bytes_ else "string" if text else self.typed(code)
                    kind = "bigint" if given == "hash" else kind
                    results.append(kind + ("[]" if how == "list" and not bytes_ | text else ""))
                else:
                    kind = kind if kind in ("number", "boolean", "BodyLike") else f"Input<{kind}>"
                    kind = "World" if how == "handle" else kind
                    mark = "?" if how == "maybe" and given in ("query", "which", "flags", "options",
                                                               "view") else ""
                    arguments.append(
                        f"{given if given != 'except' else 'left'}{mark}: {kind}"
                        + ("[]" if how == "array" else ""))
            result = results[0] if results else "void"
            doc = doc.replace("may be null", "may be left out")
            called = name.replace("Body", "") if owner == "Body" else name
            yield (f"  /** {doc} */\n" if doc else "") + \
                f"  {called}({', '.join(arguments)}): {result};\n"

    def check(self):
        yield "// Written by layout.py from kodo.h.\n#include <kodo.h>\n\n#include <cstddef>\n"
        for name, struct in self.header.structs.items():
            yield f"static_assert(sizeof(kodo_{name}) == {struct['size']}, \"{name}\");\n"
            for field in struct["fields"]:
                if field["kind"] != "union":
                    yield (f"static_assert(offsetof(kodo_{name}, {field['name']}) == "
                           f"{field['offset']}, \"{name}.{field['name']}\");\n")
            for choice, _ in struct["choices"] or ():
                offset = next(f["offset"] for f in struct["fields"] if f["kind"] == "union")
                yield (f"static_assert(offsetof(kodo_{name}, {choice}) == {offset}, "
                       f"\"{name}.{choice}\");\n")


def owner_of(parameters):
    """World, Body, or nothing: whose method a function is."""
    kinds = [(how, code, given) for how, code, given in parameters]
    if not kinds or kinds[0][:2] != ["handle", "World"] and kinds[0][:2] != ("handle", "World"):
        return None
    second = kinds[1] if len(kinds) > 1 else (None, None, None)
    own = second[0] == "in" and second[1] == "BodyId" and second[2] in ("id", "into", "body")
    return "Body" if own else "World"


def main():
    header = Header(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    package, build = (pathlib.Path(argument) for argument in sys.argv[2:])
    package.mkdir(parents=True, exist_ok=True)
    writer = Writer(header)
    exports = (f"_{name}\n" for name in ["malloc", "free", *header.exported])
    for path, lines in ((package / "layout.js", writer.javascript()),
                        (package / "layout.d.ts", writer.types()),
                        (build / "layout_check.cpp", writer.check()),
                        (build / "exports.txt", exports)):
        path.write_text("".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
