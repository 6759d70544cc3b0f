#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the pages of Markdown as HTML: pages.py FOLDER. Knows what these pages use: headings,
paragraphs, lists, tables, code, pictures and links. A link to a file that is not among the pages
becomes a text."""
import html
import os
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGES = {
    "manual": "engine/docs/manual.md", "cookbook": "engine/docs/cookbook.md",
    "faq": "engine/docs/faq.md", "features": "engine/docs/features.md",
    "examples": "engine/examples/README.md", "c": "engine/c/README.md",
    "python": "engine/python/README.md", "js": "engine/js/README.md",
    "solvers": "engine/docs/solvers.md", "tuning": "engine/docs/tuning.md",
    "glossary": "engine/docs/glossary.md", "lab": "engine/docs/lab.md",
    "worlds": "engine/docs/worlds.md", "engine": "engine/README.md", "game": "game/README.md",
} | {f"from-{path.stem}": f"engine/docs/migration/{path.name}"
     for path in sorted((ROOT / "engine/docs/migration").glob("*.md"))}
STYLE = """
:root { color-scheme: light dark; font: 17px/1.5 system-ui, sans-serif; }
body { margin: 0 auto; padding: 1rem; max-width: 56rem; overflow-wrap: break-word; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
td, th { border: 1px solid #8886; padding: .25rem .5rem; text-align: left; vertical-align: top; }
pre { overflow-x: auto; padding: .75rem; background: #8882; border-radius: .5rem; }
code { font-size: .92em; } img { max-width: 100%; height: auto; }
"""


class Page:
    def __init__(self, source, folder):
        self.source = ROOT / source
        self.folder = folder
        self.ids = set()

    def target(self, link):
        """Where a link of the page leads to in the folder, or None."""
        if link.startswith(("http", "#", "mailto:")):
            return link
        path, _, anchor = link.partition("#")
        full = (self.source.parent / path).resolve()
        named = os.path.relpath(full, ROOT)
        for name, source in PAGES.items():
            if named == source:
                return f"{name}.html" + (f"#{anchor}" if anchor else "")
        if full.is_file() and full.suffix in (".svg", ".png", ".gif"):
            shutil.copy(full, self.folder / full.name)
            return full.name
        return None

    def inline(self, text):
        kept = []

        def keep(made):
            kept.append(made)
            return f"\0{len(kept) - 1}\0"

        def link(match):
            target = self.target(match[2])
            words = html.escape(match[1], quote=False)
            return keep(f'<a href="{html.escape(target)}">{words}</a>' if target else words)

        def picture(match):
            target = self.target(match[2])
            words = html.escape(match[1])
            return keep(f'<img alt="{words}" src="{html.escape(target)}">' if target else words)

        text = re.sub(r"(`+)(.+?)\1", lambda m: keep(f"<code>{html.escape(m[2].strip())}</code>"), text)
        text = re.sub(r"!\[([^]]*)\]\(([^)\s]+)\)", picture, text)
        text = re.sub(r"\[([^]]*)\]\(([^)\s]+)\)", link, text)
        text = html.escape(text, quote=False)
        text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text)
        text = re.sub(r"(?<![\w*])\*([^*\s][^*]*)\*(?![\w*])", r"<i>\1</i>", text)
        while "\0" in text:
            text = re.sub(r"\0(\d+)\0", lambda m: kept[int(m[1])], text)
        return text

    def heading(self, line):
        level, text = len(line) - len(line.lstrip("#")), line.lstrip("#").strip()
        name = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
        unique = next(each for each in [name] + [f"{name}-{i}" for i in range(1, 99)]
                      if each not in self.ids)
        self.ids.add(unique)
        return f'<h{level} id="{unique}">{self.inline(text)}</h{level}>'

    def table(self, lines):
        rows = [[self.inline(cell.strip().replace("\\|", "|")) for cell in
                 re.split(r"(?<!\\)\|", line.strip().strip("|"))] for line in lines]
        head = "".join(f"<th>{cell}</th>" for cell in rows[0])
        body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>\n"
                       for row in rows[2:])
        return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}</tbody></table>"

    def list(self, lines, kind):
        """Items with the lines that belong to them."""
        items = []
        for line in lines:
            if re.match(r"([-*]|\d+\.) ", line):
                items.append([re.sub(r"^([-*]|\d+\.) ", "", line)])
            else:
                items[-1].append(line.strip() if not re.match(r" +([-*]|\d+\.) ", line) else line[2:])
        made = []
        for item in items:
            inner = next((i for i, line in enumerate(item) if i and re.match(r" *[-*] ", line)),
                         len(item))
            text = self.inline(" ".join(item[:inner]))
            rest = [line.strip() for line in item[inner:]]
            made.append(f"<li>{text}{self.list(rest, 'ul') if rest else ''}</li>")
        return f"<{kind}>" + "\n".join(made) + f"</{kind}>"

    def blocks(self, text):
        lines, i = text.split("\n"), 0
        while i < len(lines):
            line = lines[i]
            end = i + 1
            if line.startswith("```"):
                while not lines[end].startswith("```"):
                    end += 1
                yield "<pre><code>" + html.escape("\n".join(lines[i + 1:end])) + "</code></pre>"
                end += 1
            elif re.match(r"#+ ", line):
                yield self.heading(line)
            elif line.startswith("|"):
                while end < len(lines) and lines[end].startswith("|"):
                    end += 1
                yield self.table(lines[i:end])
            elif item := re.match(r"([-*]|\d+\.) ", line):
                while end < len(lines) and re.match(r"([-*]|\d+\.) | +\S", lines[end]):
                    end += 1
                yield self.list(lines[i:end], "ol" if item[1][0].isdigit() else "ul")
            elif line.strip():
                while end < len(lines) and lines[end].strip() and not re.match(
                        r"```|#+ |\||[-*] |\d+\. ", lines[end]):
                    end += 1
                yield f"<p>{self.inline(' '.join(lines[i:end]))}</p>"
            i = end

    def written(self):
        text = self.source.read_text(encoding="utf-8")
        title = re.search(r"^# (.+)$", text, re.MULTILINE)[1]
        body = "\n".join(self.blocks(text))
        return title, frame(title, f'<nav><a href="../">Kodo</a> · <a href="./">all pages</a></nav>\n{body}')


def frame(title, body):
    return ('<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f"<title>{html.escape(re.sub('[`*]', '', title))}</title>\n"
            f'<link rel="icon" href="data:,">\n<style>{STYLE}</style>\n</head>\n<body>\n{body}\n'
            "</body>\n</html>\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    entries = []
    for name, source in PAGES.items():
        title, text = Page(source, folder).written()
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
        entries.append(f'<li><a href="{name}.html">{html.escape(re.sub("[`*]", "", title))}</a></li>')
    body = '<nav><a href="../">Kodo</a></nav>\n<h1>Pages</h1>\n<ul>' + "\n".join(entries) + "</ul>"
    (folder / "index.html").write_text(frame("Pages", body), encoding="utf-8")


if __name__ == "__main__":
    main()
