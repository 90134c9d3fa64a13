#include "gaprocs/schema_theorem.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

double schema_bound(const Schema& schema, std::span<const Genome> population, std::span<const double> fitness,
                    double crossover_probability, double mutation_probability) {
    double of_schema = 0, of_all = 0; // total fitness of the matching strings, and of all strings
    for (std::size_t i = 0; i < population.size(); ++i) {
        double positive = std::max(fitness[i], 0.0);
        of_all += positive;
        of_schema += schema.matches(population[i]) ? positive : 0;
    }
    if (of_all <= 0)
        return 0;
    double cuts = static_cast<double>(std::max<std::size_t>(schema.size(), 2) - 1);
    double uncut = 1 - crossover_probability * static_cast<double>(schema.defining_length()) / cuts;
    double unmutated = std::pow(1 - mutation_probability, static_cast<double>(schema.order()));
    return static_cast<double>(population.size()) * of_schema / of_all * uncut * unmutated;
}

} // namespace placedpar
