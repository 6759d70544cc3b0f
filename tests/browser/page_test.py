#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plays aPart in a headless Chromium, as a player would: page_test.py PAGE PICTURES

PAGE is the folder that tools/web builds. Pictures are written to the folder PICTURES. Exit code: 0
all held, 1 something did not, 77 chromium or chromedriver is missing."""
import pathlib
import sys
import time

from browser import Trial, chromium, missing, served

TITLE, LEVELS, PLAYING, PAUSED, OVER = 0, 1, 7, 8, 9  # of Screen in stage.hpp


def state(browser, what):
    """A number of gameState() in main.cpp; -1 before the game has started."""
    return browser.run(f"try {{ return Module._gameState({what}); }} catch (error) {{ return -1; }}")


def wait(browser, what, holds, seconds=30):
    """Waits until holds(state) is true; the seconds that it took, or None."""
    start = time.monotonic()
    while time.monotonic() - start < seconds:
        if holds(state(browser, what)):
            return time.monotonic() - start
        time.sleep(0.05)
    return None


class Game(Trial):
    def title(self):
        self.browser.open(self.address)
        seconds = wait(self.browser, 0, lambda screen: screen == TITLE)
        self.expect(seconds is not None, f"the title appears ({seconds} s after the page)")
        time.sleep(1)
        self.shot("title")

    def level(self):
        self.browser.open(self.address + "#level=quarry")
        self.expect(wait(self.browser, 0, lambda screen: screen == PLAYING), "a link starts a level")
        self.browser.press(" ")
        for key in ("left", "right", "left"):
            self.browser.hold(key, 0.4)
        time.sleep(2)
        self.shot("level")
        self.expect(state(self.browser, 2) > 0, "a serve by the space key scores")
        self.browser.press("p")
        self.expect(wait(self.browser, 0, lambda screen: screen == PAUSED), "the key P pauses")
        tick = state(self.browser, 1)
        time.sleep(0.3)
        self.expect(state(self.browser, 1) == tick, "a paused game stands still")
        self.shot("pause")

    def lose(self):
        self.browser.open(self.address + "#level=first_light")
        wait(self.browser, 0, lambda screen: screen == PLAYING)
        for _ in range(90):
            self.browser.press(" ")
            self.browser.hold("left", 0.5)
            if state(self.browser, 0) == OVER:
                break
        self.expect(state(self.browser, 0) == OVER, "a game of a player who stays aside ends")
        self.shot("results")

    def link(self):
        made = self.browser.call("POST", "/execute/async", {"args": [], "script": """
            const done = arguments[0];
            const file = "/player/apart/last.replay";
            const link = Module.ccall("linkOfLastGame", "string", ["string"], [file]);
            done([link.slice("#replay=".length), FS.readFile(file).length]);"""})
        print(f"a replay of {made[1]} bytes is a link of {len(made[0])} letters")
        self.browser.open(self.address + "#replay=" + made[0])
        self.expect(wait(self.browser, 1, lambda tick: tick > 60), "the link of a replay plays it")
        self.shot("replay")
        self.browser.open(self.address + "#replay=damaged")
        self.expect(wait(self.browser, 0, lambda screen: screen == TITLE), "a damaged link is told")

    def touch(self):
        self.browser.call("POST", "/window/rect", {"width": 390, "height": 760})
        self.browser.open(self.address + "#level=first_light")
        wait(self.browser, 0, lambda screen: screen == PLAYING)
        self.browser.tap(190, 500)
        self.browser.drag((190, 600), (300, 600))
        time.sleep(1.5)
        self.expect(state(self.browser, 2) > 0, "a tap serves")
        self.shot("touch")


def main(page, pictures):
    if missing():
        print("Missing: " + ", ".join(missing()))
        return 77
    pictures.mkdir(parents=True, exist_ok=True)
    with served(page) as address, chromium() as browser:
        game = Game(browser, address + "index.html", pictures)
        for part in (game.title, game.level, game.lose, game.link, game.touch):
            part()
        faults = browser.faults()
        game.expect(not faults, f"the browser reports no error {faults[:3]}")
    print(f"{len(game.failed)} failed")
    return 1 if game.failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
