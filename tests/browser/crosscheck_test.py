#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plays scenes of the page of tools/crosscheck in a headless Chromium: crosscheck_test.py PAGE PROGRAM PICTURES

PAGE is the page, PROGRAM wrote its numbers; pictures are written to the folder PICTURES. Exit code:
0 all held, 1 something did not, 77 chromium or chromedriver is missing."""
import json
import math
import pathlib
import subprocess
import sys

from browser import Trial, judged, trial_of

BALL = "BallBouncesAtRestitution08"
PIECES = "BlockThatBreaksInFlightKeepsItsMomentum"


class Page(Trial):
    def __init__(self, browser, address, pictures, scenes):
        super().__init__(browser, address, pictures)
        self.scenes = {scene["name"]: scene for scene in scenes}

    def of(self, name, script):
        """Runs a script with the section and its player."""
        return self.browser.call("POST", "/execute/async", {"args": [], "script": (
            f"const done = arguments[0]; const section = document.getElementById('{name}');"
            f"const player = section.player; (async () => {{ {script} }})()"
            ".then(done, (error) => done('' + error));")})

    def colours(self, name, time):
        """The number of pixels of the canvas in each of the colours of the engines."""
        return self.of(name, f"await player.show({time});" """
            const canvas = section.querySelector("canvas");
            const all = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
            return player.film.looks.map(([colour]) => {
              const [r, g, b] = [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
              let count = 0;
              for (let i = 0; i < all.length; i += 4) {
                if (all[i + 3] > 90 && Math.abs(all[i] - r) + Math.abs(all[i + 1] - g) +
                    Math.abs(all[i + 2] - b) < 12) ++count;
              }
              return count;
            });""")

    def data(self):
        """What the page decodes is what the program wrote, in each play, to its unit."""
        for name in (BALL, PIECES):
            film = self.scenes[name]["film"]
            worst = 0
            for index, play in enumerate(film["plays"]):
                for k in (0, len(play["times"]) // 3, len(play["times"]) - 1):
                    found = self.of(name, f"await player.load();"
                                          f"return player.placesAt({index}, {play['times'][k] / 1e4});")
                    by_body = {one["body"]: one for one in found}
                    for body, places in play["bodies"]:
                        i = k - (len(play["times"]) - len(places) // 3)
                        if i < 0:
                            continue
                        x, y, angle = places[3 * i : 3 * i + 3]
                        one = by_body[body]
                        worst = max(
                            worst,
                            abs(film["middle"][0] + film["unit"] * x - one["x"]) / film["unit"],
                            abs(film["middle"][1] + film["unit"] * y - one["y"]) / film["unit"],
                            abs(math.remainder(2 * math.pi * angle / 4096 - one["angle"], 2 * math.pi)))
            self.expect(worst < 1e-3, f"{name}: the page decodes the places ({worst:.1e} units)")

    def play(self):
        before = self.of(BALL, "return section.classList.contains('playing')")
        self.expect(before is False, "before it is played the picture shows the paths")
        self.of(BALL, "section.scrollIntoView(); player.slider.focus();")
        for _ in range(3):
            self.browser.press("right")
        step = self.of(BALL, "return Number(player.slider.step)")
        moved = self.of(BALL, "return player.wanted")
        self.expect(abs(moved - 3 * step) < 1e-4, f"an arrow key is a step ({moved} s)")
        # The page itself presses the key again: on a busy machine the film would be over before.
        self.of(BALL, """const from = player.wanted, start = performance.now();
            window.played = new Promise((done) => {
              const look = () => {
                if (player.wanted < from + 0.3) { requestAnimationFrame(look); return; }
                player.slider.dispatchEvent(new KeyboardEvent("keydown", { key: " ", cancelable: true }));
                done([player.wanted - from, (performance.now() - start) / 1000]);
              };
              look();
            });""")
        self.browser.press(" ")
        run, passed = self.browser.later("window.played")
        self.expect(0.3 <= run <= passed, f"the space key plays in real time ({run:.2f} of {passed:.2f} s)")
        self.draws(10)
        now = self.of(BALL, "return player.wanted")
        self.expect(abs(now - moved - run) < 1e-4, "a second time, it pauses")
        self.expect(self.of(BALL, "return player.output.textContent") == f"{now:.2f} s", "the time is shown")

    def marks(self):
        parted = self.scenes[BALL]["film"]["parted"]
        first = min(t for t in parted if t is not None)
        shown = self.of(BALL, "return [...section.querySelectorAll('.marks button')]"
                              ".map((mark) => Number(mark.dataset.time))")
        self.expect(sorted(shown) == sorted(float(f"{t:.6g}") for t in parted if t is not None),
                    f"where plays part is marked {shown}")
        self.of(BALL, "section.querySelector('.marks button').focus();")
        self.browser.press("enter")
        at = self.of(BALL, "return player.wanted")
        self.expect(any(abs(at - t) < 1e-3 for t in shown), f"a mark leads to its time ({at} s)")
        both = self.colours(BALL, first + 1)
        self.expect(all(count > 20 for count in both), f"each engine has its colour {both}")
        edges = self.of(BALL, "return ['svg', 'canvas'].map((name) => {"
                              "const box = section.querySelector('.stage ' + name).getBoundingClientRect();"
                              "return [box.left, box.top, box.width, box.height]; })")
        self.expect(edges[0] == edges[1], f"what moves lies on the picture {edges[1]}")
        looks = self.of(BALL, "return player.film.looks.map(([colour]) => colour)")
        count = len(self.scenes[BALL]["film"]["plays"])
        self.expect(count >= 7 and len(set(looks)) == len(looks) == count, "no colour twice")
        self.shot("crosscheck-ball")

    def pieces(self):
        count = self.of(PIECES, "await player.show(player.film.end);"
                                "return [player.partsAt(0, 0).size, player.partsAt(0, 99).size]")
        self.expect(count[1] == count[0] + 1, f"a part that is released moves alone {count}")
        self.of(PIECES, "section.scrollIntoView();")
        self.shot("crosscheck-pieces")

    def every(self):
        """Each scene shows its middle without an error; no scene asks another host."""
        bad = self.browser.call("POST", "/execute/async", {"args": [], "script": """
            const done = arguments[0];
            (async () => {
              const bad = [];
              for (const section of document.querySelectorAll("section")) {
                const player = section.player;
                await player.show(player.film.end / 2);
                for (const index of player.plays.keys()) {
                  const places = player.placesAt(index, player.wanted);
                  if (!places.length || places.some((p) => !Number.isFinite(p.x + p.y + p.angle)))
                    bad.push(section.id);
                }
              }
              return bad;
            })().then(done, (error) => done(["" + error]));"""})
        self.expect(bad == [], f"all {len(self.scenes)} scenes play {bad}")
        asked = self.browser.run("return performance.getEntriesByType('resource').map((e) => e.name)")
        self.expect(not asked, f"the page asks for nothing else {asked}")


def main(page, program, pictures):
    scenes = json.loads(subprocess.run([program], stdout=subprocess.PIPE, check=False).stdout)
    with trial_of(Page, page, pictures, scenes) as trial:
        trial.browser.open(trial.address)
        for part in (trial.data, trial.play, trial.marks, trial.pieces, trial.every):
            part()
    return judged([trial])


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
