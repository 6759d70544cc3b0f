# SPDX-License-Identifier: MIT
"""SVG figures of tools/bench and tools/trade: page, scales, axes, legends."""
import html
import math

COLOURS = ("#1f6feb", "#d1570b", "#2da44e", "#8250df", "#bf3989", "#57606a")
INK, FAINT = "#24292f", "#d0d7de"


# Positions of a label around its mark: fractions of the distance, to the right and upwards.
ABOVE = ((0, 1.4), (0, -1.4))
BESIDE = ((1, 0), (0.8, 0.8), (0.8, -0.8), (-1, 0), (-0.8, 0.8), (-0.8, -0.8))
# Corners of marks, relative to the size; y down.
OUTLINES = {
    "square": ((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)),
    "diamond": ((0, -1.2), (1.2, 0), (0, 1.2), (-1.2, 0)),
    "triangle": ((0, -1.1), (1.1, 0.9), (-1.1, 0.9)),
    "cross": (
        *((-1, -0.6), (-0.6, -1), (0, -0.4), (0.6, -1), (1, -0.6), (0.4, 0)),
        *((1, 0.6), (0.6, 1), (0, 0.4), (-0.6, 1), (-1, 0.6), (-0.4, 0)),
    ),
}


def polyline(points, colour, width, dash):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    dashed = f' stroke-dasharray="{dash}"' if dash else ""
    return (
        f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{dashed}/>'
    )


class Page:
    """Collects shapes; positions are pixels, y down."""

    def __init__(self, width, height, title):
        self.width, self.height = width, height
        self.under = [f'<rect width="{width}" height="{height}" fill="white"/>']
        self.shapes = []
        self.taken = []  # boxes (left, top, right, bottom) that no label may cover
        self.room = (0, 0, width, height)  # box of all labels
        self.text(16, 26, title, size=16, weight="bold")

    def text(self, x, y, words, anchor="start", size=12, colour=INK, weight="normal", turn=0):
        turned = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.shapes.append(
            f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}"'
            f' font-weight="{weight}" text-anchor="{anchor}"{turned} paint-order="stroke"'
            f' stroke="white" stroke-width="3">{html.escape(words)}</text>'
        )

    def label(self, x, y, words, colour=INK, weight="normal", sides=(*BESIDE, *ABOVE)):
        """Labels a mark at a free position; a line connects the two if they are not adjacent.
        Without a free position there is no label; the mark still has its hint. Must be called after
        all marks."""
        width, height = 5.9 * len(words), 11
        for far in (8, 17, 30, 45):
            for across, up in sides:
                left = x + far * across - width * (1 - round(across)) / 2
                middle = y - far * up
                box = (left, middle - height / 2, left + width, middle + height / 2)
                if self.fits(box):
                    if far > 8:
                        end = (x + (far - 2) * across, y - (far - 2 - 4 * abs(up)) * up)
                        self.under.append(polyline([(x, y), end], colour, 0.7, ""))
                    self.taken.append(box)
                    self.text(left, middle + 3.6, words, size=10, colour=colour, weight=weight)
                    return

    def fits(self, box):
        return (
            box[0] >= self.room[0]
            and box[2] <= self.room[2]
            and box[1] >= self.room[1]
            and box[3] <= self.room[3]
            and all(
                box[2] < other[0] or other[2] < box[0] or box[3] < other[1] or other[3] < box[1]
                for other in self.taken
            )
        )

    def line(self, points, colour=INK, width=1.0, dash=""):
        self.shapes.append(polyline(points, colour, width, dash))

    def bar(self, x, y, width, height, colour):
        self.shapes.append(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{max(width, 0):.1f}" height="{height:.1f}"'
            f' fill="{colour}"/>'
        )

    def mark(self, x, y, colour, form="dot", size=5, hint=""):
        """A dot, ring, square, diamond, triangle or cross."""
        self.taken.append((x - size, y - size, x + size, y + size))
        fill, edge = (colour, "white") if form != "ring" else ("white", colour)
        if form in OUTLINES:
            corners = " ".join(f"{x + size * u:.1f},{y + size * v:.1f}" for u, v in OUTLINES[form])
            shape = f'polygon points="{corners}"'
        else:
            shape = f'circle cx="{x:.1f}" cy="{y:.1f}" r="{size}"'
        name = shape.split(" ", 1)[0]
        self.shapes.append(
            f'<{shape} fill="{fill}" stroke="{edge}" stroke-width="1.5" stroke-linejoin="round">'
            f"<title>{html.escape(hint)}</title></{name}>"
        )

    def ring(self, x, y, radius, colour):
        """A circle around a mark."""
        self.shapes.append(
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="none" stroke="{colour}"'
            f' stroke-width="2"/>'
        )

    def legend(self, x, y, names_and_colours):
        for i, (name, colour) in enumerate(names_and_colours):
            self.mark(x, y + 18 * i - 4, colour)
            self.text(x + 12, y + 18 * i, name)

    def write(self, path):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}"'
            f' viewBox="0 0 {self.width} {self.height}" font-family="sans-serif">\n'
            + "\n".join(self.under + self.shapes)
            + "\n</svg>\n",
            encoding="utf-8",
        )


class LogScale:
    """Maps values low to high, both > 0, to pixels start to end."""

    def __init__(self, low, high, start, end):
        if high / low < 10:  # a narrower range would have no tick
            middle = math.sqrt(low * high)
            low, high = middle / 3.2, middle * 3.2
        self.low, self.high, self.start, self.end = low, high, start, end

    def __call__(self, value):
        value = min(max(value, self.low), self.high)
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.start + share * (self.end - self.start)

    def ticks(self):
        """1, 2 and 5 times the powers of ten; the powers alone beyond four decades."""
        decades = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        steps = (1, 2, 5) if len(decades) <= 4 else (1,)
        values = [step * 10.0**decade for decade in decades for step in steps]
        return [value for value in values if self.low * 0.999 <= value <= self.high * 1.001]


def axes(page, across, up, across_name, up_name):
    """Grid and names of two scales; `up` goes from the bottom pixel to the top one."""
    for value in across.ticks():
        page.line([(across(value), up.start), (across(value), up.end)], FAINT)
        page.text(across(value), up.start + 16, f"{value:g}", "middle", 11)
    for value in up.ticks():
        page.line([(across.start, up(value)), (across.end, up(value))], FAINT)
        page.text(across.start - 6, up(value) + 4, f"{value:g}", "end", 11)
    page.line([(across.start, up.end), (across.start, up.start), (across.end, up.start)])
    page.text((across.start + across.end) / 2, up.start + 36, across_name, "middle")
    middle = (up.start + up.end) / 2
    page.text(across.start - 52, middle, up_name, "middle", turn=-90)
