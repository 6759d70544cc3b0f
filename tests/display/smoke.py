#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Starts the game on a virtual screen and plays it by keys and mouse:

    smoke.py build/dev/bin/apart build/dev/report

The second folder receives pictures of each screen. Exit code 0: all checks passed, 1: one
failed, 77: a tool is missing."""
import pathlib
import signal
import sys
import time

sys.dont_write_bytecode = True
from virtual_screen import (Program, Screen, brightest, check, difference, judged,  # noqa: E402
                            run_without_display, skip_without_tools, wait_until)

PADDLE = "1000x90+36+700"  # area of the paddle in a window of 1280x800
MOVED = {"area": PADDLE, "fuzz": 30}  # the light around the paddle changes by less
MENU = "460x34+296+304"  # the first item of the pause screen
FIELD = "900x300+60+60"
MANY = 1500  # pixels; the paddle alone has about 4000
VEIL = 400000  # pixels that the pause screen darkens
SCREEN = 12000  # pixels between two screens in a window of 800x760


def check_without_display(apart):
    probe = run_without_display(apart, "--probe-display")
    check("without a display the probe says 3 and nothing else", probe.returncode == 3 and not probe.stderr)
    plain = run_without_display(apart)
    check("without a display the game says so and exits with 3",
          plain.returncode == 3 and "no display" in plain.stderr)


def inside(game):
    x, y = game.pointer()
    return 0 < x < 1280 and 0 < y < 800


def changed(game, report, before, name, area=None, least=MANY, fuzz=8):
    """Waits until the picture differs from an older one, and returns the new one."""
    path = report / name

    def look():
        return difference(game.screen, before, game.picture(path), area, fuzz) >= least
    wait_until(f"the picture changes ({name})", look)
    return path


def check_without_window_manager(screen, apart, report):
    """The window receives keys without being given the focus."""
    with Program(screen, "aPart", apart, "--mute", "--level", "first_light", focus=False) as game:
        game.wait_until_drawn(FIELD)
        time.sleep(0.5)  # it would pause now
        check("the game is not paused when it starts", brightest(screen, game.look(), FIELD) > 0.5)
        game.after("pause", lambda: game.key("p"), least=VEIL)
        check("the window takes the keys without being given the focus", True)


def play(screen, apart, report):
    with Program(screen, "aPart", apart, "--mute", "--seed", "1") as game:
        check("the window opens", game.window)
        blank = report / "blank.png"
        screen.run("convert", "-size", "x".join(map(str, game.size())), "xc:black", str(blank))
        title = changed(game, report, blank, "1_title.png")
        check("the title screen is drawn", True)

        game.key("Return")
        waiting = changed(game, report, title, "2_serve.png", least=20000)
        check("enter starts a level", True)

        game.wait_until_still(**MOVED)
        waiting = game.picture(waiting)
        with game.held("Right"):
            right = changed(game, report, waiting, "3_right.png", **MOVED)
        game.wait_until_still(**MOVED)
        right = game.picture(right)
        with game.held("Left"):
            changed(game, report, right, "4_left.png", **MOVED)
        check("the arrow keys move the paddle", True)

        game.wait_until_still(**MOVED)
        game.after("mouse", lambda: screen.xdotool("mousemove_relative", 250, 0), MANY, **MOVED)
        check("the mouse moves the paddle", True)
        # The sum exceeds the window's width: the mouse must not stop at a border.
        for _ in range(12):
            screen.xdotool("mousemove_relative", 150, 0)
            wait_until("the mouse is put back into the window", lambda: inside(game))
        check("the mouse stays inside the window", True)
        for _ in range(3):
            screen.xdotool("mousemove_relative", "--", -150, 0)
            wait_until("the mouse is put back into the window", lambda: inside(game))
        game.wait_until_still(**MOVED)
        game.picture(report / "5_mouse.png")

        game.key("space")
        changed(game, report, report / "5_mouse.png", "6_flight.png", "900x560+60+60", least=300)
        check("space serves the ball", True)

        game.key("p")
        changed(game, report, report / "6_flight.png", "7_paused.png", least=VEIL)
        one = game.picture(report / "7_paused.png")
        time.sleep(0.5)  # the menu must not be animated
        two = game.picture(report / "still.png")
        check("P pauses: nothing moves", difference(screen, one, two) == 0)
        two.unlink()

        game.key("p")  # resume
        changed(game, report, report / "7_paused.png", "on.png", least=VEIL)
        (report / "on.png").unlink()
        screen.xdotool("windowfocus", screen.root())
        wait_until("losing the focus pauses",
                   lambda: difference(screen, one, game.picture(report / "away.png"), MENU) < 8000)
        (report / "away.png").unlink()
        screen.xdotool("windowfocus", game.window)
        check("losing the focus pauses", True)

        screen.xdotool("windowsize", game.window, 800, 760)
        wait_until("the window takes its new size", lambda: game.size() == (800, 760))
        # The aspect ratio stays the same: the borders above and below are dark. A collapse behind the
        # menu may move the frame of the field there, which has a brightness of 0.2.
        wait_until("the picture fits the new size",
                   lambda: brightest(screen, game.picture(report / "8_resized.png"), "800x90+0+0") < 0.3
                   and brightest(screen, report / "8_resized.png", "800x400+0+150") > 0.5)
        check("the window can be resized", True)

        game.after("resume", lambda: game.key("Escape"), least=SCREEN)
        game.after("pause", lambda: game.key("Escape"), least=SCREEN)
        game.to_title(question="240x16+210+554", title="240x12+280+605")
        code, output = game.end_by(lambda: game.key("Escape", "Escape"))
        check(f"escape leaves the title: exit code {code}", code == 0)
        check("nothing was written to the terminal", output.strip() == "")
        blank.unlink()


def check_interruption(screen, apart, number):
    """A signal ends the program as the button of the window does: the running game is kept."""
    kept = pathlib.Path(screen.config.name) / "apart" / "last.replay"
    kept.unlink(missing_ok=True)
    with Program(screen, "aPart", apart, "--mute", "--level", "first_light") as game:
        game.wait_until_drawn(FIELD)
        time.sleep(4)  # shorter games are not kept
        game.process.send_signal(number)
        code, output = game.wait_for_end()
        check(f"{number.name} ends the program: exit code {code}", code == 0 and output.strip() == "")
    check(f"{number.name} keeps the running game", kept.exists())


def check_screenshot(screen, apart, report):
    path = report / "screenshot.png"
    result = screen.run(apart, "--level", "first_light", "--screenshot", str(path), "--at", "600")
    check("--screenshot writes a picture", result.returncode == 0 and path.stat().st_size > 10000)
    size = screen.run("identify", "-format", "%wx%h", str(path)).stdout
    check(f"the picture has the size of the window: {size}", size == "1280x800")
    again = report / "again.png"
    screen.run(apart, "--level", "first_light", "--screenshot", str(again), "--at", "600")
    check("the same seed and tick give the same picture", difference(screen, path, again) == 0)
    again.unlink()
    bad = screen.run(apart, "--screenshot", "/nowhere/x.png")
    check("a picture that cannot be written is an error in a sentence",
          bad.returncode == 2 and "/nowhere/x.png" in bad.stderr)
    seed = screen.run(apart, "--seed", "99999999999")
    check("a seed that is none is an error in a sentence",
          seed.returncode == 2 and "a whole number from 0 to 4294967295, not '99999999999'" in seed.stderr)
    empty = screen.run(apart, "--level=")
    check("a level without a name is refused", empty.returncode == 2 and "level" in empty.stderr)
    wrong = screen.run(apart, "--level", "no_such_level")
    check("an unknown level is an error that names the levels",
          wrong.returncode == 2 and "first_light" in wrong.stderr)


def main():
    apart, report = sys.argv[1], pathlib.Path(sys.argv[2])
    report.mkdir(parents=True, exist_ok=True)

    def work():
        check_without_display(apart)
        skip_without_tools()
        with Screen() as screen:
            check_screenshot(screen, apart, report)
            check_without_window_manager(screen, apart, report)
            play(screen, apart, report)
            for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
                check_interruption(screen, apart, number)
        print(f"Pictures: {report}")
    return judged(work, report)


if __name__ == "__main__":
    sys.exit(main())
