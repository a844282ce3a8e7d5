#!/usr/bin/env python3
"""How answers about published sets are judged, by hand."""
import pathlib
import sys
import tomllib
import unittest

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "trial/published"
sys.path.insert(0, str(FOLDER))
import table  # noqa: E402


def report(verdict, effects, equivalent=()):
    named = [{"id": id, "joint": joint} for id, joint in effects]
    return {"cause": {"verdict": verdict, "effects": named, "equivalent": [list(one) for one in equivalent]}}


class Judged(unittest.TestCase):
    stated = {"right": ["joint_stiffness(1)"]}

    def test_a_stated_cause_is_found_alone_in_a_class_or_in_part(self):
        own = [("joint_stiffness", 1)]
        self.assertEqual(table.judged(self.stated, report("identified", own)), "alone")
        self.assertEqual(table.judged(self.stated, report("partial", own)), "in part")
        self.assertEqual(table.judged(self.stated, report("ambiguous", [("gravity", None)], [["joint_stiffness(1)", "force_bias"]])), "in the class")

    def test_another_answer_is_wrong_where_it_is_sure_and_missed_else(self):
        self.assertEqual(table.judged(self.stated, report("identified", [("gravity", None)])), "wrong and sure")
        for verdict in ("none", "unknown"):
            self.assertEqual(table.judged(self.stated, report(verdict, [])), "missed")

    def test_a_stated_cause_outside_is_found_where_it_is_an_alternative(self):
        outside = {"right": [], "outside": True}
        self.assertEqual(table.judged(outside, report("unknown", [])), "right")
        self.assertEqual(table.judged(outside, report("ambiguous", [("gravity", None)], [["unknown"]])), "right")
        self.assertEqual(table.judged(outside, report("identified", [("gravity", None)])), "wrong and sure")

    def test_every_set_says_what_its_owners_state(self):
        for name, one in tomllib.loads((FOLDER / "sets.toml").read_text()).items():
            with self.subTest(name):
                self.assertEqual(bool(one["states"]), bool(one["right"]) or one.get("outside", False))


if __name__ == "__main__":
    unittest.main()
