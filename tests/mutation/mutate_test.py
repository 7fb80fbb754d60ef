#!/usr/bin/env python3
"""How a draw is counted, with verdicts made up: nothing is built here."""

import argparse
import pathlib
import tempfile
import unittest
from unittest import mock

import mutate
from mutate import Verdict


def draw(verdict, **changes):
    """A whole draw in which verdict(number) judges mutant after mutant."""
    arguments = argparse.Namespace(**{"seed": 1, "count": 30, "a_room": 2, "minutes": None, "jobs": 1, "programs": 12, **changes})
    numbers = iter(range(10**6))
    with tempfile.TemporaryDirectory() as folder, \
            mock.patch.object(mutate, "RESULTS", pathlib.Path(folder) / "results.json"), \
            mock.patch.object(mutate, "read_table", lambda *_: {}), \
            mock.patch.object(mutate, "judge", lambda *_: verdict(next(numbers))), mock.patch("builtins.print"):
        run = mutate.Run(arguments, mutate.Results(False), {})
        run.take_draw()
    return run


class Draw(unittest.TestCase):
    def test_every_room_has_its_share_and_the_rest_fills_up(self):
        run = draw(lambda _: Verdict("killed", "a test"))
        self.assertEqual(len(run.judged), 30)
        rooms = [mutation.room for mutation, _ in run.judged]
        self.assertTrue(all(rooms.count(room) >= 2 for room in rooms))
        self.assertGreaterEqual(len(set(rooms)), 9)
        self.assertEqual(len({(mutate.key(m), m.nth) for m, _ in run.judged}), 30)

    def test_survivors_are_counted_and_listed(self):
        run = draw(lambda number: Verdict("survived") if number < 3 else Verdict("killed", "a test"))
        self.assertEqual(len(run.survivors()), 3)
        self.assertAlmostEqual(run.share(), 0.9)
        text = mutate.report(run, [])
        self.assertIn("**27 of 30 mutants are killed (90.0 %)**", text)
        for mutation in run.survivors():
            self.assertIn(f"`{mutation.text}` → `{mutation.changed}`", text)

    def test_what_does_not_compile_is_replaced_by_another(self):
        run = draw(lambda number: Verdict("stillborn" if number % 2 else "killed"))
        self.assertEqual((len(run.judged), run.stillborn >= 25), (30, True))

    def test_a_run_that_is_stopped_says_so(self):
        run = draw(lambda _: Verdict("killed"), minutes=0)
        self.assertEqual(run.judged, [])
        self.assertIn("The run was stopped", mutate.report(run, []))


class Tables(unittest.TestCase):
    def test_tables_are_about_lines_that_exist(self):
        self.assertGreaterEqual(len(mutate.named_mutations()), 8)
        for mutation, program in mutate.named_mutations():
            self.assertIsNotNone(mutation.line_in((mutate.ROOT / mutation.path).read_text()))
            self.assertIn(program, mutate.PROGRAMS)
        self.assertEqual(mutate.stale_entries(), [])

    def test_every_room_has_a_program_of_its_own(self):
        rooms = {mutation.room for mutation in mutate.places.places(mutate.ROOT)}
        self.assertEqual([room for room in rooms if mutate.programs_for(room)[0] not in mutate.PROGRAMS], [])


if __name__ == "__main__":
    unittest.main()
