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

from browser import Trial, bomb, judged, trial_of

REPLAYS = pathlib.Path(__file__).parents[1] / "replays"
SIZES = ((360, 640), (1280, 720), (1920, 1080))
TITLE, LEVELS, HELP, PLAYING, PAUSED, OVER, DUEL = 0, 1, 6, 7, 8, 9, 13  # of Screen in stage.hpp
MODE, PADDLE, SERVING, CHOSEN, BALL, RESULT = 4, 5, 6, 7, 8, 9  # of gameState() in main.cpp
ASSISTED = 2  # of Mode in things.hpp
WON = 1  # of Result in game_state.hpp
A, START, DOWN, RIGHT = 0, 9, 13, 15  # buttons of the standard gamepad


# What a browser may lack, done before the page loads. Sound: nothing, a constructor that throws, a
# context that never starts.
LACKS = {
    "no Web Audio": "delete window.AudioContext; delete window.webkitAudioContext;",
    "a Web Audio that throws": "window.AudioContext = class { constructor() { throw new Error('no'); } };",
    "sound that is refused": """AudioContext.prototype.resume = () => Promise.reject(new Error("refused"));
        Object.defineProperty(AudioContext.prototype, "state", { get: () => "suspended" });""",
    "no typefaces": "document.fonts.load = () => Promise.reject(new Error('a network error'));",
    "gamepads that are forbidden": "navigator.getGamepads = () => { throw new Error('forbidden'); };",
    "no storage": "Object.defineProperty(window, 'indexedDB', { value: undefined });",
    "storage that never answers": "IDBFactory.prototype.open = () => ({});",
}


class Game(Trial):
    def state(self, what, player=0):
        """A number of gameState() in main.cpp; -1 before the game has started."""
        return self.browser.run(
            f"try {{ return Module._gameState({what}, {player}); }} catch (error) {{ return -1; }}")

    def arrives(self, screen):
        """The seconds until a screen is there, or None."""
        return self.wait(f"Module._gameState(0) === {screen}")

    def passes(self, tick):
        return self.wait(f"Module._gameState(1) > {tick}")

    def place(self, name):
        """Where a word or a level is in the picture (pixels): gamePlace() in main.cpp."""
        return [round(float(part)) for part in self.browser.run(
            f"return Module.ccall('gamePlace', 'string', ['string'], ['{name}']);").split()]

    def stands_still(self, player=0):
        tick = self.state(1, player)
        self.draws(20)
        return self.state(1, player) == tick

    def at_rest(self, player):
        """The places (mm) of a player's paddle and of the other's, once no key of before moves them."""
        last = None
        for _ in range(100):
            now = self.state(PADDLE, player), self.state(PADDLE, 1 - player)
            if now == last:
                break
            last = now
            self.draws(5)
        return now

    def moves(self, key, player=0):
        """The way (mm) of a player's paddle while a key is held, and that of the other's."""
        before = self.at_rest(player)
        far = f"Math.abs(Module._gameState({PADDLE}, {player}) - {before[0]}) > 500"
        self.until(far, lambda: self.browser.hold(key, 0.3))
        return self.state(PADDLE, player) - before[0], self.state(PADDLE, 1 - player) - before[1]

    def serves(self, act, player=0):
        """True if an act, again and again, serves the ball of a player."""
        return self.state(SERVING, player) == 1 and self.until(
            f"Module._gameState({SERVING}, {player}) === 0", act)

    def title(self):
        self.browser.open(self.address)
        seconds = self.arrives(TITLE)
        self.expect(seconds is not None, f"the title appears ({seconds} s after the page)")
        self.passes(60)
        self.shot("title")

    def level(self):
        self.browser.open(self.address + "#level=quarry")
        self.expect(self.arrives(PLAYING), "a link starts a level")
        self.expect(self.until("Module._gameState(2) > 0", lambda: self.browser.press(" ")),
                    "a serve by the space key scores")
        self.expect(self.moves("left")[0] < -500, "the left key moves the paddle to the left")
        self.shot("level")
        self.browser.press("p")
        self.expect(self.arrives(PAUSED), "the key P pauses")
        self.expect(self.stands_still(), "a paused game stands still")
        self.shot("pause")

    def lost(self):
        """A context is lost when the machine sleeps, for instance."""
        self.browser.open(self.address + "#level=quarry")
        self.passes(30)
        before = len(self.browser.shot())
        self.browser.run("""window.losing = document.getElementById("canvas").getContext("webgl2")
            .getExtension("WEBGL_lose_context"); losing.loseContext();""")
        self.wait("document.getElementById('canvas').getContext('webgl2').isContextLost()")
        self.draws(3)
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
        self.until(f"Module._gameState(0) === {OVER}", self.stay_aside, 300)

    def stay_aside(self):
        self.browser.press(" ")
        self.browser.hold("left", 0.5)

    def lacking(self):
        """The game starts and plays with what the browser has."""
        for lack, script in LACKS.items():
            with self.browser.before_pages(script):
                self.browser.open(self.address + "#level=quarry")
                self.expect(self.arrives(PLAYING) and self.serves(lambda: self.browser.press(" ")) and
                            self.passes(self.state(1) + 60), f"with {lack} a level is played")

    def win(self):
        """A level is won by keys: the paddle follows the ball, a little beside it."""
        self.drop_file((REPLAYS / "levels/single.toml").read_text(encoding="utf-8"))
        self.expect(self.arrives(PLAYING), "a level of one block is played")
        held, end = None, time.monotonic() + 120
        while self.state(RESULT) == 0 and time.monotonic() < end:
            place, ball, tick, serving = (self.state(what) for what in (PADDLE, BALL, 1, SERVING))
            way = ball + 500 * (tick // 240 % 3 - 1) - place
            key = None if abs(way) < 300 else "left" if way < 0 else "right"
            if key != held:
                self.browser.hold_on(key, held)
                held = key
            if serving:
                self.browser.press(" ")
        self.browser.hold_on(None, held)
        self.expect(self.arrives(OVER) and self.state(RESULT) == WON, "a level is won by keys")
        self.draws(30)
        self.shot("won")

    def replays(self):
        """All scripted replays, with the hashes that the native program wrote into them."""
        files = {path.relative_to(REPLAYS): path.read_text(encoding="utf-8")
                 for path in [*REPLAYS.glob("*.replay"), *REPLAYS.glob("levels/*.toml")]}
        self.browser.open(self.address)
        self.arrives(TITLE)
        self.browser.run("FS.mkdirTree('/replays/levels');")
        differ = {}
        for name, text in sorted(files.items(), key=lambda file: file[0].suffix != ".toml"):
            self.browser.run(f"FS.writeFile('/replays/{name}', {json.dumps(text)});")
            if name.suffix == ".replay":
                differ[str(name)] = self.browser.run(
                    f"return Module.ccall('verifyReplay', 'string', ['string'], ['/replays/{name}']);")
        wrong = {name: verdict for name, verdict in differ.items() if verdict != ""}
        self.expect(differ and not wrong, f"{len(differ) - len(wrong)} of {len(differ)} scripted replays have the "
                                          f"same states in the browser {wrong or ''}")

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
        line, link = self.clipboard().split("\n")
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
        self.browser.open(self.address + "#replay=" + bomb(400))
        self.tells("is longer than", "a link that unpacks to 400 MB")
        read = self.number("FS.stat('/link.replay').size")
        self.expect(read < 20e6, f"of which {read / 1e6:.1f} MB are unpacked")

    def drop_file(self, text, name="mine.toml"):
        self.browser.open(self.address)
        self.arrives(TITLE)
        self.browser.run(f"""const data = new DataTransfer();
            data.items.add(new File([{json.dumps(text)}], "{name}"));
            window.dispatchEvent(new DragEvent("drop", {{ dataTransfer: data, cancelable: true }}));""")

    def drop(self):
        """A level of the player's own comes by drag and drop, and stays."""
        self.drop_file("title = nonsense", "broken.toml")
        self.tells("broken.toml:1:", "an error of a dropped level")
        self.drop_file("title = 'x'", "first_light.toml")
        self.tells("rename the file", "a level with a name of the game's")
        for link in ("level=broken", "level=nonsense", "daily=2026-02-30"):
            self.browser.open(self.address + "#" + link)
            self.expect(self.arrives(TITLE), f"#{link} starts with the title")
            self.tells("there is no level", f"#{link}")
            told = self.number("document.getElementById('news').textContent")
            self.expect(len(told) <= 302 and told.endswith((" \u2026", ".")), "no word of it is cut in two")
        example = pathlib.Path(__file__).parents[2] / "game/examples/gallows.toml"
        self.drop_file(example.read_text(encoding="utf-8"))
        self.expect(self.arrives(PLAYING), "a dropped level is played")
        self.shot("dropped")
        self.browser.open(self.address + "#level=mine")
        self.expect(self.arrives(PLAYING), "a dropped level is kept")
        first = self.browser.call("GET", "/window")
        second = self.browser.call("POST", "/window/new", {"type": "tab"})["handle"]
        self.browser.call("POST", "/window", {"handle": second})
        self.browser.open(self.address)
        self.tells("another tab", "a second tab that keeps nothing")
        self.browser.call("DELETE", "/window")
        self.browser.call("POST", "/window", {"handle": first})

    def tells(self, words, what):
        """The page says so."""
        told = "document.getElementById('news').textContent"
        held = self.wait(f"{told}.includes({json.dumps(words)})") is not None
        self.expect(held, f"{what} is told: {self.number(told)}")

    def map(self):
        """The map by keys, on all sizes of screens: chosen by arrows, played by enter, left by escape."""
        for width, height in SIZES:
            self.browser.resize(width, height)
            self.browser.open(self.address)
            self.arrives(TITLE)
            self.browser.press("down")
            self.browser.press("enter")
            self.expect(self.arrives(LEVELS), f"keys open the map at {width} x {height}")
            self.next = int(self.state(CHOSEN))  # the first level not cleared: a game before may have been won
            self.browser.press("right")
            self.expect(self.wait(f"Module._gameState({CHOSEN}) === {self.next + 1}"),
                        "the right key goes to the next level")
            self.draws(30)
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
        self.passes(60)
        self.shot("phone-title")
        row = self.place("Map")[1] - self.place("Play")[1]
        self.expect(row >= 40, f"a row of the title is {row} pixels high, enough for a finger")
        self.tap("Map")
        self.expect(self.arrives(LEVELS), "a tap on a word of the title opens the map")
        self.draws(30)
        self.shot("phone-map")
        self.tap("back")
        self.expect(self.arrives(TITLE), "a tap on its word leaves the map")
        self.tap("How to play")
        self.expect(self.arrives(HELP), "a tap opens the help")
        for _ in range(2):
            self.draws(10)
            self.browser.tap(180, 320)
        self.expect(self.arrives(TITLE), "and two more leave it")
        self.tap("Map")
        self.arrives(LEVELS)
        self.tap("2", 18)
        self.expect(self.arrives(PLAYING), "a tap beside an open level plays it")
        self.shot("phone-level")
        before = self.state(PADDLE)
        self.browser.drag((180, 300), (180, 420))
        self.expect(self.wait(f"Module._gameState({PADDLE}) > {before} + 500"),
                    "a finger moves the paddle along the turned picture")
        self.expect(self.serves(lambda: self.browser.tap(180, 320)), "a tap serves in the turned picture")
        self.browser.touch(False)

    def tap(self, name, beside=0):
        """Taps what has a name in a picture that is turned, or some pixels to the right of it."""
        x, y = self.place(name)
        self.browser.tap(*self.turned(360, x + beside, y))

    def duel(self):
        """Two players at one screen: each key moves one paddle, each player serves."""
        self.browser.resize(1280, 720)
        self.choose("Duel", LEVELS)
        self.draws(3)
        self.expect(self.state(CHOSEN) == self.next, "a mouse that rests on the map chooses no level")
        self.browser.press("enter")
        self.expect(self.arrives(DUEL), "the map of a duel starts one")
        for player, keys in enumerate((("a", "d"), ("left", "right"))):
            own, other = self.moves(keys[0], player)
            self.expect(own < -500 and other == 0, f"{keys[0]} moves player {player + 1} alone, to the left")
            own, other = self.moves(keys[1], player)
            self.expect(own > 500 and other == 0, f"{keys[1]} moves player {player + 1} alone, to the right")
        for player, key in enumerate((" ", "enter")):
            self.expect(self.serves(lambda: self.browser.press(key), player), f"player {player + 1} serves")
        self.shot("duel")
        self.browser.press("p")
        self.draws(3)
        self.expect(self.stands_still(0) and self.stands_still(1), "P pauses both games")
        self.shot("duel-pause")

    def pads(self, count):
        """Gamepads that are held as window.pads says: they stand where the browser has its own."""
        self.browser.run("""window.pads = Array.from({ length: arguments[0] }, (_, index) => ({ index,
                id: "pad", mapping: "standard", connected: true, timestamp: 0, axes: [0, 0, 0, 0],
                buttons: Array.from({ length: 17 }, () => ({ pressed: false, value: 0 })) }));
            navigator.getGamepads = () => window.pads;""".replace("arguments[0]", str(count)))

    def stick(self, pad, x):
        self.browser.run(f"window.pads[{pad}].axes[0] = {x};")

    def push(self, button, pad=0):
        """A button of a gamepad goes down and up again, each for some frames."""
        for down in ("true", "false"):
            self.browser.run(f"window.pads[{pad}].buttons[{button}].pressed = {down};")
            self.draws(4)

    def tilts(self, pad, player):
        """True if the stick of a gamepad moves the paddle of a player both ways."""
        for way in (-1, 1):
            before = self.state(PADDLE, player)
            self.stick(pad, way)
            if self.wait(f"{way} * (Module._gameState({PADDLE}, {player}) - {before}) > 500") is None:
                return False
            self.stick(pad, 0)
        return True

    def gamepad(self):
        """From the title into a game and a duel by gamepads alone."""
        self.browser.open(self.address)
        self.arrives(TITLE)
        self.pads(1)
        self.push(DOWN)
        self.push(A)
        self.expect(self.arrives(LEVELS), "a gamepad opens the map")
        self.push(A)
        self.expect(self.arrives(PLAYING), "its button A plays the chosen level")
        self.expect(self.tilts(0, 0), "its stick moves the paddle")
        self.expect(self.serves(lambda: self.push(A)), "its button A serves")
        self.push(START)
        self.expect(self.arrives(PAUSED), "its button start pauses")
        self.browser.open(self.address)
        self.arrives(TITLE)
        self.pads(2)
        for _ in range(4):
            self.push(DOWN, 1)
        self.push(A, 1)
        self.arrives(LEVELS)
        self.push(A, 1)
        self.expect(self.arrives(DUEL), "the second gamepad starts a duel")
        for pad in (0, 1):
            self.expect(self.tilts(pad, pad), f"gamepad {pad + 1} moves player {pad + 1}")
            self.expect(self.serves(lambda: self.push(A, pad), pad), f"and serves for player {pad + 1}")

    def assisted(self):
        """The rules are changed on the title, and stay after a new start."""
        self.browser.open(self.address)
        self.arrives(TITLE)
        for _ in range(5):
            self.browser.press("down")
        for _ in range(2):
            self.browser.press("right")
        self.draws(10)
        self.shot("assisted-title")
        for _ in range(5):
            self.browser.press("up")
        self.browser.press("enter")
        self.expect(self.arrives(PLAYING) and self.state(MODE) == ASSISTED, "the title changes the rules")
        self.passes(30)
        self.shot("assisted")
        self.browser.open(self.address + "#level=quarry")
        self.expect(self.arrives(PLAYING) and self.state(MODE) == ASSISTED, "and the browser keeps them")

    def choose(self, item, screen):
        """Clicks an item of the title."""
        self.browser.open(self.address)
        self.arrives(TITLE)
        self.browser.click(*self.place(item))
        self.expect(self.arrives(screen), f"a click on {item} is taken")

    @staticmethod
    def turned(height, x, y):
        """Where a point of the wide picture (pixels) is on a screen that shows it turned."""
        return height - y, x

    def touch(self):
        self.browser.resize(390, 760)
        self.browser.open(self.address + "#level=first_light")
        self.arrives(PLAYING)
        self.expect(self.serves(lambda: self.browser.tap(190, 500)), "a tap serves")
        self.shot("touch")


def main(page, pictures, program):
    with trial_of(Game, page, pictures) as game:
        game.address += "index.html"
        for part in (game.title, game.level, game.lacking, game.lost, game.win, game.lose, game.link):
            part()
        game.daily(program)
        game.drop()
        for part in (game.replays, game.map, game.phone, game.touch, game.duel, game.gamepad, game.assisted):
            part()
    return judged([game])


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]))
