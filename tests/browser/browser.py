# SPDX-License-Identifier: MIT
"""A headless Chromium, a server of static files, and the course of a test: for the tests beside it."""
import base64
import contextlib
import functools
import http.server
import json
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request
import zlib

KEYS = {"enter": "\ue007", "escape": "\ue00c", "left": "\ue012", "right": "\ue014", "up": "\ue013",
        "down": "\ue015", "tab": "\ue004", "page down": "\ue00f", "page up": "\ue00e"}

LONGEST = 240  # s, of a script of a test


class Browser:
    """A Chromium, by the WebDriver protocol (W3C)."""

    def __init__(self, profile, preferences=None):
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        port = next(line.split()[-1].rstrip(".") for line in self.driver.stdout if "port" in line and
                    "started" in line)
        threading.Thread(target=self.driver.stdout.read, daemon=True).start()
        self.base = f"http://127.0.0.1:{port}/session"
        # Without a graphics card Chromium draws WebGL by SwiftShader, and puts the page together itself.
        # With --use-angle=swiftshader OpenGL in software would do that, too, at 15 ms a frame.
        arguments = (
            "--headless --no-sandbox --disable-quic --no-first-run --disable-background-networking"
            " --disable-component-update --disable-sync --enable-unsafe-swiftshader"
            f" --user-data-dir={profile} --window-size=1280,800"
        ).split()
        options = {"args": arguments, "binary": shutil.which("chromium"), "prefs": preferences or {}}
        # A loaded machine without a graphics card draws a frame a second.
        wanted = {"capabilities": {"alwaysMatch": {
            "timeouts": {"script": 1000 * LONGEST}, "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL"}}}}
        self.base += "/" + self.call("POST", "", wanted)["sessionId"]

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data=data, method=method)
        request.add_header("Content-Type", "application/json")
        try:
            with urllib.request.urlopen(request, timeout=LONGEST + 60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(f"{path}: {error.read()[:300]}") from error

    def open(self, address):
        self.call("POST", "/url", {"url": "about:blank"})  # so that a new fragment loads the page
        self.call("POST", "/url", {"url": address})

    def run(self, script):
        return self.call("POST", "/execute/sync", {"script": script, "args": []})

    def later(self, promise):
        """What a promise of the page is kept with."""
        return self.call("POST", "/execute/async", {"args": [], "script":
                         f"const done = arguments[0]; Promise.resolve({promise}).then(done, done);"})

    def allow_clipboard(self):
        self.command("Browser.grantPermissions",
                     {"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]})

    def command(self, name, parameters):
        """A command of Chromium's own protocol, and its answer."""
        return self.call("POST", "/goog/cdp/execute", {"cmd": name, "params": parameters})

    @contextlib.contextmanager
    def before_pages(self, script):
        """Meanwhile each page runs a script before its own."""
        added = self.command("Page.addScriptToEvaluateOnNewDocument", {"source": script})
        yield
        self.command("Page.removeScriptToEvaluateOnNewDocument", added)

    def act(self, kind, actions, **more):
        self.call("POST", "/actions", {"actions": [
            {"type": kind, "id": kind + str(more), "actions": actions, **more}]})

    def hold(self, key, seconds):
        code = KEYS.get(key, key)
        self.act("key", [{"type": "keyDown", "value": code},
                         {"type": "pause", "duration": int(1000 * seconds)},
                         {"type": "keyUp", "value": code}])

    def hold_on(self, key, before):
        """Lets go of a key that is held and holds another one, from now on; None: no key."""
        actions = [{"type": "keyUp", "value": KEYS.get(before, before)}] if before else []
        actions += [{"type": "keyDown", "value": KEYS.get(key, key)}] if key else []
        self.act("key", actions)

    def press(self, key):
        self.hold(key, 0.05)

    def click(self, x, y):
        self.act("pointer", [{"type": "pointerMove", "x": x, "y": y, "duration": 0},
                             {"type": "pointerDown", "button": 0},
                             {"type": "pointerUp", "button": 0}],
                 parameters={"pointerType": "mouse"})

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

    def shot(self):
        """The page as a PNG."""
        return base64.b64decode(self.call("GET", "/screenshot"))

    def resize(self, width, height):
        """Sets the size of the page (pixels)."""
        self.command("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})

    def touch(self, on):
        """Whether the screen is one for fingers: then (pointer: coarse) holds."""
        self.command("Emulation.setTouchEmulationEnabled", {"enabled": on})

    def faults(self):
        log = self.call("POST", "/se/log", {"type": "browser"})
        return [entry["message"] for entry in log if entry["level"] == "SEVERE"]

    def close(self):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.kill()


def bomb(megabytes):
    """A link's data that unpack to as many zeros, a thousand times larger."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    parts = [packer.compress(bytes(1_000_000)) for _ in range(megabytes)]
    return base64.urlsafe_b64encode(b"".join([*parts, packer.flush()])).decode().rstrip("=")


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@contextlib.contextmanager
def served(folder):
    """Serves a folder; the address of its root."""
    handler = functools.partial(Quiet, directory=str(folder))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()


@contextlib.contextmanager
def chromium(preferences=None):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(profile, preferences)
        try:
            yield browser
        finally:
            browser.close()


class Trial:
    """A test of pages: what held is printed, what did not is counted."""

    def __init__(self, browser, address, pictures):
        self.browser = browser
        self.address = address
        self.pictures = pictures
        self.failed = []
        self.faults = []  # that the pages have reported

    def expect(self, holds, sentence):
        print(("holds: " if holds else "FAILS: ") + sentence, flush=True)
        if not holds:
            self.failed.append(sentence)
            self.complain()

    def complain(self):
        """Tells what the pages have reported since the last call: often the cause."""
        for fault in self.browser.faults():
            print(f"       {fault}", flush=True)
            self.faults.append(fault)

    def shot(self, name):
        (self.pictures / f"browser-{name}.png").write_bytes(self.browser.shot())

    def wait(self, script, seconds=60):
        """Waits until an expression is true; the seconds that it took, or None after some."""
        start = time.monotonic()
        while not self.browser.run(f"try {{ return Boolean({script}); }} catch (e) {{ return false; }}"):
            if time.monotonic() > start + seconds:
                return None
            time.sleep(0.05)
        return time.monotonic() - start

    def until(self, script, act, times=60):
        """Acts again and again until an expression is true. False if it never is."""
        for _ in range(times):
            act()
            if self.wait(script, 0.5) is not None:
                return True
        return False

    def draws(self, count):
        """Waits until the page has drawn some frames."""
        self.browser.later(f"""new Promise((done) => {{ let left = {count};
            const next = () => --left < 0 ? done() : requestAnimationFrame(next); next(); }})""")

    def clipboard(self):
        """Waits for a text in the clipboard."""
        text = "navigator.clipboard.readText().catch(() => '')"
        return next(filter(None, (self.browser.later(text) or time.sleep(0.1) for _ in range(300))), "")

    def number(self, expression):
        return self.browser.run(f"return {expression};")

    def fits(self, name):
        wide = self.number("document.documentElement.scrollWidth - window.innerWidth")
        self.expect(wide <= 0, f"{name} is no wider than the screen ({wide} pixels)")


def judged(trials):
    """Prints how many expectations of the trials did not hold; the exit code."""
    failed = sum(len(trial.failed) for trial in trials)
    print(f"{failed} failed")
    return 1 if failed else 0


@contextlib.contextmanager
def trial_of(kind, page, pictures, *more, preferences=None):
    """A Trial of a class in a new browser. Of a folder as `page` its server has the address; of a file
    its own. Ends the program with 77 without a browser. At its end no page may have reported an error."""
    lacks = [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]
    if lacks:
        print("Missing: " + ", ".join(lacks))
        sys.exit(77)
    pictures.mkdir(parents=True, exist_ok=True)
    local = contextlib.nullcontext(page.resolve().as_uri()) if page.is_file() else served(page)
    with local as address, chromium(preferences) as browser:
        trial = kind(browser, address, pictures, *more)
        yield trial
        trial.complain()
        trial.expect(not trial.faults, f"the browser reports no error ({len(trial.faults)})")
