#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of the evaluation in tools/trade and tools/bench: figures_test.py PATH-OF-TOOLS/lib"""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree

sys.dont_write_bytecode = True  # no __pycache__ beside the tools
sys.path.insert(0, sys.argv.pop())
import bench  # noqa: E402
import box2d3  # noqa: E402
import chart  # noqa: E402
import measure  # noqa: E402
import dials  # noqa: E402
import trade  # noqa: E402


def result(time, error, **more):
    return {
        "label": f"{time} {error}",
        "family": "substeps",
        "scene": "stack",
        "size": 20,
        "bodies": 20,
        "steps": 600,
        "runs": 3,
        "engine": "kodo",
        "errorName": "top sinks",
        "errorUnit": "mm",
        "cpuMsPerStep": time,
        "error": error,
        "lost": error >= 1e4,
        **more,
    }


class Fronts(unittest.TestCase):
    def test_the_front_has_no_beaten_result(self):
        fast, good, true = result(1, 100), result(2, 10), result(8, 1)
        beaten = [result(1.5, 200), result(2.1, 10), result(9, 1), result(4, 9.95)]
        self.assertEqual(trade.front_of([true, *beaten, fast, good]), [fast, good, true])

    def test_an_error_of_zero_equals_rounding(self):
        self.assertEqual(len(trade.front_of([result(1, 1e-4), result(2, 0)])), 1)

    def test_a_lost_scene_is_on_no_front(self):
        held = result(5, 10)
        self.assertEqual(trade.front_of([result(1, 2e4), held]), [held])
        self.assertEqual(trade.front_of([result(1, 2e4)]), [])
        self.assertIsNone(trade.knee_of([]))

    # On a straight line between the ends in log-log scale, the point at time 2 would have an error
    # of 31.6.
    def test_the_knee_lies_farthest_below_the_line_between_the_ends(self):
        front = [result(1, 1000), result(1.5, 100), result(2, 2), result(4, 1)]
        self.assertIs(trade.knee_of(front), front[2])

    def test_the_verdict_names_a_setting_that_beats_the_default(self):
        question = trade.QUESTIONS[0]
        default = result(2, 10, label="balanced")
        self.assertIn("nothing", trade.verdict_of(question, [default, result(1, 11)]))
        self.assertIn("0.50 of the time", trade.verdict_of(question, [default, result(1, 9)]))
        lost = result(2, 2e4, label="balanced")
        self.assertIn("lost", trade.verdict_of(question, [lost, result(1, 9)]))

    def test_a_setting_within_the_noise_of_the_front_is_not_beaten(self):
        self.assertFalse(trade.is_beaten(result(1.02, 1), [result(1, 0.5)]))
        self.assertFalse(trade.is_beaten(result(2, 1), [result(1, 0.99)]))
        self.assertTrue(trade.is_beaten(result(2, 1), [result(1, 0.5)]))


class Summaries(unittest.TestCase):
    def test_they_take_the_median_time(self):
        runs = [result(time, 1, stateHash="a", bodies=2) for time in (3, 1, 2)]
        summary = measure.summary_of(runs)
        self.assertEqual(summary["cpuMsPerStep"], 2)
        self.assertEqual(summary["spread"], 1)
        self.assertEqual(summary["nsPerBodyStep"], 1e6)

    def test_a_different_state_hash_aborts(self):
        with self.assertRaises(SystemExit):
            measure.summary_of([result(1, 1, stateHash=name) for name in "ab"])


class Options(unittest.TestCase):
    def printed(self, *words):
        """Returns the error message and the exit code for invalid options."""
        output = io.StringIO()
        with contextlib.redirect_stderr(output), unittest.mock.patch("sys.argv", ["", *words]):
            with self.assertRaises(SystemExit) as stopped:
                bench.options()
        return output.getvalue(), stopped.exception.code

    def test_invalid_options_are_refused_in_one_line_before_the_build(self):
        for words in (["--repeat", "0"], ["--repeat", "1.5"], ["--profiles", "nonesuch"],
                      ["--scenes", "nowhere"], ["--box2d3", "nowhere"], ["--check"]):
            output, code = self.printed(*words)
            self.assertEqual(code, 2)
            self.assertIn(words[-1], output)
            self.assertTrue(output.startswith("tools/bench: ") and output.count("\n") == 1, output)
        self.assertEqual(self.printed("--repeat", "3", "--check-options"), ("", 0))


class BesideBox2d3(unittest.TestCase):
    def errors(self, name, *errors):
        """A run that gives Kodo the first error, and Box2D 3 the others by number of substeps."""
        by_substeps = dict(zip(box2d3.SUBSTEPS, errors[1:]))

        def run(words):
            substeps = words[words.index("--substeps") + 1] if "--substeps" in words else None
            return {"errorName": name, "error": by_substeps.get(substeps, errors[0])}

        return run

    def test_equal_error_takes_the_least_number_of_substeps(self):
        for errors, wanted in (((1, 5, 1.05, 0.2, 0.1, 0), (8, True)),
                               ((9, 5, 1, 0.2, 0.1, 0), (4, True)),
                               ((0.01, 5, 1, 0.2, 0.1, 0.02), (64, False))):
            for name in box2d3.ERRORS:
                self.assertEqual(box2d3.equal_error([], self.errors(name, *errors)), wanted)
        self.assertIsNone(box2d3.equal_error([], self.errors("top sinks", 9, 1, 1, 1, 1, 1)))

    def test_contacts_and_joints_are_as_stiff_as_the_substeps_allow(self):
        self.assertEqual(box2d3.way_of(8)[-1], "contactHertz=60,jointHertz=120")

    def test_a_row_says_that_no_number_of_substeps_suffices(self):
        more = {"depthMeanMm": 2, "escaped": None, "spread": 0.1, "worstStepMs": None}
        group = [result(1, 3, **more), result(2, 60, **more), result(4, 30, **more)]
        for reached, cell in ((True, "| 0.250 (64) |"), (False, "| 0.250 (64, not equal: 30.0 mm) |")):
            row = box2d3.row_of(bench.Wanted("chains", 10), group, box2d3.Equal(64, reached))
            self.assertIn(cell, row)
            self.assertIn("| 0.500 |", row)

    def test_a_row_has_the_ratio_of_both_engines(self):
        more = {"depthMeanMm": 2, "escaped": None, "spread": 0.1, "worstStepMs": None}
        ours = result(1, 3, **more | {"worstStepMs": 4})
        theirs = result(2, 6, **more | {"worstStepMs": 2})
        row = box2d3.row_of(bench.Wanted("stack", 20), [ours, theirs], None)
        self.assertIn("| 1.00 / 2.00 | 0.500 |", row)
        self.assertIn("| 4.00 / 2.00 | 2.00 |", row)
        self.assertEqual(row.count("|"), box2d3.HEAD.splitlines()[0].count("|"))


class Figures(unittest.TestCase):
    def test_numbers_keep_three_significant_digits(self):
        texts = [measure.number(value) for value in (12345.6, 1.0, 0.0123456, 0, None)]
        self.assertEqual(texts, ["12,346", "1.00", "0.0123", "0", ""])

    def test_a_log_scale_maps_its_ends_and_its_middle(self):
        scale = chart.LogScale(1, 100, 0, 200)
        self.assertEqual([round(scale(value), 9) for value in (1, 10, 100)], [0, 100, 200])
        self.assertEqual(scale.ticks(), [1, 2, 5, 10, 20, 50, 100])

    def test_the_allowed_growth_is_n_log_n(self):
        first = {"bodies": 1000, "nsPerBodyStep": 300}
        self.assertAlmostEqual(bench.allowed(first, {"bodies": 1_000_000}), 600)

    def test_the_default_profile_has_no_name_in_the_table(self):
        for profile, engine, way in (("balanced", "kodo", "kodo"), ("fast", "kodo64", "kodo64 fast"),
                                     (None, "box2d", "box2d")):
            self.assertEqual(bench.way_of({"engine": engine, "profile": profile}), way)

    def test_missed_targets_are_named(self):
        wanted = bench.Wanted("stack", 20, ratio=0.2, error=50, stands=True)
        good = result(1, 50, ratio=0.2, depthMeanMm=99, escaped=None, stood=20)
        self.assertEqual(bench.missed(wanted, good), "")
        bad = result(1, 51, ratio=0.21, depthMeanMm=99, escaped=2, stood=19)
        self.assertEqual(
            bench.missed(wanted, bad),
            "ratio at most 0.2, error at most 50, escaped at most 0, all stand",
        )

    def test_labels_cover_neither_marks_nor_each_other(self):
        page = chart.Page(400, 300, "")
        places = [(200 + 9 * (i % 5), 150 + 7 * (i // 5)) for i in range(20)]
        for place in places:
            page.mark(*place, chart.INK)
        for i, place in enumerate(places):
            page.label(*place, f"label {i}")
        labels = page.taken[len(places) :]
        self.assertGreater(len(labels), 10)
        for i, one in enumerate(labels):
            for other in page.taken[: len(places) + i]:
                apart = one[2] < other[0] or other[2] < one[0]
                self.assertTrue(apart or one[3] < other[1] or other[3] < one[1])

    def test_a_page_with_markup_characters_is_well_formed(self):
        front = [result(1, 1000), result(2, 2), result(4, 1, label="<&>")]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "figure.svg"
            trade.draw(front, front, front[1], path)
            texts = [node.text for node in xml.etree.ElementTree.parse(path).iter()]
        self.assertIn("<&>", texts)
        self.assertIn("top sinks (mm)", texts)


class Pictures(unittest.TestCase):
    def test_no_colour_is_there_twice(self):
        dial_lines = [*dials.KINDS, dials.SHOCK]
        for colours in ([family.colour for family in trade.FAMILIES.values()],
                        [colour for _, colour, *_ in dial_lines],
                        [kind[1] for kind in (*dials.KINDS, *((0, c) for c in dials.SHOCKS.values()))]):
            self.assertEqual(len(set(colours)), len(colours), colours)

    def test_gains_lie_above_losses(self):
        axis = dials.SignedAxis([1e-7, 0.5, -3], 200, 0)
        self.assertEqual(axis.high, 10)
        self.assertEqual(axis(0), 100)
        self.assertEqual(axis(1e-7), 100)  # too small to tell
        self.assertLess(axis(0.5), 100)
        self.assertGreater(axis(-3), axis(-0.5))
        self.assertAlmostEqual(axis(0.5) + axis(-0.5), 200)
        self.assertEqual(axis(-1e9), 200)
        self.assertEqual([round(axis(tick)) for tick in axis.ticks()], [200, 167, 133, 100, 67, 33, 0])

    def test_a_panel_tells_gain_from_loss(self):
        line = dials.Line("one", "#123456", "", [(0, 1e-3), (1, -1e-3), (2, None)])
        signed = dials.panel("title", "time", "change", [line], (False, dials.SIGNED))
        self.assertIn(">gain<", signed)
        self.assertIn(">loss<", signed)
        self.assertNotIn(">gain<", dials.panel("title", "time", "change", [line]))


if __name__ == "__main__":
    unittest.main()
