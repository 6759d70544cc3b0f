#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plays levels by sight, on a virtual screen: sees the picture, moves the mouse, presses space.

    player.py build/release/bin/apart [--seconds 60] [LEVEL ...]

It takes 20 pictures a second, follows the cream colour of the ball and the teal of the paddle, and
has no access to the state of the game. A game that has ended is followed by the next. The last one
is then played again without a screen, for its result and for the gaps between cracks, breaks, falls
and catches.
Exit code: 0: all games could be played, 1: one could not, 77: a tool is missing."""
import pathlib
import re
import subprocess
import sys
import time

sys.dont_write_bytecode = True
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "lib"))
from options import Options  # noqa: E402
from virtual_screen import Program, Screen, skip_without_tools  # noqa: E402

SIZE = WIDTH, HEIGHT = 1280, 800  # of the window
SCALE = 4                         # pixels of the window for each pixel of the picture seen
COLUMNS, ROWS = 1040 // SCALE, HEIGHT // SCALE  # without the panel on the right
TICKS = 120                       # a second
PADDLE_ROW = 738 // SCALE
QUIET = 3                         # s
EVENTS = ("cracked", "broke", "letGo", "caught")


class Eye:
    """Pictures of the window, made small by ffmpeg."""

    def __init__(self, screen, game):
        place = screen.xdotool("getwindowgeometry", "--shell", game.window)
        values = dict(line.split("=") for line in place if "=" in line)
        self.size = COLUMNS * ROWS * 3
        self.process = subprocess.Popen(
            ["ffmpeg", "-v", "error", "-f", "x11grab", "-draw_mouse", "0", "-framerate", "20",
             "-video_size", f"{COLUMNS * SCALE}x{HEIGHT}", "-i", f"{screen.env['DISPLAY']}+{values['X']},{values['Y']}",
             "-vf", f"scale={COLUMNS}:{ROWS}:flags=area", "-pix_fmt", "rgb24", "-f", "rawvideo", "-"],
            stdout=subprocess.PIPE, env=screen.env)

    def look(self):
        data = self.process.stdout.read(self.size)
        return data if len(data) == self.size else None

    def close(self):
        self.process.kill()
        self.process.wait()


def points(data, first, last, test):
    """Positions (pixels of the small picture) in some rows whose colour passes the test."""
    part = data[first * COLUMNS * 3:last * COLUMNS * 3]
    return [(i % COLUMNS, first + i // COLUMNS)
            for i, color in enumerate(zip(part[0::3], part[1::3], part[2::3])) if test(*color)]


def is_ball(r, g, b):
    return r > 195 and r >= g >= b and 5 <= r - b <= 45


def is_paddle(r, g, b):
    return g > 150 and b > 140 and g - r > 60


class Player:
    """Follows the ball; where it comes down is told by its last two places."""

    def __init__(self):
        self.ball = None
        self.speed = (0.0, 0.0)
        self.lost = 0   # pictures without a ball
        self.still = 0  # pictures with the ball in one place; a slow game shows some twice

    def see(self, data):
        found = points(data, 4, PADDLE_ROW, is_ball)
        if self.ball and self.lost < 6:  # the nearest to where it should be
            x, y = self.ball[0] + self.speed[0], self.ball[1] + self.speed[1]
            found = [p for p in found if abs(p[0] - x) + abs(p[1] - y) < 40]
        if not found:
            self.lost += 1
            return
        lowest = max(found, key=lambda p: p[1])
        near = [p for p in found if abs(p[0] - lowest[0]) + abs(p[1] - lowest[1]) < 8]
        here = (sum(p[0] for p in near) / len(near), sum(p[1] for p in near) / len(near))
        if self.ball and self.lost == 0:
            way = (here[0] - self.ball[0], here[1] - self.ball[1])
            self.still = self.still + 1 if abs(way[0]) + abs(way[1]) < 0.3 else 0
            if self.still in (0, 5):
                self.speed = way
        self.ball, self.lost = here, 0

    def target(self):
        if not self.ball:
            return None
        (x, y), (vx, vy) = self.ball, self.speed
        if vy > 0.5:
            x += vx * (PADDLE_ROW - y) / vy
            wall = COLUMNS - 8
            x = (x - 8) % (2 * (wall - 8))  # mirrored at the walls
            x = 8 + (x if x < wall - 8 else 2 * (wall - 8) - x)
        return x


class Hand:
    """Moves the paddle by the mouse. The sent places are stored, since the paddle follows later."""

    def __init__(self, screen):
        self.process = subprocess.Popen(["xdotool", "-"], stdin=subprocess.PIPE, text=True, env=screen.env)
        self.aim = None  # column to which the paddle was sent
        self.seen = []   # its last columns

    def move(self, paddle, target):
        self.seen = self.seen[-2:] + [paddle]
        if self.aim is None or (len(self.seen) == 3 and max(self.seen) - min(self.seen) < 0.6):
            self.aim = paddle
        step = max(-300, min(300, round(SCALE * (target - self.aim))))
        if step:
            self.send(f"mousemove_relative -- {step} 0")
            self.aim += step / SCALE

    def send(self, words):
        self.process.stdin.write(words + "\n")
        self.process.stdin.flush()

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def play(screen, apart, level, seconds):
    with Program(screen, "aPart", apart, "--mute", "--level", level, "--seed", "1") as game:
        time.sleep(2)
        eye, player, hand = Eye(screen, game), Player(), Hand(screen)
        end, served, pictures = time.monotonic() + seconds, 0.0, 0
        while time.monotonic() < end:
            data = eye.look()
            if data is None:
                break
            pictures += 1
            player.see(data)
            paddle = points(data, PADDLE_ROW - 8, PADDLE_ROW + 4, is_paddle)
            target = player.target()
            if paddle and target is not None:
                hand.move((min(p[0] for p in paddle) + max(p[0] for p in paddle)) / 2, target)
            riding = player.ball and player.ball[1] > PADDLE_ROW - 14 and player.still >= 5
            if time.monotonic() > served + 1 and (riding or player.lost > 20):
                hand.send("key space")
                served = time.monotonic()
        hand.close()
        eye.close()
        game.after("pause", lambda: game.key("Escape"), least=30000, fuzz=30)
        game.key("Up", "Return", "Return")  # to the title, which asks once if there are points: the game is kept
        kept = pathlib.Path(screen.config.name) / "apart" / "last.replay"
        for _ in range(20):  # a busy machine writes it late
            time.sleep(0.5)
            if kept.exists():
                break
        time.sleep(0.5)
    return pictures / seconds


def totals(profile):
    """Games and won games of all themes. There is no profile before the first game has ended."""
    text = profile.read_text() if profile.exists() else ""
    return [sum(int(n) for n in re.findall(rf"^{key} = (\d+)$", text, re.M)) for key in ("games", "won")]


def judge(screen, headless, file):
    """Result of a recorded game, its gaps in seconds, and its length in seconds."""
    told = screen.run(headless, "replay", str(file)).stdout.splitlines()[0]
    trace = screen.run(headless, "trace", str(file), seconds=120).stdout
    ticks = sorted({int(m[1]) for m in re.finditer(r"^\s*(\d+)\s+(\w+)", trace, re.M) if m[2] in EVENTS})
    gaps = [(b - a) / TICKS for a, b in zip(ticks, ticks[1:])]
    return told, gaps, (ticks[-1] - ticks[0]) / TICKS if len(ticks) > 1 else 0


def main():
    parser = Options("player.py", description=__doc__)
    parser.add_argument("apart")
    parser.add_argument("levels", nargs="*", default=[])
    parser.add_argument("--seconds", type=float, default=60)
    options = parser.parse_intermixed_args()
    skip_without_tools()
    headless = str(pathlib.Path(options.apart).with_name("apart-headless"))
    failed = False
    for level in options.levels or ["first_light", "tower", "see_saw", "dam", "escapement", "castle"]:
        with Screen() as screen:
            rate = play(screen, options.apart, level, options.seconds)
            folder = pathlib.Path(screen.config.name) / "apart"
            file = folder / "last.replay"
            if not file.exists():
                print(f"{level}: nothing was recorded", flush=True)
                failed = True
                continue
            games, won = totals(folder / "profile.toml")
            told, gaps, span = judge(screen, headless, file)
            quiet = sum(gap for gap in gaps if gap > QUIET)
            share = 100 * quiet / span if span else 0
            print(f"{level}: {games} games, {won} won, seen at {rate:.0f} pictures a second. The last: {told} "
                  f"Longest gap {max(gaps, default=0):.1f} s, {share:.0f} % of the time in gaps over {QUIET} s.",
                  flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
