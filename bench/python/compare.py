"""Compares PlacedPar's module with SimPy, DEAP and the command line, each on the same job in the same run.

    PYTHONPATH=build/release/python python3 bench/python/compare.py [--small]

Prints a line for each comparison, and exits with 3 if the module is slower than the rival. SimPy 3 is Debian's package
python3-simpy3; without it, SimPy 2 of python3-simpy is the rival.
"""

import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

import placedpar as pp

SMALL = "--small" in sys.argv
LEAST_OF_COMMAND_LINE = 0.99 if shutil.which("valgrind") else 0  # times are too coarse to judge 1 %
SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Skipped(Exception):
    """States the reason why a comparison is not made."""


def seconds(work, repeats=1 if SMALL else 5):
    """Returns the shortest time that the work takes."""
    times = []
    for _ in range(repeats):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


class Prefix(pp.Process):
    """The first process of the ring: sends a number around the ring many times."""
    inp = pp.Input(int)
    out = pp.Output(int)
    rounds = 10

    def body(self):
        for number in range(self.rounds):
            yield self.out.output(number)
            yield self.inp.input()


class Relay(pp.Process):
    inp = pp.Input(int)
    out = pp.Output(int)
    rounds = 10

    def body(self):
        for _ in range(self.rounds):
            number = yield self.inp.input()
            yield self.out.output(number + 1)


def ring_of_placedpar(processes, rounds):
    text = (f'T800 (memory = 1M) t; process p, r[{processes - 1}]; use "Prefix" for p; '
            f'rep i = 0 for {processes - 1} use "Relay" for r[i];\n'
            f'connect p.out to r[0].inp; connect r[{processes - 2}].out to p.inp; '
            f'rep i = 0 for {processes - 2} connect r[i].out to r[i + 1].inp;\n'
            f'place p on t; rep i = 0 for {processes - 1} place r[i] on t; p (rounds = {rounds}); '
            f'rep i = 0 for {processes - 1} r[i] (rounds = {rounds});')
    net = pp.load(text, kinds=[Prefix, Relay])
    return net.run


def ring_of_simpy(processes, rounds):
    """Returns the run of the ring with SimPy 3 or 4, in which each channel is a store for one message."""
    import simpy

    def first(store, following):
        for number in range(rounds):
            yield following.put(number)
            yield store.get()

    def following_one(store, following):
        for _ in range(rounds):
            number = yield store.get()
            yield following.put(number + 1)

    def run():
        environment = simpy.Environment()
        stores = [simpy.Store(environment, capacity=1) for _ in range(processes)]
        for i in range(processes):
            body = following_one if i else first
            environment.process(body(stores[i], stores[(i + 1) % processes]))
        environment.run()
    return run


def ring_of_simpy_2(processes, rounds):
    """Returns the run of the ring with SimPy 2."""
    from SimPy.Simulation import Process, Simulation, Store, get, put

    class First(Process):
        def run(self, store, following):
            for number in range(rounds):
                yield put, self, following, [number]
                yield get, self, store, 1

    class Next(Process):
        def run(self, store, following):
            for _ in range(rounds):
                yield get, self, store, 1
                yield put, self, following, [self.got[0] + 1]

    def run():
        simulation = Simulation()
        stores = [Store(sim=simulation, capacity=1) for _ in range(processes)]
        for i in range(processes):
            process = (Next if i else First)(sim=simulation)
            simulation.activate(process, process.run(stores[i], stores[(i + 1) % processes]))
        simulation.simulate(until=1)
    return run


def ring():
    """Compares messages per second around a ring; each message is an output and an input."""
    processes, rounds = 10, 200 if SMALL else 5000
    messages = processes * rounds
    try:
        rival, theirs = "SimPy 3", ring_of_simpy(processes, rounds)
        theirs()
    except ImportError:
        rival, theirs = "SimPy 2", ring_of_simpy_2(processes, rounds)
    return ("messages a second, ring of 10 processes", messages / seconds(ring_of_placedpar(processes, rounds)),
            messages / seconds(theirs), rival)


def search_of_deap(individuals, dimensions, generations):
    from deap import base, creator, tools, algorithms
    import numpy
    creator.create("Least", base.Fitness, weights=(-1.0,))
    creator.create("Vector", numpy.ndarray, fitness=creator.Least)
    toolbox = base.Toolbox()
    toolbox.register("vector", lambda: creator.Vector(numpy.random.uniform(-5, 5, dimensions)))
    toolbox.register("population", tools.initRepeat, list, toolbox.vector)
    toolbox.register("evaluate", lambda x: ((x ** 2).sum(),))
    toolbox.register("mate", tools.cxBlend, alpha=0.5)
    toolbox.register("mutate", tools.mutGaussian, mu=0, sigma=1, indpb=0.05)
    toolbox.register("select", tools.selTournament, tournsize=3)
    return lambda: algorithms.eaSimple(toolbox.population(individuals), toolbox, 0.8, 1.0, generations, verbose=False)


def search():
    """Compares generations per second of a search with a fitness in NumPy."""
    generations = 10 if SMALL else 200

    def ours():
        pp.search(lambda rows: (rows ** 2).sum(axis=1), [(-5, 5)] * 20, population=100, generations=generations,
                  coding="real", reproduction="tournament(3)", mutation_probability=0.05)
    random.seed(1)
    return ("generations a second, 100 individuals of 20 numbers", generations / seconds(ours),
            generations / seconds(search_of_deap(100, 20, generations)), "DEAP")


def instructions(command):
    """Returns the number of instructions of a command, as Valgrind counts them."""
    counted = subprocess.run(["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null",
                              *command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=True, text=True)
    return int(re.search(r"I +refs: +([0-9,]+)", counted.stderr)[1].replace(",", ""))


def user_time(command):
    """Returns the least processor time of a command over seven runs, in seconds."""
    times = []
    for _ in range(7):
        before = os.times().children_user
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
        times.append(os.times().children_user - before)
    return min(times)


def cost_of_a_run(command_of, cost):
    """Returns the cost of one run, from the difference between a command with 12 runs and a command with 2 runs."""
    few, more = 2, 10
    return max(cost(command_of(few + more)) - cost(command_of(few)), 1e-6) / more


def command_line():
    """Compares runs from Python with runs from the command line, without the start of the programs. If Valgrind is
    installed, it counts instructions, since times vary by more than the 1 % that a run from Python may cost."""
    if SMALL:
        raise Skipped("it takes minutes")
    built = pathlib.Path(pp._core.__file__).parents[2] / "app" / "placedpar"
    program = os.environ.get("PLACEDPAR") or (built if built.exists() else shutil.which("placedpar"))
    netlist = os.environ.get("PLACEDPAR_NETLIST") or SOURCE / "examples" / "thesis" / "figure-e2" / "figure-e2.cfs"
    if program is None:
        raise Skipped("the program placedpar is not beside the module: set PLACEDPAR to its path")
    in_python = "import placedpar as pp, sys\nnet = pp.load(sys.argv[1])\nfor i in range(int(sys.argv[2])): net.run(1 + i)"
    counts = shutil.which("valgrind")
    cost = instructions if counts else user_time
    ours = cost_of_a_run(lambda runs: [sys.executable, "-c", in_python, netlist, str(runs)], cost)
    theirs = cost_of_a_run(lambda runs: [program, "run", netlist, "--seeds", str(runs)], cost)
    unit, scale = ("10^9 instructions", 1e9) if counts else ("a second of a processor", 1)
    return f"runs for {unit}", scale / ours, scale / theirs, "the command line"


def main():
    missed = False
    for comparison in (ring, search, command_line):
        try:
            result = comparison()
        except (ImportError, Skipped) as missing:
            print(f"{comparison.__name__}: skipped: {missing}")
            continue
        what, ours, theirs, rival = result
        print(f"{what}: {ours:,.0f}; {rival}: {theirs:,.0f}; {ours / theirs:.2f} times as many")
        missed = missed or ours < theirs * (LEAST_OF_COMMAND_LINE if rival == "the command line" else 1)
    return 3 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
