#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A1, A2: starts the sandbox on a virtual screen and operates it by keys and mouse:

    window_test.py build/dev/bin/destructoooor build/dev/report

Exit code 0: all checks passed, 1: one failed, 77: a tool is missing."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "display"))
from virtual_screen import (Program, Screen, check, difference, judged, run_without_display,  # noqa: E402
                            skip_without_tools, wait_until)

SCENE = "900x640+20+80"  # without panel and help
PANEL = "320x500+955+0"
MANY = 500  # pixels


def check_without_display(program):
    plain = run_without_display(program)
    check("without a display it says so and exits with 3",
          plain.returncode == 3 and "no display" in plain.stderr)
    wrong = run_without_display(program, "--scene", "5")
    check("a scene that is not there is refused in a sentence",
          wrong.returncode == 2 and "--scene" in wrong.stderr)


def check_pictures(screen, program, report):
    """The same tower with few iterations, without and with shock propagation."""
    pictures = []
    for name, shock in (("sandbox_plain.png", "0"), ("sandbox_shock.png", "2")):
        path = report / name
        result = screen.run(program, "--scene", "2", "--rest", "1", "--shock", shock, "--picture", str(path))
        check(f"a picture with {shock} shock passes", result.returncode == 0 and path.stat().st_size > 10000)
        pictures.append(path)
    check("shock propagation can be seen", difference(screen, *pictures, SCENE) > MANY)


def changed(demo, before, name, report, area):
    path = report / name
    wait_until(f"the picture changes ({name})",
               lambda: difference(demo.screen, before, demo.picture(path), area) >= MANY)
    return path


def work(screen, program, report):
    with Program(screen, "Destructoooor!", program, "--scene", "1") as demo:
        demo.key("space")  # pauses
        demo.wait_until_drawn(SCENE)
        empty = demo.picture(report / "sandbox_1.png")
        screen.xdotool("mousemove", "--window", demo.window, 400, 300, "click", 1)
        dropped = changed(demo, empty, "sandbox_2.png", report, SCENE)
        check("a click drops something", True)
        demo.key("space")
        fallen = changed(demo, dropped, "sandbox_3.png", report, SCENE)
        check("it falls when the pause ends", True)
        demo.key("2")
        changed(demo, fallen, "sandbox_4.png", report, SCENE)
        check("another scene comes by its number", True)
        before = demo.picture(report / "sandbox_5.png")
        demo.key("Right", "Right", "Right", "Right", "Right", "Right", "Right", "Right")
        wait_until("a key turns a knob",
                   lambda: difference(screen, before, demo.picture(report / "sandbox_6.png"), PANEL) > 60)
        check("keys change a number", True)
        before = demo.picture(report / "sandbox_7.png")
        screen.xdotool("mousemove", "--window", demo.window, 1000, 40, "mousedown", 1)
        screen.xdotool("mousemove", "--window", demo.window, 1200, 75, "mouseup", 1)
        wait_until("the mouse moves a slider",
                   lambda: difference(screen, before, demo.picture(report / "sandbox_8.png"), PANEL) > 60)
        check("the mouse drags a slider", True)
        demo.key("Escape")
        code, output = demo.wait_for_end()
        check(f"escape leaves: exit code {code}", code == 0)
        check("nothing was written to the terminal", output.strip() == "")


def main():
    program, report = sys.argv[1], pathlib.Path(sys.argv[2])
    report.mkdir(parents=True, exist_ok=True)

    def all_of_it():
        check_without_display(program)
        skip_without_tools()
        with Screen() as screen:
            check_pictures(screen, program, report)
            work(screen, program, report)
    return judged(all_of_it, report)


if __name__ == "__main__":
    sys.exit(main())
