"""Tests the service's command line options."""

import re
import subprocess
import unittest

from service import PROGRAM, ServiceTest


class Options(ServiceTest):
    def test_every_option_takes_what_its_help_says_and_no_more(self):
        shown = subprocess.run([PROGRAM, "monitor", "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
        options = re.findall(r"(--[\w-]+) (\S+?)=(\S+)\s+(?![\s-])[^\n]*, (\S+) to (\S+)\n", shown)
        self.assertEqual(len(options), 24)
        for option, unit, default, least, greatest in options:
            whole = unit in ("N", "BYTES")
            self.assertLessEqual(float(least), float(default))
            self.assertGreaterEqual(float(greatest), float(default))
            beyond = str(int(greatest) + 1) if whole else str(float(greatest) * 1.001)
            wrong = ["-1", "nan", "inf", "1e300", "99999999999999999999", "many", "1x", beyond]
            wrong += ["1.5", "010"] if whole else []
            wrong += [str(float(least) * 0.99)] if float(least) > 0 and not whole else []
            wrong += [str(int(least) - 1)] if whole and least != "0" else []
            for value in wrong:
                self.assertIn(f'{option}: "{value}" is not a {"whole " if whole else ""}number from {least} to {greatest}',
                              self.refusal(f"{option}={value}"))
        self.assertIn("--state: ", self.refusal("--state", ""))
        self.assertIn('--seed: "-1" is not a whole number', self.refusal("--seed=-1"))
        ends = [f"{option}={end}" for option, _, _, least, greatest in options for end in (least, greatest)
                if option not in ("--port", "--http", "--max-clients", "--window")]
        for least_or_greatest in (ends[::2], ends[1::2]):
            service = self.service(*least_or_greatest)
            self.assertEqual(service.stop()[0], 0)

    def test_a_folder_is_no_state_file(self):
        folder = self.folder / "known"
        folder.mkdir()
        self.assertIn(f"{folder}: this is a folder", self.refusal("--state", folder))
        self.assertEqual(list(self.folder.iterdir()), [folder])

    def test_a_state_file_in_no_folder_is_refused_by_its_name(self):
        state = self.folder / "none" / "known"
        self.assertIn(f"--state {state}: ", self.refusal("--state", state))


if __name__ == "__main__":
    unittest.main()
