"""Tests which differences from its page are allowed to a study with few seeds."""

import unittest

import document
import study

PAGE = """medians
                          simulat.  error  tolerance
window 30                   114.00      0         10
window 10                    68.00    -2%          8

claims, sigma = 1
                                   median  95 % from      to
                          simulat.  claim   simulat. simulat.
delay, window 30 less 10     69.00     40      60.00   100.00
delay: claimed at least 40: holds

fingerprint: 6a3f857e79c94a18
every judged cell of the first reading is within its tolerance""".split("\n")


def judged(printed, exit_code=0):
    command = document.Command(1, "placedpar replay pga-3", output=PAGE)
    return study.loose_failure(command, exit_code, printed)


def with_change(old, new):
    assert any(old in line for line in PAGE)
    return [line.replace(old, new) for line in PAGE]


class Study(unittest.TestCase):
    def test_other_figures_and_verdicts_will_do(self):
        self.assertEqual(judged(PAGE), "")
        self.assertEqual(judged(with_change("68.00    -2%", "57.00   -16.2%!"), 3), "")
        self.assertEqual(judged(with_change("40: holds", "40: does not hold")), "")
        self.assertEqual(judged(with_change("every judged cell of the first reading is within its tolerance",
                                            "a cell of the first reading misses its tolerance"), 3), "")
        self.assertEqual(judged(with_change("fingerprint: 6a3f857e79c94a18", "fingerprint: 0000000000000000")), "")

    def test_other_lines_are_named(self):
        self.assertIn("window #", judged([line for line in PAGE if "window 10" not in line]))
        self.assertIn("+windows # # # #", judged(with_change("window 10 ", "windows 10 ")))
        self.assertIn("nothing came", judged([*PAGE, "nothing came of it"]))

    def test_a_claim_far_from_the_page_is_named(self):
        self.assertEqual(judged(with_change("60.00   100.00", "101.00   110.00")), "")
        self.assertEqual(judged(with_change("60.00   100.00", "111.00   120.00")),
                         "delay, window 30 less 10: 111.0 to 120.0 from few seeds, 60.0 to 100.0 on the page")
        self.assertIn("1.0 to 2.0 from", judged(with_change("60.00   100.00", "1.00   2.00")))

    def test_other_exits_are_failures(self):
        self.assertIn("exit code 1", judged(["placedpar: no such experiment"], 1))
        self.assertIn("does not end", judged([], None))


if __name__ == "__main__":
    unittest.main()
