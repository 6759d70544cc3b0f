#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plays aPart in a headless Chromium, as a player would: page_test.py PAGE PICTURES PROGRAM...

PAGE is the folder that tools/web builds. Pictures are written to the folder PICTURES. PROGRAM is the
command of an apart-headless. Exit code: 0 all held, 1 something did not, 77 chromium or chromedriver
is missing."""
import datetime
import json
import pathlib
import subprocess
import sys
import time

from browser import Trial, judged, trial_of

SIZES = ((360, 640), (1280, 720), (1920, 1080))
TITLE, LEVELS, PLAYING, PAUSED, OVER = 0, 1, 7, 8, 9  # of Screen in stage.hpp


class Game(Trial):
    def state(self, what):
        """A number of gameState() in main.cpp; -1 before the game has started."""
        return self.browser.run(
            f"try {{ return Module._gameState({what}); }} catch (error) {{ return -1; }}")

    def arrives(self, screen, seconds=30):
        """The seconds until a screen is there, or None."""
        return self.wait(f"Module._gameState(0) === {screen}", seconds)

    def passes(self, tick):
        return self.wait(f"Module._gameState(1) > {tick}", 30)

    def title(self):
        self.browser.open(self.address)
        seconds = self.arrives(TITLE)
        self.expect(seconds is not None, f"the title appears ({seconds} s after the page)")
        time.sleep(1)
        self.shot("title")

    def level(self):
        self.browser.open(self.address + "#level=quarry")
        self.expect(self.arrives(PLAYING), "a link starts a level")
        self.browser.press(" ")
        for key in ("left", "right", "left"):
            self.browser.hold(key, 0.4)
        time.sleep(2)
        self.shot("level")
        self.expect(self.state(2) > 0, "a serve by the space key scores")
        self.browser.press("p")
        self.expect(self.arrives(PAUSED), "the key P pauses")
        tick = self.state(1)
        time.sleep(0.3)
        self.expect(self.state(1) == tick, "a paused game stands still")
        self.shot("pause")

    def lost(self):
        """A context is lost when the machine sleeps, for instance."""
        self.browser.open(self.address + "#level=quarry")
        self.passes(30)
        before = len(self.browser.shot())
        self.browser.run("""window.losing = document.getElementById("canvas").getContext("webgl2")
            .getExtension("WEBGL_lose_context"); losing.loseContext();""")
        time.sleep(0.5)
        blank, tick = len(self.browser.shot()), self.state(1)
        self.browser.run("losing.restoreContext();")
        self.expect(self.passes(tick + 30), "the game goes on without a context")
        after = len(self.browser.shot())
        self.expect(after > 0.8 * before > 1.6 * blank,
                    f"the picture comes back with it ({before}, {blank}, {after} bytes)")
        self.shot("restored")

    def aside(self, link):
        """Plays what a link names to its end, at the left wall."""
        self.browser.open(self.address + link)
        self.arrives(PLAYING)
        for _ in range(90):
            self.browser.press(" ")
            self.browser.hold("left", 0.5)
            if self.state(0) == OVER:
                break

    def lose(self):
        self.aside("#level=first_light")
        self.expect(self.state(0) == OVER, "a game of a player who stays aside ends")
        self.shot("results")

    def daily(self, program):
        """A day has one run for all: the program without a page counts the same result."""
        day = datetime.date(2026, 11, 26)
        self.aside(f"#daily={day}")
        self.expect(self.state(3) == int(f"{day:%Y%m%d}") + 1, "a day is the seed of its serves")
        self.shot("daily")
        self.browser.allow_clipboard()
        self.browser.press("c")
        time.sleep(0.5)
        copied = self.browser.later("navigator.clipboard.readText()")
        line, link = copied.split("\n")
        self.expect(link.startswith(self.address + "#replay="), "C copies a link to the game")
        file = self.pictures / "daily.replay"
        file.write_bytes(bytes(self.browser.run("return [...FS.readFile('/player/apart/last.replay')];")))
        told = subprocess.run([*program, "replay", str(file)], capture_output=True, text=True, check=False)
        self.expect(told.returncode == 0 and line in told.stdout.splitlines(), f"its result: {line}")
        self.browser.open(link)
        self.expect(self.passes(60), "the link of a daily run plays it")
        today = [datetime.datetime.now(datetime.timezone.utc).date()]
        self.browser.open(self.address + "#daily")
        self.arrives(PLAYING)
        today.append(datetime.datetime.now(datetime.timezone.utc).date()) # midnight may have passed
        self.expect(self.state(3) - 1 in [int(f"{each:%Y%m%d}") for each in today],
                    "#daily is the run of today")

    def link(self):
        made = self.browser.run("""const file = "/player/apart/last.replay";
            const link = Module.ccall("linkOfLastGame", "string", ["string"], [file]);
            return [link.slice("#replay=".length), FS.readFile(file).length];""")
        print(f"a replay of {made[1]} bytes is a link of {len(made[0])} letters")
        self.browser.open(self.address + "#replay=" + made[0])
        self.expect(self.passes(60), "the link of a replay plays it")
        self.shot("replay")
        self.browser.open(self.address + "#replay=damaged")
        self.expect(self.arrives(TITLE), "a damaged link is told")

    def drop_file(self, text):
        self.browser.open(self.address)
        self.arrives(TITLE)
        self.browser.run(f"""const data = new DataTransfer();
            data.items.add(new File([{json.dumps(text)}], "mine.toml"));
            window.dispatchEvent(new DragEvent("drop", {{ dataTransfer: data, cancelable: true }}));""")

    def drop(self):
        """A level of the player's own comes by drag and drop, and stays."""
        self.drop_file("title = nonsense")
        time.sleep(4)
        told = self.browser.run("return document.getElementById('news').textContent;")
        self.expect("mine.toml:1:" in told, f"an error of a dropped level is told: {told}")
        example = pathlib.Path(__file__).parents[2] / "game/examples/gallows.toml"
        self.drop_file(example.read_text(encoding="utf-8"))
        self.expect(self.arrives(PLAYING), "a dropped level is played")
        self.shot("dropped")
        self.browser.open(self.address + "#level=mine")
        self.expect(self.arrives(PLAYING), "a dropped level is kept")

    def map(self):
        """The map by keys, on all sizes of screens: chosen by arrows, played by enter, left by escape."""
        for width, height in SIZES:
            self.browser.resize(width, height)
            self.browser.open(self.address)
            self.arrives(TITLE)
            self.browser.press("down")
            self.browser.press("enter")
            self.expect(self.arrives(LEVELS), f"keys open the map at {width} x {height}")
            self.browser.press("right")
            time.sleep(0.5)
            self.shot(f"map-{width}")
            self.browser.press("enter")
            self.expect(self.arrives(PLAYING), "enter plays the chosen level")
        self.browser.press("p")
        self.arrives(PAUSED)

    def phone(self):
        """A phone held upright, by touch alone: the picture is turned, so that fingers and eyes can hit."""
        self.browser.resize(360, 640)
        self.browser.touch(True)
        self.browser.open(self.address)
        self.arrives(TITLE)
        time.sleep(0.5)
        self.shot("phone-title")
        self.browser.tap(*self.turned(360, 320, 182))
        self.expect(self.arrives(LEVELS), "a tap on a word of the title opens the map")
        time.sleep(0.5)
        self.shot("phone-map")
        self.browser.tap(*self.turned(360, 77, 345))
        self.expect(self.arrives(TITLE), "a tap on its word leaves the map")
        self.browser.tap(*self.turned(360, 320, 182))
        self.arrives(LEVELS)
        self.browser.tap(*self.turned(360, 137, 315))  # 18 pixels beside the second level
        self.expect(self.arrives(PLAYING), "a tap beside an open level plays it")
        self.shot("phone-level")
        for _ in range(8):
            self.browser.tap(180, 320)
            self.browser.drag((180, 300), (180, 420))
            if self.wait("Module._gameState(2) > 0", 2):
                break
        self.expect(self.state(2) > 0, "a tap serves, and a finger moves along the turned picture")
        self.browser.touch(False)

    @staticmethod
    def turned(height, x, y):
        """Where a point of the wide picture (pixels) is on a screen that shows it turned."""
        return height - y, x

    def touch(self):
        self.browser.resize(390, 760)
        self.browser.open(self.address + "#level=first_light")
        self.arrives(PLAYING)
        for _ in range(8):  # a ball that is lost needs another tap
            self.browser.tap(190, 500)
            self.browser.drag((190, 600), (300, 600))
            if self.wait("Module._gameState(2) > 0", 2):
                break
        self.expect(self.state(2) > 0, "a tap serves")
        self.shot("touch")


def main(page, pictures, program):
    with trial_of(Game, page, pictures) as game:
        game.address += "index.html"
        for part in (game.title, game.level, game.lost, game.lose, game.link):
            part()
        game.daily(program)
        game.drop()
        game.map()
        game.phone()
        game.touch()
    return judged([game])


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]))
