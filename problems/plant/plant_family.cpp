#include "problems/plant/plant_family.hpp"

#include "problems/plant/plant_problem.hpp"
#include "problems/plant/plant_record.hpp"
#include "runtime/random.hpp"

namespace placedpar {

namespace {

/// A plant problem that knows the plant's coefficient a1 at the end of the record.
template <class Problem>
struct PlantThatEnds : Problem {
    double a1;

    std::vector<double> true_parameters() const { return placedpar::parameters_of(Plant{.a1 = a1}); }
};

/// The parameters of an experiment, as a netlist states them.
struct PlantFamily {
    static constexpr std::string_view
        name = "plant",
        about = "identification of the plant of thesis chapter 5 with noise e; the coefficient a1 changes";
    double a1 = PlantChange().a1, from = PlantChange().from, lasts = PlantChange().lasts;
    double noise = PlantExperiment().noise, c1 = 0, c2 = 0;
    std::size_t generations = PlantExperiment().generations, per_sample = PlantExperiment().per_sample;
    std::size_t simulated = 0; ///< 1: SimulatedPlantProblem; 0: PlantProblem

    static constexpr auto numbers() {
        constexpr double widest = 1.67; // a complex pair of poles for -1.67 < a1 < 1.67, since a2 = -.7
        return std::tuple(
            PolicyNumber{"a1", &PlantFamily::a1, -widest, widest,
                         "final value of the coefficient a1, which begins at 1.5 (Table 5.4)"},
            PolicyNumber{"from", &PlantFamily::from, 0, 1e6, "generation at which the change begins"},
            PolicyNumber{"lasts", &PlantFamily::lasts, 0, 1e6,
                         "duration of the linear change, in generations; 0: a step"},
            PolicyNumber{"noise", &PlantFamily::noise, 0, 1e3, "standard deviation of the white noise e (5.8)"},
            PolicyNumber{"c1", &PlantFamily::c1, -10, 10, "colour of the noise: e(k) + c1 e(k-1) + c2 e(k-2)"},
            PolicyNumber{"c2", &PlantFamily::c2, -10, 10, "second coefficient of the noise's colour"},
            PolicyNumber{"generations", &PlantFamily::generations, 1, 1e6,
                         "number of generations for which the record suffices"},
            PolicyNumber{"per_sample", &PlantFamily::per_sample, 1, 1e3,
                         "generations between two samples; set an island's trials to the same number"},
            PolicyNumber{"simulated", &PlantFamily::simulated, 0, 1,
                         "1: the model is simulated inside the window; 0: the model predicts from measured "
                         "outputs"});
    }

    PlantExperiment experiment() const {
        return {.change = {.a1 = a1, .from = from, .lasts = lasts},
                .noise = noise,
                .colour = {c1, c2},
                .generations = generations,
                .per_sample = per_sample};
    }
};

PlantExperiment experiment_of(const std::vector<double>& numbers) {
    return make_policy<PlantFamily>(numbers).experiment();
}

/// Returns the settings of the examples of chapter 5.
RecordAdvice advice_for(const std::vector<double>& numbers) {
    auto plant = make_policy<PlantFamily>(numbers);
    return {.trials = plant.per_sample, .bias = plant.simulated ? 100.0 : 10.0};
}

template <class Problem>
std::shared_ptr<const SearchProblem> plant_that_ends(double a1) {
    return make_search_problem(PlantThatEnds<Problem>{{}, a1});
}

std::shared_ptr<const SearchProblem> plant_with(const std::vector<double>& numbers) {
    PlantExperiment experiment = experiment_of(numbers);
    double a1 = a1_at(experiment.change, static_cast<double>(experiment.generations));
    return make_policy<PlantFamily>(numbers).simulated ? plant_that_ends<SimulatedPlantProblem>(a1)
                                                       : plant_that_ends<PlantProblem>(a1);
}

} // namespace

ProblemFamily plant_family(std::uint64_t seed) {
    auto record = [seed](const std::vector<double>& numbers) {
        PlantExperiment experiment = experiment_of(numbers);
        auto make = [=] { return plant_record(experiment, RandomStream(seed, "record of the plant")); };
        return RecordToMake{experiment.record_length(), make, advice_for(numbers)};
    };
    return {describe_policy<PlantFamily>(), plant_with, record};
}

} // namespace placedpar
