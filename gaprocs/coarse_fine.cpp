#include "gaprocs/coarse_fine.hpp"

#include "gaprocs/traditional.hpp"

#include <stdexcept>

namespace placedpar {

namespace {

const CoarseFineSettings& validated(const CoarseFineSettings& settings) {
    const WindowSettings &coarse = settings.coarse.window, &fine = settings.fine.window;
    if (coarse.length != fine.length || coarse.first != fine.first || coarse.bias != fine.bias)
        throw std::invalid_argument("a coarse and a fine search must have equal windows");
    settings.coarse_reading.validate();
    return settings;
}

Recoding fine_reading_of(const CoarseFineSettings& settings) {
    Recoding reading = settings.coarse_reading;
    reading.bits = settings.fine_bits;
    reading.around = Genome(reading.problem_length());
    reading.validate();
    return reading;
}

} // namespace

CoarseFine::CoarseFine(const SearchProblem& problem, const CoarseFineSettings& settings, std::uint64_t seed)
    : problem_(problem), bias_(settings.coarse.window.bias), window_(validated(settings).coarse.window),
      coarse_reading_(settings.coarse_reading), fine_reading_(fine_reading_of(settings)),
      coarse_(coarse_reading_.length(), settings.coarse, RandomStream(seed, "coarse")),
      fine_(fine_reading_.length(), settings.fine, RandomStream(seed, "fine")) {}

void CoarseFine::next_generation() {
    coarse_best_ = evaluate_and_breed(coarse_, coarse_reading_);
    fine_reading_.around = coarse_best_.genome;
    fine_best_ = evaluate_and_breed(fine_, fine_reading_);
}

Individual CoarseFine::evaluate_and_breed(Search& search, const Recoding& reading) {
    search.next_generation(evaluate(problem_, reading.to_problem(search.population()), window_.samples(), bias_));
    return {reading.to_problem(search.best().genome), search.best().fitness};
}

} // namespace placedpar
