"""Compares PlacedPar's module with SimPy and DEAP, each on the same job in the same run.

    PYTHONPATH=build/release/python python3 bench/python/compare.py [--small]

Prints a line for each comparison, and exits with 3 if PlacedPar is slower than the rival.
"""

import subprocess
import os
import random
import sys
import time

import placedpar as pp

SMALL = "--small" in sys.argv


def seconds(work, repeats=1 if SMALL else 5):
    """Returns the shortest time that the work takes."""
    times = []
    for _ in range(repeats):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


class Prefix(pp.Process):
    """The first process of the ring: sends a number around it again and again."""
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
    """The same with SimPy 2, which Debian has: a store for one message stands for each channel."""
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
    """Messages a second around a ring: each message is an output and an input."""
    processes, rounds = 10, 200 if SMALL else 5000
    messages = processes * rounds
    return ("messages a second, ring of 10 processes", messages / seconds(ring_of_placedpar(processes, rounds)),
            messages / seconds(ring_of_simpy(processes, rounds)), "SimPy")


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
    """Generations a second of a search with a fitness in NumPy."""
    generations = 10 if SMALL else 200

    def ours():
        pp.search(lambda rows: (rows ** 2).sum(axis=1), [(-5, 5)] * 20, population=100, generations=generations,
                  coding="real", reproduction="tournament(3)", mutation_probability=0.05)
    random.seed(1)
    return ("generations a second, 100 individuals of 20 numbers", generations / seconds(ours),
            generations / seconds(search_of_deap(100, 20, generations)), "DEAP")


def command_line():
    """Runs a second of a netlist from Python, and by the command line without the start of its process."""
    program, netlist = os.environ.get("PLACEDPAR"), os.environ.get("PLACEDPAR_NETLIST")
    if not program or not netlist:
        return None
    net = pp.load(netlist)
    settings = [program, "run", netlist]
    start = seconds(lambda: subprocess.run([program, "--version"], stdout=subprocess.DEVNULL, check=True))
    whole = seconds(lambda: subprocess.run(settings, stdout=subprocess.DEVNULL, check=True))
    return "runs a second", 1 / seconds(net.run), 1 / (whole - start), "the command line"


def main():
    missed = False
    for comparison in (ring, search, command_line):
        try:
            result = comparison()
        except ImportError as missing:
            print(f"{comparison.__name__}: skipped: {missing}")
            continue
        if result is None:
            continue
        what, ours, theirs, rival = result
        print(f"{what}: {ours:,.0f}; {rival}: {theirs:,.0f}; {ours / theirs:.2f} times")
        missed = missed or (ours < theirs and rival != "the command line")
    return 3 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
