#include "gaprocs/processes/share.hpp"

#include "gaprocs/fitness.hpp"

namespace placedpar {

namespace {

/// Returns the number of units of work, out of `units`, that the master keeps.
std::size_t master_units(std::size_t units, std::size_t slaves, double own_share) {
    if (slaves == 0)
        return units;
    return static_cast<std::size_t>(static_cast<double>(units) * own_share / (static_cast<double>(slaves) + own_share));
}

} // namespace

std::vector<Share> deal(std::size_t population, std::size_t window, std::size_t slaves, Split split, double own_share) {
    // The unit of work is one error evaluation or one individual. If the units cannot be divided equally, the first
    // slaves get one unit more.
    std::size_t unit = split == Split::evaluations ? 1 : window;
    std::size_t units = population * window / unit;
    std::size_t dealt = units - master_units(units, slaves, own_share);
    std::vector<Share> shares;
    std::size_t next = 0;
    for (std::size_t i = 0; i < slaves; ++i) {
        std::size_t end = next + dealt / slaves + (i < dealt % slaves);
        shares.push_back({next * unit, end * unit, window});
        next = end;
    }
    shares.push_back({next * unit, units * unit, window});
    return shares;
}

std::size_t most_individuals(std::size_t population, std::size_t slaves, Split split, double own_share) {
    if (split == Split::demand)
        return 1;
    std::size_t dealt = population - master_units(population, slaves, own_share);
    return (dealt + slaves - 1) / slaves + (split == Split::evaluations ? 1 : 0);
}

std::vector<double> evaluate_share(const SearchProblem& problem, const Share& share, std::span<const Genome> strings,
                                   std::span<const Sample> window, double bias) {
    std::vector<double> terms(share.individuals(), 0.0);
    if (share.first % share.window == 0 && share.last % share.window == 0) { // only whole individuals
        problem.fitness_of(strings, window, bias, terms);
        return terms;
    }
    for (std::size_t e = share.first; e < share.last; ++e) {
        std::size_t individual = e / share.window - share.first_individual();
        terms[individual] += fitness_term(bias, problem.error(strings[individual], window[e % share.window]));
    }
    return terms;
}

void add_terms(const Share& share, std::span<const double> terms, std::span<double> fitness) {
    for (std::size_t i = 0; i < terms.size(); ++i)
        fitness[share.first_individual() + i] += terms[i];
}

} // namespace placedpar
