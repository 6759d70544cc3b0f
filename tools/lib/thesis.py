# SPDX-License-Identifier: MIT
"""The page of tools/thesis: reads the JSON of build/bench/bin/thesis_lab, writes HTML."""
import json
import math
import pathlib
import re
import subprocess
import sys

import crosscheck
from crosscheck import escape, number, ticks
from options import Options
from thesis_words import FIGURES, OTHERS, SECTIONS

PAGE = pathlib.Path("build/thesis/index.html")
PROGRAM = pathlib.Path("build/bench/bin/thesis_lab")
COLOURS = ("#1f6feb", "#d1570b", "#2da44e", "#8250df")
DASHES = ("", "7 4", "2 3", "9 3 2 3")
# Numbers that do not hold today, by section, words of the row and setting, and what is known of
# them. A new one fails the test of this page, and so does one that holds again.
KNOWN = (
    ("plate", "contact points, turned by 5°", "collide()",
     "Kodo keeps two points where a whole side of the box has passed the plate."),
)
STYLE_SHEET = """
:root { color-scheme: light dark; }
figure { margin: 0; flex: 1 1 260px; min-width: 0; max-width: 400px; }
figure.chart { flex-grow: 2; max-width: 520px; }
a { color: #0969da; }
ul { columns: 2; padding-left: 18px; }
figure svg { width: 100%; border-radius: 4px; }
figcaption { font-size: 13px; color: #57606a; margin-top: 4px; }
.shown { display: flex; gap: 18px; flex-wrap: wrap; margin-top: 12px; }
.chart text { font-size: 12px; fill: #57606a; }
.chart .grid { stroke: #d0d7de; stroke-width: 0.7; fill: none; }
td.holds { color: #116329; font-weight: 600; }
td.first { min-width: 200px; }
p { overflow-wrap: break-word; }
@media (max-width: 760px) {
  main { padding: 8px; }
  section, .intro { padding: 12px; }
  h1 { font-size: 22px; }
  nav, ul { columns: 1; }
  td:nth-child(3)::before { content: "measured "; color: #8c959f; }
  td:nth-child(4)::before { content: "law "; color: #8c959f; }
  table, tbody, tr { display: block; }
  th { display: none; }
  tr { border-bottom: 1px solid #d0d7de; padding: 6px 0; }
  td, td.first, td.reason { display: inline-block; border: 0; padding: 0 10px 0 0; min-width: 0;
                            white-space: normal; }
  td.first, td.reason { display: block; }
}
@media (prefers-color-scheme: dark) {
  body { background: #0d1117; color: #e6edf3; }
  section, .intro { background: #161b22; border-color: #30363d; }
  .name, .small, figcaption, th, td.reason { color: #9da7b3; }
  .chart text { fill: #9da7b3; }
  figure:not(.chart) svg { outline: 1px solid #30363d; }
  .chart .grid { stroke: #30363d; }
  th, td, tr { border-color: #30363d; }
  a, nav a { color: #58a6ff; }
  td.holds { color: #3fb950; }
  td.bad { background: #4b1113; color: #ffb3ad; }
  .good { background: #12361f; color: #7ee2a0; }
  .wrong { background: #4b1113; color: #ffb3ad; }
  .differ { background: #3d2f00; color: #f2cc60; }
}
"""


def holds(row):
    """True if the number lies in the range of its law; None if it has no law."""
    low, high, value = row["low"], row["high"], row["value"]
    if low is None and high is None:
        return None
    if value is None:  # not finite
        return False
    return (low is None or value >= low) and (high is None or value <= high)


def known(section, row):
    """What is known of a number that does not hold, or None."""
    for where, words, setting, reason in KNOWN:
        if where == section and words in row["what"] and setting == row["setting"]:
            return reason
    return None


def excess(row):
    """By how much a number misses its range: a text."""
    low, high, value = row["low"], row["high"], row["value"]
    if value is None:
        return "not finite"
    bound, word = (low, "below") if low is not None and value < low else (high, "above")
    if bound and not (float(value).is_integer() and float(bound).is_integer()):
        return f"{100 * abs(value - bound) / abs(bound):.3g} % {word} {number(bound)}"
    return f"{number(value)} instead of {number(bound)}"


def verdict(experiment):
    """(kind, words), from the numbers alone."""
    judged = [row for row in experiment["rows"] if holds(row) is not None]
    bad = [row for row in judged if not holds(row)]
    if not bad:
        return "good", f"confirmed: all {len(judged)} numbers hold"
    new = [row for row in bad if known(experiment["id"], row) is None]
    words = f"differs: {len(bad)} of {len(judged)} numbers do not hold"
    return ("wrong" if new else "differ"), words


def bounds(row):
    low, high = row["low"], row["high"]
    if low is None and high is None:
        return "not judged"
    if low is None:
        return f"≤ {number(high)}" if high else "0"
    if high is None:
        return f"≥ {number(low)}"
    return number(low) if low == high else f"{number(low)} to {number(high)}"


def table_row(experiment, row):
    good = holds(row)
    kind = {None: "unjudged", True: "holds", False: "bad"}[good]
    words = {None: "–", True: "holds", False: excess(row) if good is False else ""}[good]
    law = row["law"]
    reason = known(experiment["id"], row) if good is False else None
    unit = f' {escape(row["unit"])}' if row["unit"] else ""
    return (
        f'<tr><td class="words first">{escape(row["what"])}</td>'
        f'<td class="words">{escape(row["setting"])}</td>'
        f'<td>{number(row["value"])}{unit}</td><td>{bounds(row)}</td>'
        f'<td class="{kind}">{words}</td>'
        f'<td class="reason">{escape(law)}{"<br><b>Known:</b> " + escape(reason) if reason else ""}'
        "</td></tr>"
    )


def table(experiment):
    head = (
        '<tr><th class="words">number</th><th class="words">setting</th><th>measured</th>'
        '<th>law</th><th>verdict</th><th class="words">reason of the law</th></tr>'
    )
    rows = "".join(table_row(experiment, row) for row in experiment["rows"])
    return f"<table>{head}{rows}</table>"


def powers(low, high):
    """1, 2 and 5 times powers of ten within a range; only the powers, if that are many."""
    every = [m * 10.0**e for e in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
             for m in (1, 2, 5)]
    found = [value for value in every if low <= value <= high]
    few = [value for value in found if round(math.log10(value), 9).is_integer()]
    return found if len(found) <= 7 else few


class Axis:
    def __init__(self, values, start, end, logarithmic):
        self.logarithmic = logarithmic
        self.low, self.high = min(values), max(values)
        if not logarithmic:
            self.low = min(0, self.low) if self.low < 0.5 * self.high else self.low
            pad = 0.05 * (self.high - self.low or 1)
            self.high += pad
        else:
            self.low, self.high = self.low / 1.2, self.high * 1.2
        self.start, self.end = start, end

    def __call__(self, value):
        scale = math.log if self.logarithmic else float
        share = (scale(value) - scale(self.low)) / (scale(self.high) - scale(self.low))
        return self.start + (self.end - self.start) * share

    def ticks(self):
        return powers(self.low, self.high) if self.logarithmic else ticks(self.low, self.high, 5)


def chart(one, width=460, height=280):
    logarithmic = one["logarithmic"]
    curves = [
        {**curve, "points": [p for p in curve["points"] if not logarithmic or min(p) > 0]}
        for curve in one["curves"]
    ]
    points = [p for curve in curves for p in curve["points"]]
    legend = 18 * len(curves)
    across = Axis([p[0] for p in points], 56, width - 14, logarithmic)
    up = Axis([p[1] for p in points], height - 40, 26 + legend, logarithmic)
    inner = ""
    for value in up.ticks():
        y = up(value)
        inner += f'<path class="grid" d="M56 {y:.1f}H{width - 14}"/>'
        inner += f'<text x="50" y="{y + 4:.1f}" text-anchor="end">{number(value)}</text>'
    for value in across.ticks():
        x = across(value)
        inner += f'<path class="grid" d="M{x:.1f} {26 + legend}V{height - 40}"/>'
        inner += f'<text x="{x:.1f}" y="{height - 24}" text-anchor="middle">{number(value)}</text>'
    inner += f'<text x="{width - 14}" y="{height - 6}" text-anchor="end">{escape(one["across"])}</text>'
    inner += f'<text x="4" y="14">{escape(one["up"])}</text>'
    for i, curve in enumerate(curves):
        look = f'stroke="{COLOURS[i]}" stroke-width="2" stroke-dasharray="{DASHES[i]}" fill="none"'
        inner += f'<path d="M56 {28 + 18 * i}h28" {look}/>'
        inner += f'<text x="90" y="{32 + 18 * i}">{escape(curve["name"])}</text>'
        line = " ".join(f"{across(x):.1f},{up(y):.1f}" for x, y in curve["points"])
        inner += f'<polyline points="{line}" {look}/>'
        if len(curve["points"]) <= 24:
            for x, y in curve["points"]:
                inner += f'<circle cx="{across(x):.1f}" cy="{up(y):.1f}" r="3" fill="{COLOURS[i]}"/>'
    return (
        f'<figure class="chart"><svg viewBox="0 0 {width} {height}" role="img"'
        f' aria-label="{escape(one["caption"])}">{inner}</svg>'
        f'<figcaption>{escape(one["caption"])}</figcaption></figure>'
    )


def picture(one):
    svg = re.sub(r"<\?xml.*?\?>\s*", "", one["svg"])
    svg = svg.replace("<svg ", f'<svg role="img" aria-label="{escape(one["caption"])}" ', 1)
    return f'<figure>{svg}<figcaption>{escape(one["caption"])}</figcaption></figure>'


def section(words, experiment):
    kind, judged = verdict(experiment)
    shown = "".join(map(picture, experiment["pictures"])) + "".join(map(chart, experiment["charts"]))
    return (
        f'<section id="{words.id}"><h2>{escape(words.title)}</h2>'
        f'<div class="name">{escape(words.where)}</div>'
        f"<p><b>The thesis:</b> {escape(words.says)}</p><p><b>Here:</b> {escape(words.shows)}</p>"
        f'<p><span class="verdict {kind}">{judged}</span></p>'
        f'<div class="shown">{shown}</div>{table(experiment)}</section>'
    )


def figures_list():
    """Each figure of the thesis, with its section or the reason why there is none."""
    entries = ""
    for figure in FIGURES:
        where = [words for words in SECTIONS if figure in words.figures]
        links = ", ".join(f'<a href="#{words.id}">{escape(words.title)}</a>' for words in where)
        if links or figure in OTHERS:
            entries += f"<li>Figure {figure}: {links or escape(OTHERS[figure])}</li>"
    entries += "".join(f"<li>Figures {name}: {escape(why)}</li>" for name, why in OTHERS.items()
                       if name not in FIGURES)
    return f'<ul class="small">{entries}</ul>'


def page(experiments, quick=False):
    by_id = {one["id"]: one for one in experiments}
    pairs = [(words, by_id[words.id]) for words in SECTIONS]
    kinds = [verdict(one)[0] for _, one in pairs]
    judged = sum(holds(row) is not None for _, one in pairs for row in one["rows"])
    bad = sum(holds(row) is False for _, one in pairs for row in one["rows"])
    summary = (f"{len(pairs)} figures and lessons with {judged} judged numbers: {kinds.count('good')}"
               f" are confirmed, {len(pairs) - kinds.count('good')} differ in {bad} numbers.")
    links = "".join(
        f'<a href="#{words.id}">{escape(words.title)}{"" if kind == "good" else " ≠"}</a>'
        for (words, _), kind in zip(pairs, kinds))
    short = " These are the short experiments of <code>--quick</code>." if quick else ""
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<link rel="icon" href="data:,"><title>The thesis, redone by Kodo</title>'
        f"<style>{crosscheck.STYLE_SHEET}{STYLE_SHEET}</style></head><body><main>"
        "<h1>The thesis, redone by Kodo</h1>"
        f'<div class="intro"><p><b>{summary}</b>{short}</p>'
        "<p>Anders Ekermo, <i>Rigid Body Physics In 2 Dimensions</i>, Bachelor’s thesis, Gotland"
        " University 2006, describes an engine and its lessons in figures and words. Each is"
        " measured here again, with the solver of the thesis (<code>thesis2006()</code>, with the"
        " passes that a row names) and with the default profile (<code>balanced()</code>), in"
        " float, at 60 steps a second where a row says no other. Nothing sleeps, but where resting"
        " is the subject.</p><p>A law gives each number its range, and the verdict follows from"
        " both. The thesis prints no tables and no times: shares of CPU time are given beside one"
        " lesson, and are not the same in each run. All other numbers are, on every machine.</p>"
        f'</div><div class="intro"><nav>{links}</nav>{figures_list()}</div>'
        + "".join(section(words, one) for words, one in pairs) + "</main></body></html>\n"
    )


def faults(experiments):
    """Sentences: what does not hold and is not known, what is known and holds, what is missing."""
    for one in experiments:
        for row in one["rows"]:
            if holds(row) is False and known(one["id"], row) is None:
                yield (f'{one["id"]}: {row["what"]} ({row["setting"]}): {excess(row)};'
                       f' {row["law"]}')
    for where, words, setting, _ in KNOWN:
        if not any(one["id"] == where and words in row["what"] and row["setting"] == setting
                   and holds(row) is False for one in experiments for row in one["rows"]):
            yield f"{where}: {words} ({setting}) holds: take it from KNOWN"
    for one in {words.id for words in SECTIONS} ^ {one["id"] for one in experiments}:
        yield f"{one}: a section without an experiment, or the other way round"
    for figure in FIGURES:
        if figure not in OTHERS and not any(figure in words.figures for words in SECTIONS):
            yield f"figure {figure} is in no section"


def main():
    options = Options("tools/thesis", add_help=False)
    options.add_argument("--output", type=pathlib.Path)
    options.add_argument("--quick", action="store_true")
    options.add_argument("--check-options", action="store_true")
    chosen = options.parse_args()
    if chosen.output and not chosen.output.parent.is_dir():
        options.error(f"there is no folder {chosen.output.parent}")
    if chosen.output and chosen.output.is_dir():
        options.error(f"{chosen.output} is a folder, not a file")
    if chosen.check_options:
        return 0
    print("Measuring, which takes half a minute.", flush=True)
    run = subprocess.run([PROGRAM, *(["--quick"] if chosen.quick else [])], stdout=subprocess.PIPE,
                         check=False)
    if run.returncode:
        sys.stderr.write(f"{PROGRAM} ended with {run.returncode}.\n")
        return 1
    experiments = json.loads(run.stdout)
    found = list(faults(experiments))
    output = chosen.output or PAGE
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(page(experiments, chosen.quick), encoding="utf-8")
    print(f"Written: {output} ({len(experiments)} figures and lessons)")
    for fault in found:
        print(f"Does not hold: {fault}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
