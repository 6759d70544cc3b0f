# SPDX-License-Identifier: MIT
"""The scenes of the page of tools/crosscheck as films: packed places, a slider, marks."""
import base64
import html
import json
import pathlib
import zlib

SCRIPT = pathlib.Path(__file__).with_suffix(".js")
STYLE_SHEET = """
.stage { position: relative; max-width: 520px; }
.stage canvas { position: absolute; left: 0; top: 0; width: 100%; height: 100%;
                pointer-events: none; }
.playing .ends { display: none; }
.playing .paths { opacity: 0.3; }
.player { display: grid; grid-template-columns: 36px 1fr 64px; gap: 0 8px; margin-top: 6px;
          max-width: 520px; }
.player[hidden] { display: none; }
.player button.run { height: 28px; border: 1px solid #8c959f; border-radius: 6px; cursor: pointer;
                     background: #f6f8fa; color: #24292f; }
.player input { width: 100%; margin: 0; height: 28px; }
.player output { font-variant-numeric: tabular-nums; text-align: right; line-height: 28px; }
.marks { position: relative; height: 22px; margin: 0 8px; }
.marks button { position: absolute; width: 14px; height: 20px; margin-left: -7px; padding: 0;
                border: 0; background: none; cursor: pointer; font-size: 15px; line-height: 18px; }
.player .parts { grid-column: 1 / 4; font-size: 13px; color: #57606a; margin: 0; }
"""


def second_differences(values):
    """Small where a motion is even; pack() keeps them modulo 2^16."""
    last, change = 0, 0
    for i, value in enumerate(values):
        now = value - last
        yield now - change
        last, change = value, now


def pack(numbers):
    """Numbers modulo 2^16 as text: near 0 is short. Low bytes first, then high bytes; deflate."""
    low, high = bytearray(), bytearray()
    for number in numbers:
        small = (number + 0x8000) % 0x10000 - 0x8000
        zigzag = 2 * small if small >= 0 else -2 * small - 1
        low.append(zigzag & 0xFF)
        high.append(zigzag >> 8)
    return base64.b64encode(zlib.compress(bytes(low + high), 9)).decode()


def film_of(scene, view, styles):
    """The film of a scene as an object of JSON: crosscheck_player.js decodes it."""
    film = scene["film"]
    numbers, plays = [], []
    for play in film["plays"]:
        numbers += second_differences(play["times"])
        for _, places in play["bodies"]:
            for axis in range(3):
                numbers += second_differences(places[axis::3])
        plays.append({
            "frames": len(play["times"]),
            "bodies": [[body, len(places) // 3] for body, places in play["bodies"]],
            "splits": play["splits"],
        })
    moving = {body for play in film["plays"] for body, _ in play["bodies"]}
    return {
        "middle": film["middle"],
        "unit": film["unit"],
        "angles": film["angles"],
        "times": film["times"],
        "end": end_of(film),
        "count": len(scene["bodies"]),
        "view": [round(n, 6) for n in (view.left, view.top, view.scale)] + [view.width, view.height],
        "looks": [
            [colour, [float(n) for n in dash.split()], stroke, opacity]
            for _, colour, dash, stroke, opacity in styles
        ],
        "bodies": [[i, b["parts"]] for i, b in enumerate(scene["bodies"]) if i in moving],
        "plays": plays,
        "data": pack(numbers),
    }


def end_of(film):
    """The end (s) of the longest play."""
    return max(play["times"][-1] for play in film["plays"]) / film["times"]


def marks(film, styles):
    """A button at each time at which a play parts from the first one."""
    end = end_of(film)
    result = ""
    for time, (name, colour, *_) in zip(film["parted"], styles):
        if time is None:
            continue
        words = html.escape(f"{name} parts at {time:.2f} s")
        result += (
            f'<button type="button" data-time="{time:.6g}" title="{words}" aria-label="{words}"'
            f' style="left:{100 * time / end:.2f}%;color:{colour}">▲</button>'
        )
    return result


def parts(film, styles):
    """Where each play parts, in words."""
    said = [
        f'<span style="color:{colour};font-weight:600">{html.escape(name)}</span> at {time:.2f} s'
        for time, (name, colour, *_) in zip(film["parted"], styles)
        if time is not None
    ]
    near = f"{1000 * film['distance']:.3g} mm"
    if not said:
        return f"No point is ever more than {near} from its place in {styles[0][0]}."
    return f"More than {near} from {styles[0][0]} (▲): {', '.join(said)}."


def player(scene, view, styles):
    film = scene["film"]
    step = end_of(film) / (len(film["plays"][0]["times"]) - 1)
    data = json.dumps(film_of(scene, view, styles), separators=(",", ":"))
    return (
        '<div class="player" hidden><button type="button" class="run" aria-label="Play">▶</button>'
        f'<input type="range" min="0" max="{end_of(film):.6g}" step="{step:.6g}" value="0"'
        f' aria-label="Time (s) of {html.escape(scene["title"])}">'
        f'<output>0.00 s</output><div></div><div class="marks">{marks(film, styles)}</div>'
        f'<div></div><p class="parts">{parts(film, styles)}</p>'
        f'<script type="application/json">{data}</script></div>'
    )


def script():
    return f"<script>\n{SCRIPT.read_text(encoding='utf-8')}</script>"
