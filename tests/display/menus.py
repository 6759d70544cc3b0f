#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the menus by mouse. Starts the game twice to check that settings persist:

    menus.py build/dev/bin/apart build/dev/report

Exit code 0: all checks passed, 1: one failed, 77: a tool is missing."""
import pathlib
import sys
import time

sys.dont_write_bytecode = True
from virtual_screen import (Program, Screen, check, difference, judged, skip_without_tools,  # noqa: E402
                            wait_until)

# Pixels per metre in a window of 1280x800, and the height of the picture's centre (layout.hpp).
SCALE = 1280 / 31.2
MIDDLE_Y = 9.25
ROW = 0.98  # m, between items of a menu


def item(top, number):
    """Pixel position of an item on screens that are centred on the field."""
    return 640, round(400 - SCALE * (top - ROW * number - 0.45 - MIDDLE_Y))


def at(x, y):
    return round(640 + SCALE * x), round(400 - SCALE * (y - MIDDLE_Y))


def after(game, report, name, action, least=20000):
    """Runs an action and returns the picture once it has changed."""
    before = game.picture(report / "before.png")
    action()
    path = report / name
    wait_until(f"the picture changes ({name})",
               lambda: difference(game.screen, before, game.picture(path)) > least)
    before.unlink()
    time.sleep(0.3)
    return game.picture(path)


def first_run(screen, apart, report, profile):
    with Program(screen, "aPart", apart, "--mute", "--seed", "1") as game:
        time.sleep(1)
        after(game, report, "menu_levels.png", lambda: game.click(*item(10.5, 1)))
        after(game, report, "menu_title.png", lambda: game.click(*at(-13, 0.7)))
        check("level select and back, by mouse", True)
        after(game, report, "menu_options.png", lambda: game.click(*item(10.5, 7)))
        game.click(*at(1.75, 13.2 - 0.45))  # the middle of the sound bar
        game.key("Escape")
        wait_until("the settings are written", profile.exists)
        check("a click on a bar turns it: half the sound", "sound = 50" in profile.read_text())
        after(game, report, "menu_play.png", lambda: game.click(*item(10.5, 0)))
        check("play, by mouse", True)
        game.key("Escape", "Up", "Return")
        time.sleep(0.5)
        game.click(*item(10.5, 8))
        game.click(*item(10.5, 8))  # opens the question
        code, output = game.wait_for_end()
        check(f"quit, by mouse: exit code {code}", code == 0 and output.strip() == "")


def second_run(screen, apart, report, profile):
    with Program(screen, "aPart", apart, "--mute", "--seed", "1") as game:
        time.sleep(0.5)
        game.key("Up", "Up", "Return")  # options
        time.sleep(0.5)
        game.key("Up", "Down", "Left", "Escape", "Escape", "Escape")
        code, _ = game.wait_for_end()
        check("the settings of the last run were read", code == 0 and "sound = 40" in profile.read_text())


def bound_run(screen, apart, report, profile):
    """Binds X to serve: the profile keeps it, and it serves in the game."""
    with Program(screen, "aPart", apart, "--mute", "--seed", "1") as game:
        time.sleep(0.5)
        game.key("Up", "Up", "Return", "Up", "Up", "Up", "Return")  # keys and buttons
        time.sleep(0.3)
        game.key("Down", "Down", "Down", "Down", "Return")
        after(game, report, "menu_keys.png", lambda: game.key("p"), least=1500)  # refused: in use
        game.key("Return", "x", "Escape", "Escape")
        time.sleep(0.3)
        game.click(*item(10.5, 0))  # play
        time.sleep(1.2)
        game.key("space")  # not bound any more
        # Title and hint of the level vanish with the serve.
        after(game, report, "menu_served.png", lambda: game.key("x"), least=4000)
        check("a bound key serves", True)
        game.key("Escape", "Up", "Return")
        time.sleep(0.5)
        game.key("Escape", "Escape")
        code, _ = game.wait_for_end()
        check("it is kept", code == 0 and 'serve = ["X", "-", 1]' in profile.read_text())


def broken_run(screen, apart, profile):
    profile.write_text("format = 1\n[settings]\nsound = \"loud\"\n")
    with Program(screen, "aPart", apart, "--mute") as game:
        time.sleep(0.5)
        game.key("Escape", "Escape")
        code, output = game.wait_for_end()
        check("a broken file is said in a sentence", code == 0 and "profile.toml.broken" in output)
        check("it is kept aside", "loud" in profile.with_name("profile.toml.broken").read_text())
        check("and a good one takes its place", "sound = 80" in profile.read_text())


def main():
    apart, report = sys.argv[1], pathlib.Path(sys.argv[2])
    report.mkdir(parents=True, exist_ok=True)
    skip_without_tools()

    def work():
        with Screen() as screen:
            profile = pathlib.Path(screen.config.name) / "apart" / "profile.toml"
            first_run(screen, apart, report, profile)
            second_run(screen, apart, report, profile)
            bound_run(screen, apart, report, profile)
            broken_run(screen, apart, profile)
    return judged(work, report)


if __name__ == "__main__":
    sys.exit(main())
