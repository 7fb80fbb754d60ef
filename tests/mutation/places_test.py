#!/usr/bin/env python3
"""Which places of a source are found, and what becomes of them."""

import unittest

import places


def changes(source):
    return [(m.before, m.after) for m in places.places_in("core/spanline/math/a.hpp", source)]


class Places(unittest.TestCase):
    def test_comparisons_move_their_bound(self):
        self.assertEqual(changes("if (a < b && c >= d || e == f) g();\n"), [("<", "<="), (">=", ">"), ("==", "!=")])

    def test_template_arguments_and_arrows_are_no_comparisons(self):
        self.assertEqual(changes("template <class T>\nFixed<T> f(std::span<T> a) { return a->b; }\n"), [])

    def test_constants_are_off_by_one_and_keep_their_form(self):
        self.assertIn(changes("a = 0x1fu;\n"), [[("0x1fu", "0x20u")], [("0x1fu", "0x1eu")]])
        self.assertIn(changes("a = 1'000;\n"), [[("1'000", "1001")], [("1'000", "999")]])
        self.assertEqual(changes("a = 0;\n"), [("0", "1")])

    def test_names_and_real_numbers_are_no_constants(self):
        self.assertEqual(changes("double b = a1 + 0.5;\n"), [])

    def test_shifts_go_one_bit_further(self):
        self.assertEqual(changes("a = b << c;\n"), [("<<", "<< 1 <<")])
        self.assertEqual(changes("a >>= c;\n"), [(">>=", ">>= 1 +")])

    def test_comments_texts_and_assertions_are_left_alone(self):
        self.assertEqual(changes('// a < 1\nf("a < 1");  // 2\nstatic_assert(1 < 2);\n#if A == 1\n#endif\n'), [])

    def test_code_for_other_cores_is_left_alone(self):
        source = "#if defined(__ARM_ARCH_6M__)\na = 5;\n#elif defined(__ARM_FEATURE_DSP)\nb = 5;\n#else\nc = 0;\n#endif\n"
        self.assertEqual(changes(source), [("0", "1")])
        self.assertEqual(changes("#if !defined(__ARM_ARCH_6M__) && !defined(__thumb2__)\na = 0;\n#else\nb = 0;\n#endif\n"),
                         [("0", "1")])

    def test_a_mutation_finds_its_line_again_after_others_have_moved(self):
        source = "a = 0;\nb();\na = 0;\n"
        second = places.places_in("core/spanline/math/a.hpp", source)[1]
        self.assertEqual(second.applied_to("c();\n" + source), "c();\na = 0;\nb();\na = 1;\n")
        self.assertIsNone(second.line_in("a = 0;\n"))

    def test_a_mutation_outlives_the_comment_behind_its_line(self):
        found, = places.places_in("core/spanline/math/a.hpp", "a = 0;  // as before\n")
        self.assertEqual(found.text, "a = 0;")
        self.assertEqual(found.applied_to("a = 0;  // 0 is nothing\n"), "a = 1;  // 0 is nothing\n")

    def test_the_draw_depends_on_the_seed_alone(self):
        found = places.places_in("core/spanline/math/a.hpp", "a = b < c;\nd = e < f;\ng = h < i;\n")
        forth, back = (places.in_order(listed, 5, 2) for listed in (found, found[::-1]))
        self.assertEqual(forth, back)
        self.assertEqual(places.in_order(found, 5, 4)[0], {}, "too few for the room")


if __name__ == "__main__":
    unittest.main()
