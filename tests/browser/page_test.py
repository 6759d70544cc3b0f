#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plays aPart in a headless Chromium, as a player would: page_test.py PAGE PICTURES

PAGE is the folder that tools/web builds. Pictures are written to the folder PICTURES. Exit code: 0
all held, 1 something did not, 77 chromium or chromedriver is missing."""
import base64
import functools
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request

TITLE, LEVELS, PLAYING, PAUSED, OVER = 0, 1, 7, 8, 9  # of Screen in stage.hpp
KEYS = {"enter": "\ue007", "escape": "\ue00c", "left": "\ue012", "right": "\ue014"}


class Browser:
    """A Chromium, by the WebDriver protocol (W3C)."""

    def __init__(self, profile):
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        port = next(line.split()[-1].rstrip(".") for line in self.driver.stdout if "port" in line and
                    "started" in line)
        threading.Thread(target=self.driver.stdout.read, daemon=True).start()
        self.base = f"http://127.0.0.1:{port}/session"
        arguments = (
            "--headless --no-sandbox --disable-quic --no-first-run --disable-background-networking"
            " --disable-component-update --disable-sync --use-gl=angle --use-angle=swiftshader"
            f" --enable-unsafe-swiftshader --user-data-dir={profile} --window-size=1280,800"
        ).split()
        options = {"args": arguments, "binary": shutil.which("chromium")}
        wanted = {"capabilities": {"alwaysMatch": {
            "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}}}
        self.base += "/" + self.call("POST", "", wanted)["sessionId"]

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data=data, method=method)
        request.add_header("Content-Type", "application/json")
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(f"{path}: {error.read()[:300]}") from error

    def open(self, address):
        self.call("POST", "/url", {"url": "about:blank"})  # so that a new fragment loads the page
        self.call("POST", "/url", {"url": address})

    def run(self, script):
        return self.call("POST", "/execute/sync", {"script": script, "args": []})

    def act(self, kind, actions, **more):
        self.call("POST", "/actions", {"actions": [
            {"type": kind, "id": kind + str(more), "actions": actions, **more}]})

    def hold(self, key, seconds):
        code = KEYS.get(key, key)
        self.act("key", [{"type": "keyDown", "value": code},
                         {"type": "pause", "duration": int(1000 * seconds)},
                         {"type": "keyUp", "value": code}])

    def press(self, key):
        self.hold(key, 0.05)

    def tap(self, x, y):
        self.act("pointer", [{"type": "pointerMove", "x": x, "y": y, "duration": 0},
                             {"type": "pointerDown", "button": 0},
                             {"type": "pause", "duration": 60},
                             {"type": "pointerUp", "button": 0}],
                 parameters={"pointerType": "touch"})

    def drag(self, start, end):
        self.act("pointer", [{"type": "pointerMove", "x": start[0], "y": start[1], "duration": 0},
                             {"type": "pointerDown", "button": 0},
                             {"type": "pointerMove", "x": end[0], "y": end[1], "duration": 300},
                             {"type": "pointerUp", "button": 0}],
                 parameters={"pointerType": "touch"})

    def picture(self, path):
        path.write_bytes(base64.b64decode(self.call("GET", "/screenshot")))

    def faults(self):
        log = self.call("POST", "/se/log", {"type": "browser"})
        return [entry["message"] for entry in log if entry["level"] == "SEVERE"]

    def close(self):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.kill()


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


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


class Trial:
    def __init__(self, browser, address, pictures):
        self.browser = browser
        self.address = address
        self.pictures = pictures
        self.failed = []

    def expect(self, holds, sentence):
        print(("holds: " if holds else "FAILS: ") + sentence, flush=True)
        if not holds:
            self.failed.append(sentence)

    def shot(self, name):
        self.browser.picture(self.pictures / f"browser-{name}.png")

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
    if not (shutil.which("chromium") and shutil.which("chromedriver")):
        print("chromium or chromedriver is missing.")
        return 77
    pictures.mkdir(parents=True, exist_ok=True)
    handler = functools.partial(Quiet, directory=str(page))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as profile:
        browser = Browser(profile)
        try:
            trial = Trial(browser, f"http://127.0.0.1:{server.server_port}/index.html", pictures)
            for part in (trial.title, trial.level, trial.lose, trial.link, trial.touch):
                part()
            faults = browser.faults()
            trial.expect(not faults, f"the browser reports no error {faults[:3]}")
        finally:
            browser.close()
    print(f"{len(trial.failed)} failed")
    return 1 if trial.failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
