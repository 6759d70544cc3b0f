# SPDX-License-Identifier: MIT
"""The page of tools/crosscheck: reads the JSON of build/bench/bin/crosscheck, writes HTML."""
import html
import json
import math
import pathlib
import re
import subprocess
import sys

import box2d3
import crosscheck_player
from crosscheck_verdicts import BOX2D, is_kodo, judged, nearer, score, verdict
from options import Options

INK, FAINT, GREY = "#24292f", "#d0d7de", "#57606a"
# Colour, dash, width and opacity of each play, in the order of the program. Later lines cover
# earlier ones where they agree, so they are narrower; doubles are dotted.
STYLES = (
    ("balanced, float", "#1f6feb", "", 8, 0.4),
    ("balanced, double", "#8250df", "1.5 5", 6.4, 1),
    ("accurate, float", "#1b9aaa", "", 4.4, 1),
    ("accurate, double", "#7a5c2e", "1.5 5", 3.4, 1),
    ("thesis2006, float", "#2da44e", "", 2.2, 1),
    ("thesis2006, double", "#bf3989", "1.5 5", 2, 1),
    ("Box2D 2.4.1", "#d1570b", "7 5", 1.6, 1),
    ("Box2D 3", "#111111", "9 3 2 3", 1.4, 1),
)
PICTURE = (  # scenes of the picture in .github/CONTRIBUTING.md
    "SpinningBarThrowsABall",
    "BallBouncesAtRestitution08",
    "BoxOnItsCornerTipsOverAndLiesFlat",
    "BallThroughPinsBouncesAndFallsOut",
)
CHARTED = ("BallBouncesAtRestitution08",)  # over time instead of in the plane
STYLE_SHEET = """
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #24292f; margin: 0;
       background: #f6f8fa; }
main { max-width: 1400px; margin: 0 auto; padding: 24px; }
h1 { font-size: 26px; margin: 8px 0; }
h2 { font-size: 18px; margin: 0 0 4px; }
section, .intro { background: white; border: 1px solid #d0d7de; border-radius: 8px;
                  padding: 18px 20px; margin: 18px 0; }
.name { color: #57606a; font: 12px ui-monospace, "DejaVu Sans Mono", monospace; }
.top { display: flex; gap: 24px; align-items: flex-start; flex-wrap: wrap; }
.top > div { flex: 1 1 340px; }
svg { display: block; max-width: 100%; height: auto; }
table { border-collapse: collapse; width: 100%; font-size: 13px; margin-top: 12px; }
th { text-align: right; font-weight: 600; color: #57606a; border-bottom: 2px solid #d0d7de;
     padding: 4px 8px; vertical-align: bottom; }
td { text-align: right; border-bottom: 1px solid #eaeef2; padding: 4px 8px; vertical-align: top;
     font-variant-numeric: tabular-nums; white-space: nowrap; }
td.words, th.words { text-align: left; white-space: normal; }
td.reason { text-align: left; white-space: normal; color: #57606a; min-width: 200px; }
td.first { min-width: 150px; }
td.rule { text-align: left; }
td.far { color: #bc4c00; font-weight: 600; }
td.bad { background: #ffebe9; color: #cf222e; font-weight: 600; }
td.unjudged { color: #8c959f; }
.verdict { display: inline-block; border-radius: 10px; padding: 1px 10px; font-size: 13px;
           font-weight: 600; }
.good { background: #dafbe1; color: #116329; }
.wrong { background: #ffebe9; color: #cf222e; }
.differ { background: #fff8c5; color: #7d4e00; }
.legend span { margin-right: 18px; white-space: nowrap; }
nav { columns: 2; font-size: 14px; }
nav a { display: block; color: #0969da; text-decoration: none; break-inside: avoid; }
.small { font-size: 13px; color: #57606a; }
table.hits { width: auto; }
.wide { overflow-x: auto; }
.tolerance { color: #8c959f; font-size: 11px; font-weight: 400; }
.scores .verdict { font-size: 12px; padding: 0 8px; }
"""
RULES = {
    "exact": "Kodo and 2.4.1 = form",
    "kodo": "Kodo = form",
    "agree": "Kodo = 2.4.1",
    "most": "Kodo at most",
    "show": "not judged",
}


def escape(text):
    return html.escape(text, quote=True)


def number(value):
    if value is None:
        return "–"
    if value == 0:
        return "0"
    if abs(value) < 1e-3 or abs(value) >= 1e5:
        mantissa, exponent = f"{value:.2e}".split("e")
        return f"{mantissa}e{int(exponent)}".replace("-", "−")
    return f"{value:.5g}".replace("-", "−")


def place(body):
    (x, y), (c, s) = body["position"], body["rotation"]
    return lambda p: (x + c * p[0] - s * p[1], y + s * p[0] + c * p[1])


def frame_at(body, point):
    """The frame of the shapes when the centre of mass is at a point of a track."""
    _, x, y, angle = point
    c, s = math.cos(angle), math.sin(angle)
    cx, cy = body["center"]
    origin = (x - c * cx + s * cy, y - s * cx - c * cy)
    return {**body, "position": origin, "rotation": (c, s)}


def outline(body):
    """Points (m) that span the shapes of a body."""
    put = place(body)
    for part in body["parts"]:
        if "radius" in part:
            x, y = put(part["center"])
            r = part["radius"]
            yield from ((x - r, y - r), (x + r, y + r))
        else:
            yield from map(put, part["corners"])


def extent(scene):
    """The box (m) of the paths, with the bodies at both ends."""
    points = []
    for play in scene["plays"]:
        if play["name"].startswith("thesis") or play["lacks"]:
            continue  # what falls over must not shrink what stands
        for track in play["tracks"]:
            body = scene["bodies"][track["body"]]
            points += [(x, y) for _, x, y, _ in track["points"]]
            points += outline(body)
            points += outline(frame_at(body, track["points"][-1]))
    xs, ys = zip(*points)
    left, right, low, high = min(xs), max(xs), min(ys), max(ys)
    pad = 0.06 * max(right - left, high - low, 0.5)
    return left - pad, right + pad, low - pad, high + pad


class View:
    """Metres to pixels, with equal scales on both axes."""

    def __init__(self, box, width, height):
        left, right, low, high = box
        self.scale = min(width / (right - left), height / (high - low))
        self.left = (left + right) / 2 - width / 2 / self.scale
        self.top = (low + high) / 2 + height / 2 / self.scale
        self.width, self.height = width, height

    def at(self, p):
        return ((p[0] - self.left) * self.scale, (self.top - p[1]) * self.scale)


def shapes(view, body, look):
    put = place(body)
    result = ""
    for part in body["parts"]:
        if "radius" in part:
            x, y = view.at(put(part["center"]))
            result += f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{part["radius"] * view.scale:.1f}" {look}/>'
        else:
            points = " ".join("%.1f,%.1f" % view.at(put(c)) for c in part["corners"])
            result += f'<polygon points="{points}" {look}/>'
    return result


def path(view, points):
    """Drops points that are nearer than half a pixel to the last one."""
    kept = []
    for _, x, y, _ in points:
        p = view.at((x, y))
        if not kept or math.dist(kept[-1], p) >= 0.5:
            kept.append(p)
    if len(kept) == 1:
        kept.append((kept[0][0] + 0.1, kept[0][1]))
    return " ".join("%.1f,%.1f" % p for p in kept)


def ruler(view):
    length = max(
        s for s in (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50) if s * view.scale <= 120
    )
    x, y = 10, view.height - 10
    right = x + length * view.scale
    return (
        f'<path d="M{x} {y - 4}V{y}H{right:.1f}V{y - 4}" fill="none" stroke="{GREY}"/>'
        f'<text x="{right + 6:.1f}" y="{y}" font-size="12" fill="{GREY}"'
        f' stroke="white" stroke-width="3" paint-order="stroke">{length:g} m</text>'
    )


def drawing(scene, width=520, height=330):
    view = View(extent(scene), width, height)
    drawn = {track["body"] for track in scene["plays"][0]["tracks"]}
    inner = f'<rect width="{width}" height="{height}" fill="white"/>'
    for i, body in enumerate(scene["bodies"]):
        fill = "#d8dee4" if body["locked"] else "#f6f8fa"
        inner += shapes(view, body, f'fill="{fill}" stroke="#8c959f" stroke-width="0.8"')
        if i in drawn and not body["locked"]:
            x, y = view.at(place(body)(body["center"]))
            inner += f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.2" fill="{GREY}"/>'
    for chain in scene["chains"]:
        points = " ".join("%.1f,%.1f" % view.at(p) for p in chain)
        inner += f'<polyline points="{points}" fill="none" stroke="#8c959f" stroke-width="1.5"/>'
    paths = ends = ""
    for play, (_, colour, dash, stroke, opacity) in zip(scene["plays"], STYLES):
        for track in play["tracks"]:
            body = scene["bodies"][track["body"]]
            if "double" not in play["name"] and not body["locked"]:
                ends += shapes(
                    view,
                    frame_at(body, track["points"][-1]),
                    f'fill="{colour}" fill-opacity="0.06" stroke="{colour}" stroke-width="1"'
                    f' stroke-dasharray="{dash}"',
                )
            paths += (
                f'<polyline points="{path(view, track["points"])}" fill="none" stroke="{colour}"'
                f' stroke-width="{stroke}" stroke-opacity="{opacity}" stroke-dasharray="{dash}"'
                ' stroke-linejoin="round"/>'
            )
    inner += f'<g class="ends">{ends}</g><g class="paths">{paths}</g>{ruler(view)}'
    inner += (
        f'<rect x="0.5" y="0.5" width="{width - 1}" height="{height - 1}" fill="none"'
        f' stroke="{FAINT}"/>'
    )
    return (
        f'<svg viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img"'
        f' aria-label="Paths of {escape(scene["title"])}">{inner}</svg>'
    )


def ticks(low, high, most):
    """Round numbers within a range, at most so many."""
    size = 10 ** math.floor(math.log10((high - low) / most))
    step = next(size * k for k in (1, 2, 5, 10, 20) if (high - low) / (size * k) <= most)
    first = math.ceil(low / step)
    return [k * step for k in range(first, math.floor(high / step) + 1)]


def moving_coordinate(scene):
    """The body and the coordinate (1: x, 2: y, 3: angle) that change most in the first play."""
    best = (-1, None, 1)
    for track in scene["plays"][0]["tracks"]:
        for axis in (1, 2, 3):
            values = [p[axis] for p in track["points"]]
            spread = (max(values) - min(values)) * (0.2 if axis == 3 else 1)
            if spread > best[0] + 1e-9:
                best = (spread, track["body"], axis)
    return best[1], best[2]


def chart(scene, width=560, height=230):
    """One coordinate over time, in all plays."""
    body, axis = moving_coordinate(scene)
    lines = []
    for play in scene["plays"]:
        points = next((t["points"] for t in play["tracks"] if t["body"] == body), [])
        lines.append([(p[0], p[axis]) for p in points])
    seen = lines[0] + lines[1] + lines[BOX2D]  # what falls in other plays is cut off
    low, high = min(v for _, v in seen), max(v for _, v in seen)
    pad = max(0.08 * (high - low), 1e-3)
    low, high, end = low - pad, high + pad, max(t for t, _ in seen)
    left, right, top, bottom = 52, width - 10, 24, height - 30

    def at(time, value):
        return (
            left + (right - left) * time / end,
            bottom - (bottom - top) * (value - low) / (high - low),
        )

    what = {1: "x (m)", 2: "height (m)", 3: "angle (rad)"}[axis]
    inner = f'<rect width="{width}" height="{height}" fill="white"/>'
    grid = f'stroke="{FAINT}" stroke-width="0.7"'
    for value in ticks(low, high, 5):
        y = at(0, value)[1]
        inner += f'<path d="M{left} {y:.1f}H{right}" {grid}/>'
        inner += (
            f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end" font-size="12"'
            f' fill="{GREY}">{number(round(value, 9))}</text>'
        )
    for time in ticks(0, end, 8):
        x = at(time, low)[0]
        inner += f'<path d="M{x:.1f} {top}V{bottom}" {grid}/>'
        inner += (
            f'<text x="{x:.1f}" y="{bottom + 16}" text-anchor="middle" font-size="12"'
            f' fill="{GREY}">{number(round(time, 9))}</text>'
        )
    inner += f'<text x="{left}" y="15" font-size="12" fill="{INK}">{what} of body {body}</text>'
    inner += f'<text x="{right}" y="{height - 2}" font-size="12" text-anchor="end"'
    inner += f' fill="{GREY}">time (s)</text>'
    clip = f"clip-{scene['name']}"
    inner += f'<clipPath id="{clip}"><rect x="{left}" y="{top}" width="{right - left}"'
    inner += f' height="{bottom - top}"/></clipPath><g clip-path="url(#{clip})">'
    for line, (_, colour, dash, stroke, opacity) in zip(lines, STYLES):
        kept = []
        for time, value in line:
            p = at(time, value)
            if not kept or math.dist(kept[-1], p) >= 1:
                kept.append(p)
        inner += (
            f'<polyline points="{" ".join("%.1f,%.1f" % p for p in kept)}" fill="none"'
            f' stroke="{colour}" stroke-width="{stroke}" stroke-opacity="{opacity}"'
            f' stroke-dasharray="{dash}" stroke-linejoin="round"/>'
        )
    inner += "</g>"
    return (
        f'<svg viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img"'
        f' aria-label="{what} over time">{inner}</svg>'
    )


def scores(scene):
    """The verdict of each engine, in one line."""
    result = []
    for index, play in enumerate(scene["plays"]):
        if play["lacks"]:
            result.append(f'{play["name"]}: not played, {escape(play["lacks"])}')
            continue
        good, count = score(scene, index)
        kind = "good" if good == count else "wrong" if is_kodo(play) else "differ"
        result.append(f'<span class="verdict {kind}">{play["name"]} {good}/{count}</span>')
    return '<p class="small scores">Figures within the tolerance of each: ' + " ".join(result) + "</p>"


def cell(figure, index, play):
    result = figure["results"][index]
    if result is None:
        return "<td>–</td>"
    one = judged(figure, index)
    kind = "" if one and one[2] else "unjudged" if not one else "bad" if is_kodo(play) else "far"
    tolerance = f'<br><span class="tolerance">± {number(one[1])}</span>' if one and one[1] else ""
    return f'<td class="{kind}">{number(result["value"])}{tolerance}</td>'


def row(figure, plays):
    unit = f' <span class="small">{escape(figure["unit"])}</span>' if figure["unit"] else ""
    cells = f'<td class="words first">{escape(figure["what"])}{unit}</td>'
    cells += "".join(cell(figure, i, play) for i, play in enumerate(plays))
    exact = number(figure["exact"]) if figure["rule"] in ("exact", "kodo", "most") else ""
    exact = "≤ " + exact if figure["rule"] == "most" else exact
    stated = "" if figure["rule"] in ("show", "most") else f'± {number(figure["tolerance"])}: '
    reason = stated + escape(figure["reason"])
    for name, tolerance, words in figure["reasons"]:
        wide = "not judged" if tolerance < 0 else "± " + number(tolerance)
        reason += f"<br>{name}: {wide}; {escape(words)}"
    cells += f'<td>{exact}</td><td class="rule">{RULES[figure["rule"]]}</td>'
    return f'<tr>{cells}<td class="reason">{reason}</td></tr>'


def figures(scene):
    names = "".join(f'<th>{play["name"].replace(", ", "<br>").replace("Box2D ", "Box2D<br>")}</th>'
                    for play in scene["plays"])
    head = (
        f'<tr><th class="words">figure</th>{names}<th>closed<br>form</th>'
        '<th class="words">must agree</th><th class="words">stated tolerance</th></tr>'
    )
    rows = "".join(row(f, scene["plays"]) for f in scene["figures"])
    return f'<div class="wide"><table>{head}{rows}</table></div>'


def hits(scene):
    """The first impacts in float and in Box2D, side by side."""
    rows = ""
    shown = [play for play in scene["plays"]
             if not play["lacks"] and not play["name"].endswith("double")
             and not play["name"].startswith("accurate")]
    for i in range(max(len(play["impacts"]) for play in shown)):
        cells = ""
        for play in shown:
            if i < len(play["impacts"]):
                time, a, b, impulse = play["impacts"][i]
                cells += f"<td>{time:.3f}</td><td>{a}–{b}</td><td>{number(impulse)}</td>"
            else:
                cells += "<td></td><td></td><td></td>"
        rows += f"<tr>{cells}</tr>"
    if not rows:
        return '<p class="small">No impacts.</p>'
    head = "".join(
        f'<th colspan="3" style="text-align:center">{play["name"]}</th>' for play in shown
    )
    units = "<th>s</th><th>bodies</th><th>N s</th>" * len(shown)
    return (
        '<p class="small" style="margin-bottom:0">First impacts: end of the step, bodies, impulse'
        f' of that step.</p><div class="wide"><table class="hits"><tr>{head}</tr><tr>{units}</tr>{rows}'
        "</table></div>"
    )


def section(scene):
    kind, words = verdict(scene)
    return (
        f'<section id="{scene["name"]}"><h2>{escape(scene["title"])}</h2>'
        f'<div class="name">{scene["name"]}</div>'
        f'<p>{escape(scene["text"])}</p>'
        f'<p><span class="verdict {kind}">{words}</span> {escape(scene["difference"])}'
        f' <span class="small">{nearer(scene)}</span></p>{scores(scene)}'
        f'<div class="top"><div><div class="stage">{drawing(scene)}<canvas></canvas></div>'
        f"{crosscheck_player.player(scene, View(extent(scene), 520, 330), styles_of(scene))}</div>"
        f"<div>{chart(scene)}{hits(scene)}</div></div>"
        f"{figures(scene)}</section>"
    )


def styles_of(scene):
    """The styles of what plays the scene: the order of its film."""
    return [style for style, play in zip(STYLES, scene["plays"]) if not play["lacks"]]


def legend(plays):
    result = ""
    for name, colour, dash, stroke, opacity in STYLES[: len(plays)]:
        result += (
            f'<span><svg style="display:inline;vertical-align:middle" width="46" height="10">'
            f'<path d="M1 5H45" stroke="{colour}" stroke-width="{stroke}"'
            f' stroke-opacity="{opacity}" stroke-dasharray="{dash}"/></svg>'
            f' {name if "Box2D" in name else "Kodo " + name}</span>'
        )
    return f'<p class="legend">{result}</p>'


def totals(scenes):
    """How many figures hold in each engine, over all scenes."""
    result = []
    for index, play in enumerate(scenes[0]["plays"]):
        pairs = [score(scene, index) for scene in scenes]
        good, count = (sum(pair[k] for pair in pairs) for k in (0, 1))
        result.append(f'{play["name"]} {good} of {count}')
    return f'<p>Figures within the tolerance of each engine: {"; ".join(result)}.</p>'


def page(scenes):
    kinds = [verdict(scene)[0] for scene in scenes]
    judged = sum(len(s["figures"]) for s in scenes)
    bad = kinds.count("wrong")
    summary = (
        f"{len(scenes)} scene{'s' if len(scenes) > 1 else ''} with {judged} figures: "
        f"{kinds.count('good')} agree in all, {kinds.count('differ')} hold with a known difference, "
        f"{bad} {'does' if bad == 1 else 'do'} not hold."
    )
    links = "".join(
        f'<a href="#{s["name"]}">{escape(s["title"])}'
        f'{" ✗" if kind == "wrong" else " ≠" if kind == "differ" else ""}</a>'
        for s, kind in zip(scenes, kinds)
    )
    has_v3 = len(scenes[0]["plays"]) > BOX2D + 1
    title = "Kodo beside Box2D 2.4.1" + (" and 3" if has_v3 else "")
    v3 = ", and by Box2D 3 with 4 substeps" if has_v3 else ""
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{title}</title><style>{STYLE_SHEET}{crosscheck_player.STYLE_SHEET}"
        "</style></head><body><main>"
        f"<h1>{title}</h1>"
        f"<div class=\"intro\"><p><b>{summary}</b></p>{totals(scenes)}"
        "<p>Each scene is played by Kodo with the profiles <code>balanced()</code>,"
        " <code>accurate()</code> and <code>thesis2006()</code>, in float and double, by Box2D 2.4.1"
        f" with 8 velocity and 3 position iterations{v3}. Steps of 1/60 s, where a scene"
        " says no other; nothing sleeps, but where sleep is the subject."
        " All mix restitution by the minimum, and boxes have equal size with the skin of 2.4.1."
        " <code>tests/cross</code> holds the scenes and judges the same figures.</p>"
        f"{legend(scenes[0]['plays'])}"
        '<p class="small">Light outlines: the start; coloured ones: the end. Lines are paths of'
        " centres of mass. Below each value: its tolerance. That of Kodo is ten times the error"
        " against the closed form that each profile was measured to have in each precision"
        " (<code>tests/cross/errors.txt</code>), or rounding if that is more, but never more than the"
        " stated one. For Box2D the stated one counts, or one of its own."
        ' <span style="color:#bc4c00;font-weight:600">Orange</span>: Box2D is farther from the closed'
        " form than its tolerance. Grey figures are not judged. Verdicts are computed from these"
        " figures.</p>"
        '<p class="small">Below each picture: ▶ (or the space key) plays it in real time; on the'
        " slider, the arrow keys go step by step. ▲ marks the time at which the play of that colour"
        " parts from <code>balanced()</code> in float, by 1 % of the picture.</p></div>"
        f'<div class="intro"><nav>{links}</nav></div>'
        f'{"".join(section(s) for s in scenes)}</main>{crosscheck_player.script()}</body></html>\n'
    )


def picture(scenes):
    """Four scenes in one SVG, with a legend."""
    by_name = {scene["name"]: scene for scene in scenes}
    width, height, gap = 400, 250, 12
    inner = ""
    for i, name in enumerate(PICTURE):
        scene = by_name[name]
        x, y = gap + i % 2 * (width + gap), 40 + i // 2 * (height + 34)
        shown = (chart if name in CHARTED else drawing)(scene, width, height)
        inner += (
            f'<text x="{x}" y="{y - 8}" font-size="14" font-weight="600" fill="{INK}">'
            f'{escape(scene["title"])}</text><g transform="translate({x} {y})">{shown}</g>'
        )
    bottom = 40 + 2 * (height + 34) - 10
    for i, (name, colour, dash, stroke, opacity) in enumerate(STYLES[: len(scenes[0]["plays"])]):
        label = name if "Box2D" in name else "Kodo " + name
        x, y = gap + i // 2 * 205, bottom + i % 2 * 20
        inner += (
            f'<path d="M{x} {y}h30" stroke="{colour}" stroke-width="{stroke}"'
            f' stroke-opacity="{opacity}" stroke-dasharray="{dash}"/>'
            f'<text x="{x + 36}" y="{y + 4}" font-size="12" fill="{INK}">{label}</text>'
        )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{2 * width + 3 * gap}"'
        f' height="{bottom + 40}" font-family="system-ui, DejaVu Sans, sans-serif">'
        f'<rect width="100%" height="100%" fill="white"/>{inner}</svg>\n'
    )


ERRORS = pathlib.Path("tests/cross/errors.txt")
PAGE = pathlib.Path("crosscheck.html")
NO_SCENE = "no scene's name or title contains {}; tools/crosscheck --list prints the names"


def texts_in_sources(folder=pathlib.Path("tests/cross"), files="scenes_*.cpp"):
    """All texts of the chapters, before the program is built."""
    sources = (path.read_text(encoding="utf-8") for path in sorted(folder.glob(files)))
    return [text for source in sources for text in re.findall(r'"([^"\n]*)"', source)]


def names_in_sources():
    """The names of all scenes: each CamelCase text."""
    return [t for t in texts_in_sources() if re.fullmatch("[A-Z][a-z]+[A-Z][A-Za-z0-9]+", t)]


SANDBOX = pathlib.Path("tools/destructoooor/catalogue")


def is_wanted(scene, wanted):
    return any(wanted.lower() in scene[key].lower() for key in ("name", "title"))


def refuse_early(options, chosen):
    """Wrong use that needs no build to be seen."""
    for file in filter(None, (chosen.output, chosen.picture)):
        if not file.parent.is_dir():
            options.error(f"there is no folder {file.parent}")
        if file.is_dir():
            options.error(f"{file} is a folder, not a file")
    if chosen.file:
        if chosen.scenes or chosen.list or chosen.picture:
            options.error("a file has one scene: give no --scenes, --list or --picture")
        if not chosen.file.is_file():
            options.error(f"there is no file {chosen.file}")
    if chosen.sandbox:
        if chosen.file or chosen.scenes or chosen.list or chosen.picture:
            options.error("--sandbox has one scene: give no file, --scenes, --list or --picture")
        names = texts_in_sources(SANDBOX, "*.cpp")
        if names and chosen.sandbox not in names:
            options.error(f"the sandbox has no scene {chosen.sandbox}; destructoooor --list names all")
    if chosen.list and (chosen.scenes or chosen.output or chosen.picture):
        options.error("--list writes no page: give no --scenes, --output or --picture")
    if chosen.errors and (chosen.file or chosen.sandbox or chosen.scenes or chosen.list
                          or chosen.output or chosen.picture):
        options.error("--errors measures all scenes and writes no page: give no other option")
    # Some titles are put together: each word is looked for, and the whole after the build.
    text = "\n".join(texts_in_sources()).lower()
    for wanted in (chosen.scenes or []) if text else []:
        if not all(word in text for word in wanted.lower().split()):
            options.error(NO_SCENE.format(wanted))


def write_errors(program):
    """Measures the errors of Kodo that its tolerances follow from."""
    head = [line for line in ERRORS.read_text(encoding="utf-8").splitlines() if line.startswith("#")]
    table = subprocess.run([program, "--errors"], stdout=subprocess.PIPE, check=True, text=True).stdout
    ERRORS.write_text("\n".join(head) + "\n" + table, encoding="utf-8")
    print(f"Written: {ERRORS} ({len(table.splitlines())} figures)")
    return 0


def main():
    options = Options("tools/crosscheck", add_help=False)
    options.add_argument("file", nargs="?", type=pathlib.Path)
    options.add_argument("--output", type=pathlib.Path)
    options.add_argument("--picture", type=pathlib.Path)
    options.add_argument("--scenes", nargs="+", metavar="NAME")
    options.add_argument("--sandbox", metavar="NAME")
    options.add_argument("--box2d3", metavar="DIR", type=box2d3.folder)  # the build has read it
    options.add_argument("--errors", action="store_true")
    options.add_argument("--list", action="store_true")
    options.add_argument("--program", type=pathlib.Path)  # for the test of this page
    options.add_argument("--check-options", action="store_true")
    chosen = options.parse_args()
    refuse_early(options, chosen)
    if chosen.list:
        print("\n".join(names_in_sources()))
        return 0
    if chosen.check_options:
        return 0
    program = chosen.program or pathlib.Path("build/bench/bin/crosscheck")
    if chosen.errors:
        return write_errors(program)
    one = chosen.file or chosen.sandbox
    command = [program, *(["--sandbox"] if chosen.sandbox else []), *([one] if one else [])]
    run = subprocess.run(command, stdout=subprocess.PIPE, check=False)
    if one and run.returncode == 2:
        return 2  # the program has told the mistakes
    if run.returncode not in (0, 1):
        sys.stderr.write(f"{program} ended with {run.returncode}.\n")
        return 1
    scenes = json.loads(run.stdout)
    if chosen.program and not one:  # the test of this page
        hidden = {scene["name"] for scene in scenes} - set(names_in_sources())
        if hidden and names_in_sources():
            sys.stderr.write(f"Not found in the sources: {', '.join(sorted(hidden))}\n")
            return 1
    if chosen.picture:
        chosen.picture.write_text(picture(scenes), encoding="utf-8")
        print(f"Written: {chosen.picture}")
    if chosen.scenes:
        for wanted in chosen.scenes:
            if not any(is_wanted(scene, wanted) for scene in scenes):
                options.error(NO_SCENE.format(wanted))
        scenes = [s for s in scenes if any(is_wanted(s, wanted) for wanted in chosen.scenes)]
    name = chosen.sandbox.replace(" ", "_") if chosen.sandbox else (chosen.file or PAGE).stem
    output = chosen.output or pathlib.Path("build/crosscheck", name + ".html")
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(page(scenes), encoding="utf-8")
    bad = [s["name"] for s in scenes if verdict(s)[0] == "wrong"]
    print(f"Written: {output} ({len(scenes)} scene{'s' if len(scenes) > 1 else ''})")
    for name in bad:
        print(f"Does not hold: {name}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
