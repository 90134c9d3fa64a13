"""Tests placedpar generate: its netlists are read, checked, drawn and run; refusals end with exit code 1."""

import os
import re
import resource
import tempfile
import unittest

from program import EXAMPLES, FIGURE_E2, placedpar

ASKED = ("pipeline --size 4", "ring --size 5", "tree --size 7", "mesh --size 2x3", "torus --size 2x4", "hypercube --size 8",
         "cube-connected-cycles --size 24", "star --size 5", "chordal-ring --size 8", "figure-e2 --size 2x2", "mesh --size 2x3x4",
         "mesh --size 1x1x2")


def end_of(run):
    """Returns when a run ended."""
    return re.search(r"completed at (.*)", run.stdout).group(1)


class Generate(unittest.TestCase):
    def generated(self, folder, words):
        path = os.path.join(folder, "generated.cfs")
        run = placedpar("generate", *words.split(), "-o", path)
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""), words)
        return path

    def test_every_topology_is_checked_drawn_and_run(self):
        with tempfile.TemporaryDirectory() as folder:
            for words in ASKED:
                path = self.generated(folder, words)
                for command in (["check"], ["show", "--format", "svg"], ["run", "--set", "samples=5"]):
                    run = placedpar(*command, path)
                    self.assertEqual((run.returncode, run.stderr), (0, ""), words)

    def test_a_mesh_of_three_dimensions_has_its_known_wires_and_diameter(self):
        for size, heading in (("2x3x4", "48 processors, 70 links between them, at most 4 at one processor, diameter 9"),
                              ("1x1x2", "4 processors, 3 links between them, at most 2 at one processor, diameter 3")):
            self.assertIn(heading, placedpar("generate", "mesh", "--size", size).stdout)

    def test_a_problem_is_searched_by_every_job(self):
        with tempfile.TemporaryDirectory() as folder:
            for machine in ("ring --size 4 --job islands", "ring --size 4 --job farm", "figure-e2 --size 2x2"):
                for problem in ("ackley(dimensions=3)", "plant", "tour-circle(5)"):
                    path = self.generated(folder, f"{machine} --problem {problem}")
                    run = placedpar("run", path)
                    self.assertEqual((run.returncode, run.stderr), (0, ""), (machine, problem))
                    if problem.startswith("tour"):
                        self.assertRegex(run.stdout, r"best_objective +5.87785\n")  # a regular pentagon
                        self.assertRegex(run.stdout, r"best_string +[0-4]( [0-4]){4}\n")
                    if machine.endswith("islands") and problem != "plant":
                        self.assertRegex(run.stdout, r"best of all: \S+, first found by island\[\d\] in generation \d+\n")

    def test_a_problem_with_several_objectives_is_refused(self):
        run = placedpar("run", EXAMPLES / "genetic/islands/islands.cfs", "--set", "problem=zdt1")
        self.assertEqual(run.returncode, 1)
        self.assertIn('"zdt1" has 2 objectives, but a process can search with only one', run.stderr)

    def test_ready_islands_search_for_another_problem(self):
        run = placedpar("run", EXAMPLES / "genetic/islands/islands.cfs", "--set", "problem=ackley")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr.count("have no effect: "), 1)
        self.assertRegex(run.stdout, r"best of all: \S+, first found by island\[\d\] in generation \d+\n")

    def test_figure_e2_is_the_machine_of_the_thesis(self):
        with tempfile.TemporaryDirectory() as folder:
            run = placedpar("run", self.generated(folder, "figure-e2 --size 4x4"))
            self.assertEqual(end_of(run), end_of(placedpar("run", FIGURE_E2)))

    def test_a_size_at_the_stated_limit_is_generated_and_one_above_is_refused(self):
        at_most = (("tree", "4096", "4097"), ("mesh", "64x64", "64x65"), ("cube-connected-cycles", "2048", "4608"),
                   ("star", "5", "6"), ("chordal-ring", "4096", "4098"), ("figure-e2", "64x64", "65x64"), ("hypercube", "16", "32"),
                   ("torus", "64x64", "64x65"))
        with tempfile.TemporaryDirectory() as folder:
            for topology, most, above in at_most:
                self.generated(folder, f"{topology} --size {most} --host node")
                for host in ("node", "workstation"):
                    self.assertEqual(placedpar("generate", topology, "--size", above, "--host", host).returncode, 1)

    def test_channels_that_pass_too_many_processors_are_refused_in_words(self):
        for host in ("node", "workstation"):
            run = placedpar("generate", "ring", "--size", "2048", "--host", host)
            self.assertEqual(run.returncode, 1)
            self.assertIn("ring of size 2048: its channels pass through too many processors", run.stderr)

    def test_a_refusal_ends_with_1_and_writes_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "refused.cfs")
            for words in ("torus --size 4x4", "ring --size 0", "hypercube --size 12", "moebius --size 8", "ring --size -3",
                          "tree --size 9 --branches 4", "mesh --size 4", "ring", "ring --size 8 --job nobody", "ring --size 8 --host sun",
                          "ring --size 8 --problem rastrign", "torus --size 2x2x2",
                          "ring --size 4 --job csp.identity --output out --input in --problem sphere",
                          "ring --size 4 --output out", "ring --size 4 --job farm --input in"):
                run = placedpar("generate", *words.split(), "-o", path)
                self.assertEqual((run.returncode, run.stdout), (1, ""), words)
                self.assertTrue(run.stderr.startswith("placedpar: ") or run.stderr.startswith("--"), run.stderr)
                self.assertFalse(os.path.exists(path), words)

    def test_names_of_files_stand_in_the_comment_so_that_the_command_can_be_repeated(self):
        with tempfile.TemporaryDirectory() as folder:
            def generated(tasks, *options):
                path = os.path.join(folder, tasks)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as file:
                    file.write("task,cycles,successors\na,1,\n")
                return placedpar("generate", "ring", "--size", "3", "--job", tasks, *options, folder=folder)
            run = generated("my 'tasks'.csv")
            self.assertIn("""generate ring --size 3 --job 'my '\\''tasks'\\''.csv' */""", run.stdout)
            for tasks in ("all*/tasks.csv", "tasks\x07.csv"):
                run = generated(tasks)
                self.assertEqual((run.returncode, run.stdout), (1, ""), tasks)
                self.assertIn("are written in a comment of the netlist", run.stderr)
            run = generated("tasks.csv", "--problem", "ackley")
            self.assertEqual((run.returncode, run.stdout), (1, ""))
            self.assertIn("--problem ackley has no effect on the tasks of tasks.csv", run.stderr)

    def test_the_time_for_a_check_grows_with_the_ways_to_the_host(self):
        """The larger machine has four times the islands and routes, and its routes have twice the length. Its check
        takes about seven times the time; if each route needed a search of all processors, it would take twelve times."""
        with tempfile.TemporaryDirectory() as folder:
            def seconds(path):
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                self.assertEqual(placedpar("check", path).returncode, 0)
                return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
            def least(size, tries):
                path = self.generated(folder, f"torus --size {size}x{size} --host node")
                return min(seconds(path) for _ in range(tries))
            small, middle, large = least(16, 5), least(32, 4), least(64, 3)
        self.assertLess(middle, 9 * max(small, 0.01))
        self.assertLess(large, 10 * middle)


if __name__ == "__main__":
    unittest.main()
