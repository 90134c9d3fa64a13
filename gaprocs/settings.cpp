#include "gaprocs/settings.hpp"

#include "gaprocs/fitness.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace placedpar {

namespace {

void require_probability(std::string_view name, double value) {
    if (!(value >= 0 && value <= 1))
        throw UserError(fmt::format("{} is {}, expected 0 to 1", name, value));
}

template <class Step>
void require_fitting(std::string_view what, const Step& step, StringKind kind) {
    if (!step.fits(kind))
        throw UserError(fmt::format("{} \"{}\" does not fit {}: expected {}", what, step.text(), name_of(kind),
                                    fmt::join(Step::fitting(kind), ", ")));
}

} // namespace

void WindowSettings::validate() const {
    if (length == 0)
        throw UserError("the window holds 0 samples, expected at least 1");
    if (length > exact_fitness_terms)
        throw UserError(
            fmt::format("the window holds {}, expected at most {}", counted(length, "sample"), exact_fitness_terms));
    if (first == 0)
        throw UserError("the first generation waits for 0 samples, expected at least 1");
    if (trials == 0)
        throw UserError("the number of generations per sample is 0, expected at least 1");
    if (!(bias > 0 && bias <= fitness_term_limit))
        throw UserError(
            fmt::format("the fitness bias is {}, expected a number above 0 and at most {}", bias, fitness_term_limit));
}

void WindowSettings::validate_for(std::size_t record_length) const {
    validate();
    if (length > record_length)
        throw UserError(
            fmt::format("the window holds {}, but the record has only {}", counted(length, "sample"), record_length));
}

void SearchSettings::validate() const {
    if (population < 2)
        throw UserError(
            fmt::format("the population is {}, expected at least 2: crossover needs two parents", population));
    if (population > largest_population)
        throw UserError(fmt::format("the population is {}, expected at most {}", population, largest_population));
    if (elite > population - 2)
        throw UserError(
            fmt::format("the elite is {} of a population of {}, expected at most {}: crossover needs two parents",
                        elite, population, population - 2));
    if (initial.size() > population)
        throw UserError(
            fmt::format("{} initial individuals are given for a population of {}", initial.size(), population));
    require_probability("the crossover probability", crossover_probability);
    require_probability("the mutation probability", mutation_probability);
    reproduction.require_numbers_in_range();
    crossover.require_numbers_in_range();
    mutation.require_numbers_in_range();
    window.validate();
}

void require_fitting_operators(const Representation& representation, const SearchSettings& settings) {
    require_fitting("the crossover", settings.crossover, representation.kind());
    require_fitting("the mutation", settings.mutation, representation.kind());
}

} // namespace placedpar
