"""Tests shell completion: the scripts from placedpar completion in bash, and in zsh if it is installed."""

import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import time
import unittest

from program import PROGRAM, placedpar

FOLDER = pathlib.Path(PROGRAM).resolve().parent
ENVIRONMENT = {**os.environ, "PATH": f"{FOLDER}{os.pathsep}{os.environ['PATH']}", "TERM": "dumb"}
PARAMETERS = placedpar("parameters").stdout.splitlines()[0]


def bash(*words):
    """Returns what bash's function for placedpar offers for the last word."""
    script = ('source <(placedpar completion bash); COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _placedpar; '
              'printf "%s\\n" "${COMPREPLY[@]}"')
    done = subprocess.run(["bash", "--norc", "-c", script, "bash", "placedpar", *words], env=ENVIRONMENT, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True)
    assert not done.stderr, done.stderr
    return done.stdout.split()


def options_in_help(*command):
    return set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", placedpar(*command, "--help").stdout, re.MULTILINE))


def typed_into(shell, *lines):
    """Returns what an interactive shell shows when these lines are typed, until it ends."""
    process, terminal = pty.fork()
    if process == 0:
        os.execvpe(shell[0], shell, ENVIRONMENT)
    for line in lines:
        time.sleep(0.5) # a shell that does not read yet would take a tab for a character
        os.write(terminal, line.encode())
    shown, end = b"", time.monotonic() + 30
    while time.monotonic() < end and select.select([terminal], [], [], 10)[0]:
        try:
            part = os.read(terminal, 65536)
        except OSError: # on Linux: the shell has ended
            break
        shown += part
    os.close(terminal)
    os.waitpid(process, 0)
    return shown.decode(errors="replace")


class Completion(unittest.TestCase):
    def test_commands(self):
        listed = re.findall(r"^  (\w+) {2,}", placedpar("--help").stdout.split("Subcommands:")[1], re.MULTILINE)
        self.assertGreater(len(listed), 8)
        self.assertLessEqual(set(listed) | {"--version", "--help"}, set(bash("")))
        self.assertEqual(bash("ru"), ["run"])
        self.assertEqual(bash("re"), ["report", "replay", "record"])

    def test_options_of_every_command(self):
        for command in bash(""):
            if not command.startswith("-"):
                with self.subTest(command=command):
                    self.assertEqual(set(bash(command, "--")), options_in_help(command))

    def test_words_that_an_option_takes(self):
        self.assertEqual(bash("show", "x.cfs", "--format", ""), ["cfs", "svg", "dot", "json", "promela"])
        self.assertEqual(bash("show", "x.cfs", "--format", "=", "s"), ["svg"]) # as bash splits --format=s
        self.assertEqual(bash("show", "x.cfs", "--format", "="), ["cfs", "svg", "dot", "json", "promela"])
        self.assertEqual(bash("identify", "--way", "s"), ["service"])

    def test_an_option_and_its_value_in_one_word(self):
        for words, found in ((["show", "x.cfs", "--format=s"], ["--format=svg"]),
                             (["show", "x.cfs", "--format="], [f"--format={f}" for f in ("cfs", "svg", "dot", "json", "promela")]),
                             (["run", "x.cfs", "--json=x"], []), (["run", "x.cfs", "--nothing=x"], [])):
            done = placedpar("completion", "words", "--", *words) # as zsh asks
            self.assertEqual((done.returncode, done.stdout.split()), (0, found), words)

    def test_options_of_one_letter_are_offered_where_they_are_begun(self):
        self.assertIn("-I", bash("run", "-"))
        self.assertNotIn("-I", bash("run", "--"))
        self.assertNotIn("-h", bash(""))

    def test_names_that_a_command_takes(self):
        self.assertEqual(bash("replay", "table-e"), ["table-e1", "table-e2"])
        self.assertEqual(bash("kinds", "csp.co"), ["csp.column", "csp.consumer"])
        self.assertEqual(bash("kinds", "B403_T41"), ["B403_T414"])
        self.assertIn("excavator", bash("record", ""))
        self.assertEqual(bash("completion", "z"), ["zsh"])

    def test_files_are_left_to_the_shell(self):
        for words in (["run", ""], ["run", "mine"], ["run", "x.cfs", "--json", ""], ["fly", ""]):
            self.assertEqual(bash(*words), [])
        done = subprocess.run(["bash", "--norc", "-c", "source <(placedpar completion bash); complete -p placedpar"],
                              env=ENVIRONMENT, text=True, stdout=subprocess.PIPE, check=True)
        self.assertEqual(done.stdout, "complete -o default -F _placedpar placedpar\n")

    def test_a_tab_typed_into_bash(self):
        shown = typed_into(["bash", "--norc", "--noprofile", "-i"], "source <(placedpar completion bash)\n",
                           "placedpar param\t | head -1\n", "exit\n")
        self.assertIn("\n" + PARAMETERS, shown.replace("\r", ""))

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_a_tab_behind_an_equals_sign_in_zsh(self):
        shown = typed_into(["zsh", "-f", "-i"], "autoload -Uz compinit; compinit -D\n",
                           "source <(placedpar completion zsh)\n", "echo placedpar show x.cfs --format=s\t end\n",
                           "placedpar show x.cfs --format=s\t; echo end\n", "exit\n")
        self.assertIn("--format=svg", shown)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_a_tab_typed_into_zsh(self):
        shown = typed_into(["zsh", "-f", "-i"], "autoload -Uz compinit; compinit -D\n",
                           "source <(placedpar completion zsh)\n", "placedpar param\t | head -1\n", "exit\n")
        self.assertIn("\n" + PARAMETERS, shown.replace("\r", ""))


if __name__ == "__main__":
    unittest.main()
