#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the menus by mouse. Starts the game twice to check that settings persist:

    menus.py build/dev/bin/apart build/dev/report

Exit code 0: all checks passed, 1: one failed, 77: a tool is missing."""
import pathlib
import sys

sys.dont_write_bytecode = True
from virtual_screen import Program, Screen, check, judged, skip_without_tools, wait_until  # noqa: E402

# Pixels per metre in a window of 1280x800, and the height of the picture's centre (layout.hpp).
SCALE = 1280 / 31.2
MIDDLE_Y = 9.25
ROW = 0.98  # m, between items of a menu
TITLE_TOP = 11.48  # m, of the first item on the title screen
IDEA = "600x60+200+95"  # area of a level's idea, which vanishes with the serve


def item(top, number):
    """Pixel position of an item on screens that are centred on the field."""
    return 640, round(400 - SCALE * (top - ROW * number - 0.45 - MIDDLE_Y))


def at(x, y):
    return round(640 + SCALE * x), round(400 - SCALE * (y - MIDDLE_Y))


def area_of_item(top, number):
    """Area WxH+X+Y of an item."""
    x, y = item(top, number)
    return f"460x34+{x - 230}+{y - 17}"


def after(game, name, action, least=30000, area=None):
    """Waits until an action has changed the menu. The game behind it is darkened to less than 30 %,
    which hides its changes."""
    game.after(name, action, least, area, fuzz=30)


def keep(game, report, name):
    """Keeps the present picture for people."""
    game.picture(report / f"menu_{name}.png")


def start(screen, apart, *options):
    return Program(screen, "aPart", apart, "--mute", *options)


def wait_for_title(game):
    game.wait_until_drawn(area_of_item(TITLE_TOP, 0))


def to_title(game):
    """From a level. In play, Up and Return have other meanings: they follow when the menu is shown."""
    after(game, "pause", lambda: game.key("Escape"))
    game.to_title()


def leave(game):
    """From the title."""
    return game.end_by(lambda: game.key("Escape", "Escape"))


def first_run(screen, apart, report, profile):
    with start(screen, apart, "--seed", "1") as game:
        wait_for_title(game)
        after(game, "levels", lambda: game.click(*item(TITLE_TOP, 1)))
        keep(game, report, "levels")
        after(game, "title", lambda: game.click(*at(-13, 0.7)))
        keep(game, report, "title")
        check("level select and back, by mouse", True)
        after(game, "options", lambda: game.click(*item(TITLE_TOP, 8)))
        keep(game, report, "options")
        x, y = at(1.75, 13.2 - 0.45)  # the middle of the sound bar
        after(game, "the bar", lambda: game.click(x, y), 100, f"26x10+{x + 3}+{y - 5}")
        after(game, "title", lambda: game.key("Escape"))
        wait_until("the settings are written", profile.exists)
        check("a click on a bar turns it: half the sound", "sound = 50" in profile.read_text())
        after(game, "play", lambda: game.click(*item(TITLE_TOP, 0)))
        keep(game, report, "play")
        check("play, by mouse", True)
        to_title(game)
        code, output = game.end_by(lambda: game.click(*item(TITLE_TOP, 9)))
        check(f"quit, by mouse: exit code {code}", code == 0 and output.strip() == "")


def second_run(screen, apart, report, profile):
    with start(screen, apart, "--seed", "1") as game:
        wait_for_title(game)
        after(game, "options", lambda: game.key("Up", "Up", "Return"))
        after(game, "title", lambda: game.key("Up", "Down", "Left", "Escape"))
        code, _ = leave(game)
        check("the settings of the last run were read", code == 0 and "sound = 40" in profile.read_text())


def bound_run(screen, apart, report, profile):
    """Binds X to serve: the profile keeps it, and it serves in the game."""
    with start(screen, apart, "--seed", "1") as game:
        wait_for_title(game)
        after(game, "options", lambda: game.key("Up", "Up", "Return"))
        after(game, "keys and buttons", lambda: game.key("Up", "Up", "Up", "Return"))
        x, y = at(-2.1, 12.4 - 0.98 * 4 - 0.45)
        cell = f"140x34+{x - 70}+{y - 17}"  # the key that serves
        after(game, "a key is expected", lambda: game.key("Down", "Down", "Down", "Down", "Return"), 100, cell)
        after(game, "a key in use is refused", lambda: game.key("p"), 100, cell)
        keep(game, report, "keys")
        after(game, "a key is expected", lambda: game.key("Return"), 100, cell)
        after(game, "a key is bound", lambda: game.key("x"), 100, cell)
        after(game, "options", lambda: game.key("Escape"))
        after(game, "title", lambda: game.key("Escape"))
        after(game, "play", lambda: game.click(*item(TITLE_TOP, 0)))
        game.wait_until_drawn(IDEA)
        game.key("space")  # not bound any more
        after(game, "serve", lambda: game.key("x"), 1500, IDEA)
        keep(game, report, "served")
        check("a bound key serves", True)
        to_title(game)
        code, _ = leave(game)
        check("it is kept", code == 0 and 'serve = ["X", "-", 1]' in profile.read_text())


def broken_run(screen, apart, profile):
    profile.write_text("format = 1\n[settings]\nsound = \"loud\"\n")
    with start(screen, apart) as game:
        wait_for_title(game)
        code, output = leave(game)
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
