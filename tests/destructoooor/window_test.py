#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A1, A2: starts the sandbox on a virtual screen and operates it by keys and mouse:

    window_test.py build/dev/bin/destructoooor build/dev/report

Exit code 0: all checks passed, 1: one failed, 77: a tool is missing."""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "display"))
from virtual_screen import (Program, Screen, check, difference, judged, run_without_display,  # noqa: E402
                            skip_without_tools, wait_until)

SCENE = "720x600+240+10"  # between the panels
RIGHT = "300x700+975+10"
MANY = 500  # pixels


def check_without_display(program):
    plain = run_without_display(program)
    check("without a display it says so and exits with 3",
          plain.returncode == 3 and "no display" in plain.stderr)
    wrong = run_without_display(program, "--scene", "No such scene")
    check("a scene that is not there is refused in a sentence",
          wrong.returncode == 2 and "--list" in wrong.stderr)
    listed = run_without_display(program, "--list")
    check("all scenes are listed without a display",
          listed.returncode == 0 and len(listed.stdout.splitlines()) >= 60)


def check_pictures(screen, program, report):
    """The same tower with few iterations, without and with shock propagation."""
    pictures = []
    for scene in ("off", "on"):
        path = report / f"sandbox_shock_{scene}.png"
        result = screen.run(program, "--scene", f"Shock propagation {scene}", "--picture", str(path))
        check(f"a picture with shock propagation {scene}",
              result.returncode == 0 and path.stat().st_size > 10000)
        pictures.append(path)
    check("shock propagation can be seen", difference(screen, *pictures, SCENE) > MANY)


def check_times(screen, program):
    result = screen.run(program, "--frames", "5", "--bodies", "300", seconds=180)
    awake = [int(count) for count in re.findall(r"304 bodies, (\d+) awake", result.stdout)]
    check(f"frames are measured with an awake pile and a sleeping one ({awake} bodies awake)",
          len(awake) == 2 and awake[0] == 300 and awake[1] < 30)
    check("and their parts are told", result.stdout.count("5 frames, medians: step") == 2)


def changed(demo, before, name, report, area):
    path = report / name
    wait_until(f"the picture changes ({name})",
               lambda: difference(demo.screen, before, demo.picture(path), area) >= MANY)
    return path


def work(screen, program, report):
    with Program(screen, "Destructoooor!", program, "--scene", "Tower") as demo:
        def mouse(*words):
            screen.xdotool("mousemove", "--window", demo.window, *words)

        demo.wait_until_drawn(SCENE)
        demo.key("space")  # pauses
        demo.wait_until_still(SCENE)
        demo.key("e")  # explosion
        before = demo.picture(report / "sandbox_1.png")
        mouse(560, 440, "click", 1)
        demo.key("n", "n", "n", "n", "n", "n", "n", "n", "n", "n")
        burst = changed(demo, before, "sandbox_2.png", report, SCENE)
        check("an explosion moves the tower, step by step", True)
        demo.key("b", "b", "b", "b", "b", "b", "b", "b", "b", "b")
        changed(demo, burst, "sandbox_3.png", report, SCENE)
        check("it goes back in time", True)
        demo.key("Next")
        changed(demo, burst, "sandbox_4.png", report, SCENE)
        check("another scene comes by a key", True)
        before = demo.picture(report / "sandbox_5.png")
        mouse(1040, 88, "mousedown", 1)
        mouse(1090, 88, "mouseup", 1)
        wait_until("the mouse moves a slider",
                   lambda: difference(screen, before, demo.picture(report / "sandbox_6.png"), RIGHT) > 60)
        check("the mouse drags a slider", True)
        before = demo.picture(report / "sandbox_7.png")
        mouse(1004, 18, "click", 1)
        mouse(1054, 18, "click", 1)
        changed(demo, before, "sandbox_8.png", report, RIGHT)
        check("the measures are a tab", True)
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
            check_times(screen, program)
            work(screen, program, report)
    return judged(all_of_it, report)


if __name__ == "__main__":
    sys.exit(main())
