#!/usr/bin/env python3
"""The benchmark's check can fail: at every figure that it is there to refuse."""

import unittest

import bench
import compare
from machine import Failure

LINE = "bench S1 zbuffer 16 0 {} 0123abcd 4096\n"
NAME = "S1 zbuffer 16 0"


def faults(instructions, budgets):
    return list(bench.beside_budget(bench.rows_of("m4", LINE.format(instructions)), budgets))


class Budgets(unittest.TestCase):
    def test_a_case_at_its_budget_passes(self):
        self.assertEqual(faults(1000, {"m4": {NAME: 1000}}), [])

    def test_a_case_above_its_budget_fails(self):
        self.assertIn("budget 1000", *faults(1001, {"m4": {NAME: 1000}}))

    def test_a_frame_of_one_instruction_fails(self):
        self.assertIn("less than 90%", *faults(1, {"m4": {NAME: 1000}}))

    def test_a_case_just_above_the_floor_passes_and_one_below_fails(self):
        self.assertEqual(faults(900, {"m4": {NAME: 1000}}), [])
        self.assertEqual(len(faults(899, {"m4": {NAME: 1000}})), 1)

    def test_a_case_without_a_budget_fails(self):
        self.assertIn("has no budget", *faults(1000, {"m4": {}}))
        self.assertIn("has no budget", *faults(1000, {}))

    def test_a_budget_without_a_case_fails(self):
        self.assertIn("was not measured", *faults(1000, {"m4": {NAME: 1000, "S2 zbuffer 16 0": 1}}))

    def test_budgets_of_cores_that_were_not_asked_for_stay_out(self):
        rows = bench.rows_of("m4", LINE.format(1000))
        budgets = {"m4": {NAME: 1000}, "m3": {NAME: 1000}}
        self.assertEqual(list(bench.beside_budget(rows, budgets, ["m4"])), [])
        self.assertIn("m3", *bench.beside_budget(rows, budgets, ["m3", "m4"]))


class Console(unittest.TestCase):
    def test_a_full_pool_fails(self):
        with self.assertRaisesRegex(Failure, "a pool is full"):
            bench.rows_of("m4", "bench: a pool is full\n" + LINE.format(1000))

    def test_a_line_that_is_no_figure_fails(self):
        with self.assertRaisesRegex(Failure, "not drawn"):
            bench.rows_of("m4", LINE.format(1000) + "bench: not drawn\n")

    def test_no_figures_fail(self):
        with self.assertRaisesRegex(Failure, "no figures"):
            bench.rows_of("m4", "")


class Pictures(unittest.TestCase):
    def test_a_core_with_another_picture_fails(self):
        rows = bench.rows_of("m3", LINE.format(1000)) + bench.rows_of("m4", LINE.format(1000).replace("0123", "0124"))
        self.assertEqual(len(bench.pictures_differ(rows)), 1)


class Lecture(unittest.TestCase):
    """Lecture 003's table beside ours."""

    @staticmethod
    def table(*algorithms):
        console = "".join(f"bench {scene} {name} {depth} 16 {count} 0123abcd 4096\n" for name, depth, counts in algorithms
                          for scene, count in zip(compare.SHRINKING, counts))
        rows = bench.rows_of("m4", console + LINE.format(1000))
        return {line.split()[0]: line.split()[1:] for line in compare.lecture_table("m4", rows)}

    def test_ours_are_multiples_of_depth_sort(self):
        table = self.table(("zbuffer", 16, (3000000, 4000000, 5000000)), ("depth-sort", 24, (2000000, 6000000, 90000000)))
        self.assertEqual(table["depth-sort"], ["2.000", "6.000", "90.000", "1.0", "3.0", "45.0", "1", "10", "507"])
        self.assertEqual(table["zbuffer"], ["3.000", "4.000", "5.000", "1.5", "2.0", "2.5", "54", "54", "54"])

    def test_without_depth_sort_they_are_multiples_of_span(self):
        table = self.table(("zbuffer", 16, (3000000, 4000000, 5000000)), ("span", 24, (1000000, 2000000, 3000000)))
        self.assertEqual(table["zbuffer"][3:6], ["3.0", "4.0", "5.0"])
        self.assertIn("span", table["lecture"])

    def test_what_one_side_lacks_is_a_dash(self):
        table = self.table(("scanline-z", 16, (3000000, 4000000, 5000000)), ("span", 24, (1000000, 2000000)))
        self.assertEqual(table["scanline-z"][6:], ["-", "-", "-"])
        self.assertEqual(table["warnock"], 6 * ["-"] + ["11", "64", "307"])
        self.assertEqual(table["span"], ["1.000", "2.000", "-", "1.0", "2.0", "-", "5", "21", "100"])

    def test_a_core_without_its_scenes_has_no_table(self):
        self.assertEqual(compare.lecture_table("m3", bench.rows_of("m4", LINE.format(1000))), [])


if __name__ == "__main__":
    unittest.main()
