#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the pages of Markdown as HTML: pages.py FOLDER. Knows what these pages use: headings,
paragraphs, lists, tables, code, pictures and links. A link to a file that is not among the pages
becomes a text. An example gets a button that runs it."""
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
CHAPTERS = 6  # a page with as many has a table of contents
RUN = ("<i>Run</i> starts the program in this page, as WebAssembly, and compares its text with the one below, "
       "which the native program has printed.")
NOT_HERE = {"draw_world": "a window", "threads": "threads"}
STYLE = """
:root { color-scheme: light dark; font: 17px/1.5 system-ui, sans-serif; }
body { margin: 0 auto; padding: 1rem; max-width: 56rem; overflow-wrap: break-word; }
output { margin-left: .5rem; } button { font: inherit; min-height: 2.4rem; padding: .2rem 1rem; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
td, th { border: 1px solid #8886; padding: .25rem .5rem; text-align: left; vertical-align: top; }
pre { overflow-x: auto; padding: .75rem; background: #8882; border-radius: .5rem; }
.contents { columns: 14rem; padding-left: 1.2rem; }
@media (max-width: 600px) { /* for fingers */
  nav a, .pages a { display: inline-block; padding: .4rem 0; vertical-align: top; }
}
code { font-size: .92em; } img { max-width: 100%; height: auto; }
"""


class Page:
    def __init__(self, source, folder):
        self.source = ROOT / source
        self.folder = folder
        self.ids = set()
        self.chapters = []  # links

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
        words = self.inline(text)
        if level == 2:
            self.chapters.append(f'<li><a href="#{unique}">{re.sub("</?a[^>]*>", "", words)}</a></li>')
        return f'<h{level} id="{unique}">{words}</h{level}>'

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

    def example(self, name, lines):
        """The part of a program: its source, a button that runs it, its picture and its text."""
        source = (ROOT / "engine/examples" / f"{name}.cpp").read_text(encoding="utf-8")
        runs = name not in NOT_HERE
        button = (f'<p><button data-run="{name}" aria-label="Run {name}">Run</button><output role="status"></output></p>' if runs
                  else f"<p>It needs {NOT_HERE[name]}, and so it does not run in this page.</p>")
        inner = "\n".join(self.blocks("\n".join(lines))).replace("<pre>", '<pre class="printed">', 1)
        return (f'<section id="box-{name}">\n{button}\n{inner}\n<details><summary>{name}.cpp</summary>'
                f"<pre><code>{html.escape(source)}</code></pre></details>\n</section>")

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
                if program := re.match(r"### \[(\w+)\.cpp\]", line):
                    while end < len(lines) and not re.match(r"#+ ", lines[end]):
                        end += 1
                    yield self.example(program[1], lines[i + 1:end])
            elif image := re.match(r'<img src="([^"]+)" (alt="[^"]*" (?:width|height)="\d+")>$', line):
                yield f'<p><img src="{self.target(image[1])}" {image[2]}></p>'
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
        heading, *rest = self.blocks(text)
        if len(self.chapters) >= CHAPTERS:
            heading += f'\n<nav aria-label="Contents"><ul class="contents">{"".join(self.chapters)}</ul></nav>'
        body = "\n".join([heading, *rest])
        if "data-run" in body:
            body = body.replace("</h1>", f"</h1>\n<p>{RUN}</p>", 1) + '\n<script src="run.js"></script>'
        return title, frame(title, f'<nav><a href="../">Kodo</a> · <a href="./">all pages</a></nav>\n{body}')


def witness(folder):
    """The page beside Box2D: the whole one, if tools/crosscheck has made it, else its picture."""
    made = ROOT / "build/crosscheck/crosscheck.html"
    if made.exists():
        shutil.copy(made, folder / "witness.html")
        return
    shutil.copy(ROOT / "engine/docs/crosscheck.svg", folder)
    title = "Kodo beside Box2D 2.4.1"
    body = (f'<nav><a href="../">Kodo</a> · <a href="./">all pages</a></nav>\n<h1>{title}</h1>\n'
            "<p>Scenes with a closed form or a stated expectation, played by three profiles of Kodo in "
            "float and double, and by Box2D. The tests judge each figure. Four of them:</p>\n"
            f'<img src="crosscheck.svg" alt="{title} in four scenes">\n'
            "<p><code>tools/crosscheck</code> makes the page of all scenes, in which each can be played; "
            "<code>tools/web</code> then puts it here.</p>")
    (folder / "witness.html").write_text(frame(title, body), encoding="utf-8")


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
    witness(folder)
    entries.append('<li><a href="witness.html">Kodo beside Box2D 2.4.1, scene by scene</a></li>')
    redone = ROOT / "build/thesis/index.html"
    if redone.exists():  # tools/thesis has made it
        shutil.copy(redone, folder / "thesis-redone.html")
        entries.append('<li><a href="thesis-redone.html">The thesis, redone by Kodo</a></li>')
    body = '<nav><a href="../">Kodo</a></nav>\n<h1>Pages</h1>\n<ul class="pages">' + "\n".join(entries) + "</ul>"
    (folder / "index.html").write_text(frame("Pages", body), encoding="utf-8")


if __name__ == "__main__":
    main()
