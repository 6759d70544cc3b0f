# SPDX-License-Identifier: MIT
"""A virtual screen, programs in windows on it, and their keys, mouse and pictures."""
import contextlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SKIPPED = 77  # exit code that ctest reports as skipped
TOOLS = {"Xvfb": "xvfb", "xdotool": "xdotool", "import": "imagemagick", "compare": "imagemagick"}


def skip_without_tools():
    missing = sorted({package for tool, package in TOOLS.items() if shutil.which(tool) is None})
    if missing:
        print(f"Skipped: {', '.join(missing)} missing (Debian: apt-get install {' '.join(missing)}).")
        sys.exit(SKIPPED)


def check(what, true):
    print(f"{'ok    ' if true else 'FAILED'} {what}", flush=True)
    if not true:
        raise AssertionError(what)


def judged(work, report):
    """Runs work() and returns the exit code: 0 if all checks pass, 1 if one fails."""
    try:
        work()
    except AssertionError as error:
        print(f"FAILED {error}\nPictures: {report}")
        return 1
    return 0


def run_without_display(*command):
    env = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run(command, env=env, capture_output=True, text=True, timeout=60)


def wait_until(what, test, seconds=60.0):
    """Returns the first true value of test(); fails with `what` after a timeout in seconds."""
    end = time.monotonic() + seconds
    while True:
        value = test()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError(f"{what}: not within {seconds:.0f} s")
        time.sleep(0.05)


class Screen:
    """An Xvfb server that ends with the `with` block. The screen is square, since SFML 2.5.1
    centres windows vertically by the width. -noreset keeps the server running when its last
    client exits."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1600x1600x24", "-nolisten", "tcp",
             "-noreset"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise AssertionError("Xvfb did not start")
        self.config = tempfile.TemporaryDirectory()  # isolated from the user's settings
        self.env = {**os.environ, "DISPLAY": f":{number}", "LIBGL_ALWAYS_SOFTWARE": "1",
                    "XDG_CONFIG_HOME": self.config.name}
        self.env.pop("WAYLAND_DISPLAY", None)
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()
        self.config.cleanup()

    def run(self, *command, seconds=60):
        return subprocess.run(command, env=self.env, capture_output=True, text=True, timeout=seconds)

    def xdotool(self, *words):
        result = self.run("xdotool", *map(str, words))
        if result.returncode:
            raise AssertionError(f"xdotool {' '.join(map(str, words))}: {result.stderr.strip()}")
        return result.stdout.split()

    def root(self):
        return self.xdotool("search", "--maxdepth", "0", ".*")[0]


class Program:
    """A program with a window of a given title. It is terminated with the `with` block if
    necessary."""

    def __init__(self, screen, title, *command, focus=True):
        self.screen, self.title, self.command, self.focus = screen, title, command, focus

    def __enter__(self):
        self.process = subprocess.Popen(self.command, env=self.screen.env, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, text=True)
        self.window = wait_until("the window opens", self._find)
        if self.focus:
            self.screen.xdotool("windowfocus", self.window)  # there is no window manager
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()

    def _find(self):
        if self.process.poll() is not None:
            raise AssertionError(f"it ended with {self.process.returncode}: {self.process.stdout.read()}")
        found = self.screen.run("xdotool", "search", "--onlyvisible", "--name", f"^{self.title}$").stdout.split()
        return found[0] if found else None

    def _check_running(self):
        if self.process.poll() is not None:
            raise AssertionError(f"it has ended already, with {self.process.returncode}: {self.process.stdout.read()}")

    def key(self, *names):
        self._check_running()
        self.screen.xdotool("key", *names)

    @contextlib.contextmanager
    def held(self, name):
        """The key is down during the `with` block."""
        self._check_running()
        self.screen.xdotool("keydown", name)
        yield
        self.screen.xdotool("keyup", name)

    def point(self, x, y):
        self._check_running()
        self.screen.xdotool("mousemove", "--window", self.window, x, y)

    def click(self, x, y):
        self.point(x, y)
        self.screen.xdotool("click", 1)

    def pointer(self):
        """Position of the mouse in pixels of the window."""
        def values(*words):
            return dict(line.split("=") for line in self.screen.xdotool(*words) if "=" in line)
        mouse = values("getmouselocation", "--shell")
        window = values("getwindowgeometry", "--shell", self.window)
        return int(mouse["X"]) - int(window["X"]), int(mouse["Y"]) - int(window["Y"])

    def size(self):
        geometry = self.screen.xdotool("getwindowgeometry", "--shell", self.window)
        values = dict(line.split("=") for line in geometry)
        return int(values["WIDTH"]), int(values["HEIGHT"])

    def picture(self, path):
        self._check_running()  # import waits for ever for a window that is gone
        result = self.screen.run("import", "-window", self.window, "-depth", "8", str(path))
        if result.returncode:
            raise AssertionError(f"no picture of the window: {result.stderr.strip()}")
        return path

    def look(self, name="now"):
        """A picture for comparisons alone: without compression, which takes most of the time."""
        return self.picture(pathlib.Path(self.screen.config.name) / f"{name}.ppm")

    def after(self, what, action, least, area=None, fuzz=8):
        """Runs an action and waits until at least that many pixels have changed: keys that depend
        on the new screen must not be sent before, however slow the machine is."""
        before = self.look("before")
        action()
        wait_until(f"the picture changes ({what})",
                   lambda: difference(self.screen, before, self.look(), area, fuzz) >= least)

    def wait_until_drawn(self, area):
        """Waits for a bright pixel in an area; a new window is black."""
        wait_until("the window is drawn", lambda: brightest(self.screen, self.look(), area) > 0.5)

    def to_title(self, question="300x24+377+678", title="400x16+440+761"):
        """Takes the last item of the pause menu. A game with points asks once, and the question
        expires. The areas, of the question and of the lowest text of the title, are those of a window
        of 1280x800."""
        def seen(area):
            return brightest(self.screen, self.look(), area) > 0.5
        self.key("Up")
        while True:
            self.key("Return")
            wait_until("the title or a question", lambda: seen(title) or seen(question))
            if seen(title):
                return
            self.key("Return")
            wait_until("the question ends", lambda: not seen(question))
            if seen(title):
                return

    def wait_until_still(self, area, fuzz=8):
        """Waits until the pixels of an area hardly differ between two pictures."""
        def still():
            before = self.look("before")
            time.sleep(0.1)
            return difference(self.screen, before, self.look(), area, fuzz) < 50
        wait_until("the picture is still", still)

    def wait_for_end(self, seconds=60):
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            raise AssertionError(f"it did not end within {seconds} s") from None
        return self.process.returncode, self.process.stdout.read()

    def end_by(self, action):
        """Repeats an action until the program ends: one opens a question, and one within the time
        of that question answers it. Returns exit code and output."""
        end = time.monotonic() + 60
        while self.process.poll() is None and time.monotonic() < end:
            try:
                action()
                self.process.wait(0.2)
            except subprocess.TimeoutExpired:
                continue
            except AssertionError:  # it ended before the action
                break
        return self.wait_for_end(1)


def difference(screen, one, other, area=None, fuzz=8):
    """Number of pixels that differ by more than `fuzz` percent; area is WxH+X+Y."""
    crop = ["-extract", area] if area else []
    result = screen.run("compare", *crop, "-metric", "AE", "-fuzz", f"{fuzz}%", str(one), str(other), "null:")
    return int(float(result.stderr.split()[0]))


def brightest(screen, picture, area):
    """Maximum brightness, 0..1, of all pixels in an area WxH+X+Y."""
    result = screen.run("convert", str(picture), "-crop", area, "-format", "%[fx:maxima]", "info:")
    return float(result.stdout)
