# SPDX-License-Identifier: MIT
"""Pictures of tools/trade --dials: energy and momentum over time, and sweeps of single settings."""
import html
import json
import math
import pathlib
import subprocess
import typing

PROGRAM = pathlib.Path("build/bench/bin/conserve")
INK, FAINT, GREY = "#24292f", "#e4e8ec", "#57606a"
GAIN, LOSS = "#fdeeee", "#eef4fd"  # behind what is gained, and what is lost
WIDTH, HEIGHT = 400, 250  # of a panel
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 34, 40
SPAN = 1e-6  # of a logarithmic axis; what is smaller is drawn at its lower end


class Line(typing.NamedTuple):
    says: str
    colour: str
    dash: str
    points: list  # (x, y); y None: the scene is lost
    marks: bool = False


def ask(runs):
    """The answers of the program to (scene, {name: value})."""
    text = "".join(
        f"{scene} | " + " ".join(f"{k}={v}" for k, v in numbers.items()) + "\n"
        for scene, numbers in runs
    )
    run = subprocess.run([PROGRAM], input=text, stdout=subprocess.PIPE, text=True, check=True)
    return [json.loads(line) for line in run.stdout.splitlines()]


def plain(value):
    if value == 0:
        return "0"
    if abs(value) >= 1e4 or abs(value) < 1e-3:
        return f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e")
    return f"{value:.4g}"


class SignedAxis:
    """Maps changes to pixels: gains above a line, losses below it, each logarithmic from `least`
    on. What is smaller lies on the line."""

    def __init__(self, values, start, end):
        self.start, self.end = start, end
        top = max([abs(v) for v in values] or [1.0])
        self.high = 10 ** math.ceil(math.log10(max(top, 1e-8)))
        self.least = self.high * SPAN

    def __call__(self, value):
        size = min(abs(value), self.high) / self.least
        share = math.log(size) / math.log(self.high / self.least) if size > 1 else 0
        return (self.start + self.end) / 2 + math.copysign(share, value) * (self.end - self.start) / 2

    def ticks(self):
        decades = range(2, round(math.log10(1 / SPAN)) + 1, 2)
        sizes = [self.least * 10**k for k in decades]
        return [-v for v in reversed(sizes)] + [0] + sizes


class Axis:
    """Maps values to pixels, linear or logarithmic."""

    def __init__(self, values, start, end, log):
        self.log, self.start, self.end = log, start, end
        values = [v for v in values if not log or v > 0] or [1.0]
        low, high = min(values), max(values)
        if log:
            low = max(low, high * SPAN)  # rounding must not stretch the axis
            low, high = 10 ** math.floor(math.log10(low)), 10 ** math.ceil(math.log10(high))
            high = high if high > low else 10 * low
        elif high == low:
            high = low + 1
        self.low, self.high = low, high

    def __call__(self, value):
        value = min(max(value, self.low), self.high)
        if self.log:
            share = math.log(value / self.low) / math.log(self.high / self.low)
        else:
            share = (value - self.low) / (self.high - self.low)
        return self.start + share * (self.end - self.start)

    def ticks(self):
        if self.log:
            first, last = round(math.log10(self.low)), round(math.log10(self.high))
            step = max(1, math.ceil((last - first) / 6))
            return [10.0**k for k in range(first, last + 1, step)]
        size = 10 ** math.floor(math.log10((self.high - self.low) / 5))
        step = next(size * k for k in (1, 2, 5, 10) if (self.high - self.low) / (size * k) <= 6)
        first = math.ceil(self.low / step)
        return [k * step for k in range(first, math.floor(self.high / step + 1e-9) + 1)]


SIGNED = "signed"


def panel(title, across, up, lines, logs=(False, True), names=None):
    """One chart. What is lost is a cross at the top and stretches no axis. logs[1] may be SIGNED:
    gains apart from losses. `names`: of the whole numbers on the axis across."""
    signed = logs[1] == SIGNED
    held = [(x, y) for line in lines for x, y in line.points if y is not None]
    xs = [x for line in lines for x, _ in line.points]
    floor = 1e-9
    ys = [max(y, floor) if logs[1] and not signed else y for _, y in held]
    ax = Axis(xs, LEFT + (24 if names else 0), WIDTH - RIGHT - (24 if names else 0), logs[0])
    ay = (SignedAxis(ys, HEIGHT - BOTTOM, TOP) if signed
          else Axis(ys, HEIGHT - BOTTOM, TOP, logs[1]))
    out = ""
    if signed:
        half = (HEIGHT - BOTTOM - TOP) / 2
        for top, colour, word in ((TOP, GAIN, "gain"), (TOP + half, LOSS, "loss")):
            out += f'<rect x="{LEFT}" y="{top}" width="{WIDTH - RIGHT - LEFT}" height="{half}"'
            out += f' fill="{colour}"/><text x="{WIDTH - RIGHT - 4}" text-anchor="end"'
            out += f' y="{TOP + 12 if word == "gain" else HEIGHT - BOTTOM - 5}">{word}</text>'
    out += f'<text x="{LEFT}" y="18" font-size="13" font-weight="600" fill="{INK}">'
    out += f"{html.escape(title)}</text>"
    for value in range(len(names)) if names else ax.ticks():
        x = ax(value)
        says = names[value] if names else plain(value)
        out += f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="{FAINT}"/>'
        out += f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 14}" text-anchor="middle">{says}</text>'
    for value in ay.ticks():
        y = ay(value)
        out += f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="{FAINT}"/>'
        out += f'<text x="{LEFT - 5}" y="{y + 4:.1f}" text-anchor="end">{plain(value)}</text>'
    out += f'<path d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}" fill="none" stroke="{INK}"/>'
    middle = (LEFT + WIDTH - RIGHT) / 2
    out += f'<text x="{middle}" y="{HEIGHT - 8}" text-anchor="middle">{html.escape(across)}</text>'
    y = (TOP + HEIGHT - BOTTOM) / 2
    out += f'<text x="13" y="{y}" text-anchor="middle" transform="rotate(-90 13 {y})">'
    out += f"{html.escape(up)}</text>"
    for line in lines:
        good = [(ax(x), ay(max(y, floor) if logs[1] and not signed else y)) for x, y in line.points if y is not None]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in good)
        out += f'<polyline points="{path}" fill="none" stroke="{line.colour}" stroke-width="1.6"'
        out += f' stroke-dasharray="{line.dash}" stroke-linejoin="round"/>'
        if line.marks:
            for x, y in good:
                out += f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="{line.colour}"/>'
        for x, value in line.points:
            if value is None:
                out += f'<path d="M{ax(x) - 3:.1f} {TOP - 3}l6 6m0 -6l-6 6" stroke="{line.colour}"/>'
    return out


def page(panels, legend, title, path, columns=2):
    """Panels in a grid with one legend, as one SVG."""
    rows = math.ceil(len(panels) / columns)
    width, height = columns * WIDTH + 20, rows * HEIGHT + 84
    out = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
    out += f' viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11" fill="{GREY}">'
    out += '<rect width="100%" height="100%" fill="white"/>'
    out += f'<text x="10" y="22" font-size="15" font-weight="600" fill="{INK}">{title}</text>'
    x, y = 10, 42
    for says, colour, dash in legend:
        if x + 40 + 6.1 * len(says) > width:
            x, y = 10, y + 18
        out += f'<path d="M{x} {y}h26" stroke="{colour}" stroke-width="2" stroke-dasharray="{dash}"/>'
        out += f'<text x="{x + 31}" y="{y + 4}" fill="{INK}">{html.escape(says)}</text>'
        x += 44 + 6.1 * len(says)
    for i, one in enumerate(panels):
        out += f'<g transform="translate({10 + i % columns * WIDTH} {72 + i // columns * HEIGHT})">'
        out += f"{one}</g>"
    path.write_text(out + "</svg>\n", encoding="utf-8")
    print(f"Written: {path}")


KINDS = (  # says, colour, dash, numbers; no colour twice
    ("soft, float", "#1f6feb", "", {}),
    ("soft, double", "#0a3069", "2 3", {"double": 1}),
    ("soft, 16 substeps", "#8250df", "", {"substeps": 16}),
    ("propagation, float", "#2da44e", "", {"propagation": 1}),
    ("propagation, double", "#6b8e23", "2 3", {"propagation": 1, "double": 1}),
    ("Box2D 3", "#d1570b", "7 3", {"box2d3": 1}),
)
SOFT, DOUBLE, FINE, THESIS, _, BOX2D3 = KINDS
SHOCK = ("propagation, shock 4", "#bf3989", "", {"propagation": 1, "contactPasses": 4, "shockPasses": 4})
SHOCKS = dict(zip((0, 1, 2, 4, 8), ("#57606a", "#e0a800", "#0aa2c0", "#bf3989", "#7a4a1e")))
SCENES = (  # scene, seconds, numbers, title
    ("gas", 30, {}, "gas: 60 elastic discs in a free frame"),
    ("orbit", 30, {}, "orbit: 1/r^2, eccentric"),
    ("double pendulum", 20, {}, "double pendulum, let go level"),
    ("heavy chain", 20, {"ratio": 1000}, "chain of 10, the last one 1000 times as heavy"),
    ("valley", 60, {}, "valley: disc without friction on a heightmap"),
    ("crowd", 6, {}, "crowd: 40 boxes on one place"),
)


def over_time(folder):
    """Energy and momentum of each scene over time, and the CPU time of each."""
    runs = [
        (scene, {"seconds": seconds, **numbers, **more})
        for scene, seconds, numbers, _ in SCENES
        for *_, more in KINDS
    ]
    answers = iter(ask(runs))
    energy, momentum, spent = [], [], {kind[0]: [] for kind in KINDS}
    for k, (scene, _, _, title) in enumerate(SCENES):
        mine = [(kind, answer) for kind, answer in zip(KINDS, [next(answers) for _ in KINDS]) if answer]
        for kind, answer in mine:
            spent[kind[0]].append((k, answer["us"]))

        def lines(column, value):
            return [
                Line(says, colour, dash, [(s[0], value(s[column])) for s in answer["samples"]])
                for (says, colour, dash, _), answer in mine
            ]

        energy.append(panel(title, "time (s)", "change of energy (share)", lines(1, held), (False, SIGNED)))
        for column, name in ((2, "linear momentum"), (3, "angular momentum")):
            if any(sample[column] for _, answer in mine for sample in answer["samples"]):
                momentum.append(
                    panel(f"{scene}: {name}", "time (s)", "change (share)", lines(column, size_of))
                )
    kinds = [kind for kind in KINDS if spent[kind[0]]]
    energy.append(panel("CPU time of a step", "scene", "microseconds",
                        [Line(says, colour, dash, spent[says], True) for says, colour, dash, _ in kinds],
                        (False, True), [SHORT[scene] for scene, *_ in SCENES]))
    legend = [kind[:3] for kind in kinds]
    page(energy, legend, "Change of energy over time, as share of what is exchanged: gains apart from losses",
         folder / "tuning-energy.svg")
    page(momentum, legend, "Change of momentum over time, where it is conserved",
         folder / "tuning-momentum.svg")


SHORT = {"gas": "gas", "orbit": "orbit", "double pendulum": "pendulum", "heavy chain": "chain",
         "valley": "valley", "crowd": "crowd"}


def held(value):
    """A change; None if it is lost."""
    return None if value is None or abs(value) > 1e3 else value


def size_of(value):
    """The size of a change; None if it is lost."""
    return None if held(value) is None else abs(value)


def sweep(scene, dial, values, kinds, more):
    """Lines of the error over one setting, and of the CPU time of a step, each as (error, time)."""
    lines = []
    for says, colour, dash, numbers in kinds:
        answers = ask([(scene, {**more, **numbers, dial: value}) for value in values])
        if None in answers:
            continue  # not in this build
        errors = [(v, None if a["lost"] else a["error"]) for v, a in zip(values, answers)]
        times = [(v, a["us"]) for v, a in zip(values, answers)]
        lines.append((Line(says, colour, dash, errors, True), Line(says, colour, dash, times, True)))
    return lines


def errors(lines):
    return [error for error, _ in lines]


def times(title, across, lines):
    return panel(title, across, "microseconds a step", [time for _, time in lines], (True, True))


def dial_panels():
    steps = [1 / n for n in (480, 240, 120, 60, 30)]
    ours = (SOFT, DOUBLE, THESIS, BOX2D3)
    panels = []
    for scene, seconds, numbers in (
        ("gas", 10, {}),
        ("orbit", 14, {}),
        ("double pendulum", 10, {}),
        ("heavy chain", 10, {"ratio": 1000}),
        ("valley", 20, {}),
    ):
        lines = sweep(scene, "dt", steps, ours, {"seconds": seconds, **numbers})
        panels.append(
            panel(f"{scene}: length of a step", "dt (s)", "energy, largest change", errors(lines),
                  (True, True))
        )
    ratios = [10.0**k for k in range(7)]
    lines = sweep("mass ratio", "ratio", ratios, (SOFT, DOUBLE, THESIS, SHOCK, BOX2D3), {"seconds": 10})
    panels.append(panel("tower of ten, the top heavier", "mass ratio", "compression (share)",
                        errors(lines), (True, True)))
    panels.append(times("tower of ten: CPU time", "mass ratio", lines))
    return panels


def setting_panels():
    panels = []
    hertz = [7.5, 15, 30, 60, 120, 240, 480]
    kinds = (SOFT, FINE, THESIS)
    lines = sweep("net", "jointHertz", hertz, kinds, {"seconds": 10})
    panels.append(panel("net 8 x 8: joint stiffness", "jointHertz", "widest gap (mm)", errors(lines),
                        (True, True)))
    panels.append(times("net 8 x 8: CPU time", "jointHertz", lines))
    lines = sweep("net", "jointDamping", [0.1, 0.3, 1, 3, 10, 30], kinds, {"seconds": 10})
    panels.append(panel("net 8 x 8: joint damping", "jointDamping", "widest gap (mm)", errors(lines),
                        (True, True)))
    lines = sweep("crowd", "pushSpeed", [0.1, 0.3, 1, 3, 10, 30], (*kinds, BOX2D3), {"seconds": 6})
    panels.append(panel("crowd: push speed", "pushSpeed (m/s)", "energy / energy at pushSpeed",
                        errors(lines), (True, True)))
    passes = [2, 4, 8, 16, 32]
    lines = []
    for shock, colour in SHOCKS.items():
        kind = (f"{shock} shock passes", colour, "", {"propagation": 1, "shockPasses": shock})
        lines += sweep("mass ratio", "contactPasses", passes, (kind,), {"seconds": 10, "ratio": 100})
    panels.append(panel("tower 1:100: contact passes, by shock passes", "contactPasses",
                        "compression (share)", errors(lines), (True, True)))
    panels.append(times("tower 1:100: CPU time", "contactPasses", lines))
    return panels, [(line.says, line.colour, line.dash) for line in errors(lines)]


def draw(folder):
    folder.mkdir(parents=True, exist_ok=True)
    has_v3 = ask([("gas", {"seconds": 0.1, "box2d3": 1})])[0] is not None
    foreign = [BOX2D3[:3]] if has_v3 else []
    over_time(folder)
    legend = [kind[:3] for kind in (SOFT, DOUBLE, THESIS, SHOCK)] + foreign
    page(dial_panels(), legend, "Length of a step, and mass ratio (a cross: the scene is lost)",
         folder / "tuning-steps.svg")
    panels, shock = setting_panels()
    legend = [SOFT[:3], FINE[:3], THESIS[:3], *foreign, ("of the tower:", "white", ""), *shock]
    page(panels, legend, "Joints, push speed and passes (a cross: the scene is lost)",
         folder / "tuning-dials.svg")
