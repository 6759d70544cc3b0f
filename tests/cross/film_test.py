#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The packed films of the page of tools/crosscheck."""
import base64
import pathlib
import random
import sys
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "lib"))

import crosscheck  # noqa: E402
import crosscheck_player as player  # noqa: E402
import crosscheck_verdicts as verdicts  # noqa: E402

STYLES = [("reference", "#000000"), ("near", "#111111"), ("far & wide", "#222222")]


PLAYS = [{"name": name} for name, *_ in crosscheck.STYLES]


def result(value, tolerance=0.5, holds=True):
    return {"value": value, "tolerance": tolerance, "holds": holds}


def unpack(text):
    planes = zlib.decompress(base64.b64decode(text))
    half = len(planes) // 2
    zigzags = [low | high << 8 for low, high in zip(planes[:half], planes[half:])]
    return [z >> 1 ^ -(z & 1) for z in zigzags]


def sums(differences):
    value = change = 0
    for difference in differences:
        change += difference
        value += change
        yield (value + 0x8000) % 0x10000 - 0x8000


class Film(unittest.TestCase):
    def test_places_are_kept_to_the_bit(self):
        dice = random.Random(1)
        for size in (1, 40, 30000):
            places = [dice.randint(-size, size) for _ in range(500)]
            packed = player.pack(player.second_differences(places))
            self.assertEqual(list(sums(unpack(packed))), places)

    def test_even_motion_is_small(self):  # of 4 bytes a number
        fall = [round(-0.5 * 10 * (i / 60) ** 2 * 100) for i in range(1200)]
        self.assertLess(len(player.pack(player.second_differences(fall))), 1200 * 4 / 8)
        rest = player.pack(player.second_differences([1234] * 1200))
        self.assertLess(len(rest), 1200 * 4 / 100)

    def test_marks_are_where_plays_part(self):
        film = {"parted": [None, 1.5, None], "distance": 0.02, "times": 1e4,
                "plays": [{"times": [0, 10000, 30000]}]}
        marks = player.marks(film, STYLES)
        self.assertEqual(marks.count("<button"), 1)
        self.assertIn("left:50.00%;color:#111111", marks)
        self.assertIn("20 mm", player.parts(film, STYLES))
        film["parted"] = [None, None, 3]
        self.assertIn('title="far &amp; wide parts at 3.00 s"', player.marks(film, STYLES))
        self.assertIn("left:100.00%", player.marks(film, STYLES))
        film["parted"] = [None, None, None]
        self.assertEqual(player.marks(film, STYLES), "")
        self.assertIn("No point is ever more than 20 mm", player.parts(film, STYLES))

    def test_the_nearest_engine_follows_from_the_figures(self):
        def figure(values, rule="exact"):
            return {"rule": rule, "exact": 1, "results": [result(value) for value in values]}

        near = [1.5] * 6
        scene = {"plays": PLAYS, "figures": [figure([1, *near, 1 + 1e-7]), figure([9, *near, 1], "show")]}
        self.assertEqual(verdicts.nearer(scene), "")
        scene["figures"] = [figure([1.01, *near, 1.1]), figure([1.1, *near, 1]), figure([1, *near, 1.2], "kodo"),
                            figure([1.1, *near, 1.15])]
        self.assertIn("balanced in 2, Box2D 3 in 1.", verdicts.nearer(scene))

    def test_verdicts_follow_from_the_figures(self):
        results = [result(1) for _ in PLAYS]
        scene = {"plays": PLAYS, "figures": [{"rule": "kodo", "exact": 1, "results": results}]}
        self.assertEqual(verdicts.verdict(scene), ("good", "all agree"))
        results[7] = result(2, holds=False)
        self.assertEqual(verdicts.verdict(scene), ("differ", "Kodo holds; Box2D 3 differs in 1"))
        results[6] = result(2, holds=False)
        self.assertIn("Box2D 2.4.1 differs in 1, Box2D 3", verdicts.verdict(scene)[1])
        scene["figures"][0]["rule"] = "exact"
        self.assertEqual(verdicts.verdict(scene)[0], "wrong")
        scene["figures"][0]["rule"] = "kodo"
        results[5] = {"value": 7, "tolerance": None, "holds": True}
        results[6:] = [result(1), None]
        self.assertIn("not judged in all figures", verdicts.verdict(scene)[1])
        results[5] = result(7, holds=False)
        self.assertEqual(verdicts.verdict(scene), ("wrong", "does not hold"))

    def test_no_colour_is_there_twice(self):
        colours = [colour for _, colour, *_ in crosscheck.STYLES]
        self.assertEqual(len(set(colours)), 8)
        for i, one in enumerate(colours):  # and none is hard to tell from another
            for other in colours[:i]:
                apart = sum(abs(int(one[k : k + 2], 16) - int(other[k : k + 2], 16)) for k in (1, 3, 5))
                self.assertGreater(apart, 90, (one, other))

    def test_the_script_asks_no_other_host(self):
        for word in ("http:", "https:", "fetch(", "import(", "XMLHttpRequest", "//cdn"):
            self.assertNotIn(word, player.script())


if __name__ == "__main__":
    unittest.main()
