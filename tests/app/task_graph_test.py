"""Tests graphs of tasks: the simulated times are those of an independent longest path, or make a list schedule."""

import json
import os
import random
import tempfile
import unittest

from program import EXAMPLES, placedpar

CLOCK_MHZ = 20


def random_graph(random_source, tasks, most_degree):
    """Returns the edges (from, to, bytes) of a connected graph without circles, and the cycles of its tasks."""
    degree, edges = [0] * tasks, []
    for to in range(1, tasks):
        free = [source for source in range(to) if degree[source] < most_degree]
        for source in random_source.sample(free, min(len(free), 2)):
            edges.append((source, to, random_source.randrange(1, 20000)))
            degree[source] += 1
            degree[to] += 1
    return edges, [random_source.randrange(1000, 400000) for _ in range(tasks)]


def table(edges, cycles, processors=None):
    """Returns the graph as comma-separated values."""
    lines = ["task,cycles,successors" + (",processor" if processors else "")]
    for task, each in enumerate(cycles):
        successors = " ".join(f"t{to}:{size}" for source, to, size in edges if source == task)
        lines.append(f"t{task},{each},{successors}" + (f",{processors[task]}" if processors else ""))
    return "\n".join(lines) + "\n"


def longest_path(edges, cycles, message_ms):
    """Returns when the last task is done if each task has its own processor and each message its own wire."""
    done = [0.0] * len(cycles)
    for task, each in enumerate(cycles):
        ready = max((done[source] + message_ms(size) for source, to, size in edges if to == task), default=0.0)
        done[task] = ready + each / CLOCK_MHZ / 1000
    return max(done)


class TaskGraph(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def file(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as out:
            out.write(text)
        return self.path(name)

    def generated(self, machine, tasks, *, high=False):
        netlist = placedpar("generate", *machine, "--job", self.file("tasks.csv", tasks))
        self.assertEqual((netlist.returncode, netlist.stderr), (0, ""))
        text = netlist.stdout.replace("process task_", "process (priority = HIGH) task_") if high else netlist.stdout
        return self.file("machine.cfs", text)

    def done_by_task(self, netlist):
        run = placedpar("run", netlist, "--json", self.path("run.json"))
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        with open(self.path("run.json"), encoding="utf-8") as report:
            return {each["process"]: each["value"] for each in json.load(report)["measurements"] if each["name"] == "done"}

    def times(self, netlist):
        """Returns when each task of table() is done, in ms."""
        done = self.done_by_task(netlist)
        return [done[f"task_t{task}"] for task in range(len(done))]

    def done(self, netlist):
        return max(self.done_by_task(netlist).values())

    def on_own_processors(self, edges, cycles):
        """Each task has a processor, and each edge a wire: the graph of tasks is the graph of the machine."""
        wires = "\n".join(f"t{source} -- t{to};" for source, to, _ in edges)
        nodes = "\n".join(f"t{task};" for task in range(len(cycles)))
        machine = self.file("machine.dot", f"graph {{ {nodes}\n{wires} }}")
        return self.generated([machine], table(edges, cycles))

    def test_random_graphs_take_as_long_as_their_longest_path(self):
        def one_message(size):
            return self.done(self.on_own_processors([(0, 1, size)], [20000, 20000])) - 2
        short, long = one_message(1), one_message(20000)
        for seed in range(6):
            source = random.Random(seed)
            edges, cycles = random_graph(source, source.randrange(8, 30), 4)
            expected = longest_path(edges, cycles, lambda size: short + (long - short) * (size - 1) / 19999)
            self.assertAlmostEqual(self.done(self.on_own_processors(edges, cycles)) / expected, 1, delta=0.005, msg=f"seed {seed}")

    def test_random_graphs_on_few_processors_run_as_a_list_schedule(self):
        """A processor computes one task at a time, and none before its predecessors."""
        for seed in range(6):
            source = random.Random(seed)
            edges, cycles = random_graph(source, 24, 4)
            edges = [(a, b, 1) for a, b, _ in edges]
            processors = [source.randrange(3) for _ in cycles]
            done = self.times(self.generated(["ring", "--size", "3"], table(edges, cycles, processors), high=True))
            begun = [end - each / CLOCK_MHZ / 1000 for end, each in zip(done, cycles)]
            for task, start in enumerate(begun):
                self.assertGreaterEqual(start, max((done[a] for a, b, _ in edges if b == task), default=0), (seed, task))
                for other in range(task):
                    if processors[other] == processors[task]:
                        self.assertTrue(done[other] <= start or done[task] <= begun[other], (seed, task, other))

    def test_one_processor_takes_as_long_as_all_tasks(self):
        edges, cycles = random_graph(random.Random(7), 24, 4)
        edges = [(a, b, 1) for a, b, _ in edges]
        one = self.generated(["ring", "--size", "3"], table(edges, cycles, [0] * len(cycles)), high=True)
        self.assertAlmostEqual(max(self.times(one)) / (sum(cycles) / CLOCK_MHZ / 1000), 1, delta=0.005)

    def test_the_critical_path_is_that_of_the_graph(self):
        edges = [(0, 1, 4), (0, 2, 4), (1, 3, 4), (2, 3, 4)]
        netlist = self.on_own_processors(edges, [10000, 900000, 20000, 30000])
        run = placedpar("explain", netlist, "--no-what-if")
        self.assertEqual(run.returncode, 0)
        path = run.stdout[run.stdout.index("critical path"):run.stdout.index("sum, which equals")]
        for task in ("task_t0", "task_t1", "task_t3"):
            self.assertIn(f"computing: {task} on", path)
        self.assertNotIn("task_t2", path)

    def test_the_example_runs(self):
        netlist = placedpar("generate", "ring", "--size", "4", "--job", EXAMPLES / "explore/task-graph/tasks.csv")
        self.assertEqual(netlist.returncode, 0)
        self.assertGreater(self.done(self.file("m.cfs", netlist.stdout)), 0)

    def test_wrong_tables_are_refused_with_their_place(self):
        for text, message in (("task,cycles\na,1\n", 'the table has no column "successors"'),
                              ("task,cycles,successors\na,1,b:3\n", 'unknown task "b"'),
                              ("task,cycles,successors\na,1,b\nb,1,\n", '"b" does not state a number of bytes'),
                              ("task,cycles,successors\na,x,\n", '"x" is not a number of cycles'),
                              ("task,cycles,successors\na,1,\na,1,\n", 'the task "a" is listed twice'),
                              ("task,cycles,successors\na b,1,\n", '"a b" cannot be the name of a task'),
                              ("task,cycles,successors\na,1,b:4\nb,1,a:4\n", "circle of tasks"),
                              ("task,cycles,successors,processor\na,1,,4\n", '"4" is not a processor of this machine'),
                              ("task;cycles;successors\na;1;\n", "separated by semicolons"), ("", "expected a header")):
            run = placedpar("generate", "ring", "--size", "4", "--job", self.file("bad.csv", text))
            self.assertEqual((run.returncode, run.stdout), (1, ""), text)
            self.assertIn(message, run.stderr)
            self.assertIn("bad.csv:", run.stderr)

    def test_many_unknown_successors_are_refused_at_once(self):
        tasks = "task,cycles,successors\n" + "".join(f"a{i},1,b{i}:4\n" for i in range(50000))
        run = placedpar("generate", "ring", "--size", "4", "--job", self.file("bad.csv", tasks))
        self.assertEqual((run.returncode, run.stderr.count("error: unknown task")), (1, 20))

    def test_lengths_that_do_not_fit_the_successors_are_refused(self):
        netlist = self.file("bad.cfs", 'T800 a; process p; use "csp.task" for p; p (bytes = "3"); place p on a;')
        self.assertIn('"p" has 0 successors, but "bytes" has 1 length', placedpar("check", netlist).stderr)


if __name__ == "__main__":
    unittest.main()
