"""usage: rival_deap.py GENERATIONS

Runs a genetic algorithm of DEAP on Rastrigin's function of 20 numbers: 200 individuals, evaluated by two processes of
multiprocessing. Prints the seconds and the best value.
"""

import math
import multiprocessing
import random
import sys
import time

from deap import algorithms, base, creator, tools

creator.create("Least", base.Fitness, weights=(-1.0,))
creator.create("Individual", list, fitness=creator.Least)


def rastrigin(x):
    return (sum(10 + each * each - 10 * math.cos(2 * math.pi * each) for each in x),)


def main():
    random.seed(1)
    toolbox = base.Toolbox()
    toolbox.register("number", random.uniform, -5.12, 5.12)
    toolbox.register("individual", tools.initRepeat, creator.Individual, toolbox.number, 20)
    toolbox.register("population", tools.initRepeat, list, toolbox.individual)
    toolbox.register("evaluate", rastrigin)
    toolbox.register("mate", tools.cxBlend, alpha=0.5)
    toolbox.register("mutate", tools.mutGaussian, mu=0, sigma=0.1, indpb=0.05)
    toolbox.register("select", tools.selTournament, tournsize=3)
    with multiprocessing.Pool(2) as pool:
        toolbox.register("map", pool.map)
        begun = time.monotonic()
        # Every individual is varied, so that each generation evaluates all 200.
        population = toolbox.population(200)
        for individual, fitness in zip(population, toolbox.map(toolbox.evaluate, population)):
            individual.fitness.values = fitness
        for _ in range(int(sys.argv[1]) - 1):
            offspring = algorithms.varAnd(toolbox.select(population, len(population)), toolbox, 1.0, 1.0)
            for individual, fitness in zip(offspring, toolbox.map(toolbox.evaluate, offspring)):
                individual.fitness.values = fitness
            population = offspring
        print(time.monotonic() - begun, min(each.fitness.values[0] for each in population))


if __name__ == "__main__":
    main()
