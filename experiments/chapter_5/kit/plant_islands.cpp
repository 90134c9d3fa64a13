#include "experiments/chapter_5/kit/plant_islands.hpp"

#include "gaprocs/active_error_analysis.hpp"
#include "problems/plant/plant_problem.hpp"

#include <memory>
#include <span>
#include <utility>

namespace placedpar {

namespace {

// The thesis does not state these values; they follow its text as we understand it.
constexpr std::size_t plant_elite = 1;
const char* const plant_acceptance = "offspring";
// The first generation in which diversity is measured, and the number of generations from one measurement to the next.
constexpr std::size_t diversity_from = 400, diversity_every = 10;

IslandsSettings settings_of(const PlantIslands& plant) {
    IslandsSettings settings;
    for (std::size_t i = 0; i < plant.windows.size(); ++i) {
        SearchSettings island;
        island.population = plant.populations[i];
        island.elite = plant_elite;
        island.reproduction = Reproduction::named(plant.reproduction);
        island.window = {.length = plant.windows[i],
                         .first = plant.windows[i],
                         .trials = plant.plant.per_sample,
                         .bias = plant.bias};
        settings.islands.push_back(island);
    }
    settings.topology = Topology::named(plant.topology);
    settings.schedule = Schedule::named(plant.schedule);
    settings.acceptance = Acceptance::named(plant_acceptance);
    return settings;
}

/// Returns the mean number of bits in which two individuals of a population differ.
double mean_difference(std::span<const Genome> population) {
    auto size = static_cast<double>(population.size());
    double sum = 0;
    for (std::size_t bit = 0; bit < population.front().size(); ++bit) {
        double ones = 0;
        for (const Genome& genome : population)
            ones += genome.bit(bit) ? 1 : 0;
        sum += 2 * ones * (size - ones) / (size * (size - 1));
    }
    return sum;
}

std::shared_ptr<const SearchProblem> problem_of(const PlantIslands& plant) {
    return plant.simulated ? make_search_problem(SimulatedPlantProblem(), plant.coding)
                           : make_search_problem(PlantProblem(), plant.coding);
}

class IslandsOnPlant {
public:
    IslandsOnPlant(const PlantIslands& plant, std::uint64_t seed)
        : plant_(plant), problem_(problem_of(plant)), record_(plant_samples(plant.plant, seed)),
          islands_(*problem_, settings_of(plant), island_streams(seed, plant.windows.size())) {
        for (const std::string& choice : plant.choices)
            analyses_.emplace_back(*problem_, plant.windows, IslandChoice::named(choice), RandomStream(seed, choice));
        run_.islands.resize(plant.windows.size());
        run_.answers.resize(plant.choices.size());
        run_.chosen.resize(plant.choices.size());
    }

    PlantSearchRun run() {
        for (std::size_t sample = 0; sample < record_.size(); ++sample) {
            islands_.push(record_[sample]);
            if (sample + 1 < plant_.plant.window)
                continue;
            for (std::size_t trial = 0; trial < plant_.plant.per_sample && generation_ < plant_.plant.generations;
                 ++trial)
                run_generation(std::span(record_).first(sample + 1));
        }
        run_.diversity /= static_cast<double>(looks_);
        run_.identical /= static_cast<double>(looks_);
        return std::move(run_);
    }

private:
    void run_generation(std::span<const Sample> samples) {
        islands_.next_generation();
        for (std::size_t i = 0; i < run_.islands.size(); ++i)
            run_.islands[i].push_back(pole(islands_.searches()[i].best()));
        if (!islands_.migrations().empty())
            analyse(samples);
        for (std::size_t i = 0; i < analyses_.size(); ++i)
            run_.answers[i].push_back(broadcast_ ? pole(analyses_[i].answer()) : run_.islands.front().back());
        if (generation_ >= diversity_from && generation_ % diversity_every == 0)
            look_at_diversity();
        ++generation_;
    }

    void analyse(std::span<const Sample> samples) {
        std::vector<Individual> bests;
        for (const Search& search : islands_.searches())
            bests.push_back(search.best());
        for (std::size_t i = 0; i < analyses_.size(); ++i) {
            analyses_[i].analyse(bests, samples);
            run_.chosen[i].push_back(analyses_[i].island());
        }
        broadcast_ = true;
    }

    void look_at_diversity() {
        double sum = 0;
        for (const Search& search : islands_.searches())
            sum += mean_difference(search.population());
        run_.diversity += sum / static_cast<double>(islands_.searches().size());
        const Genome& first = islands_.searches().front().best().genome;
        run_.identical += first == islands_.searches().back().best().genome ? 1 : 0;
        ++looks_;
    }

    Pole pole(const Individual& individual) const {
        auto parameters = problem_->decode(individual.genome);
        return {parameters[1], std::abs(parameters[2])};
    }

    const PlantIslands& plant_;
    std::shared_ptr<const SearchProblem> problem_;
    std::vector<Sample> record_;
    Islands islands_;
    std::vector<ActiveErrorAnalysis> analyses_;
    PlantSearchRun run_;
    std::size_t generation_ = 0, looks_ = 0;
    bool broadcast_ = false;
};

} // namespace

std::vector<std::vector<double>> plant_samples(const PlantExperiment& plant, std::uint64_t seed) {
    return plant_record(plant, RandomStream(seed, "plant"));
}

PlantSearchRun search_plant(const PlantIslands& islands, std::uint64_t seed) {
    return IslandsOnPlant(islands, seed).run();
}

} // namespace placedpar
