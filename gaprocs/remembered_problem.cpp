#include "gaprocs/remembered_problem.hpp"

#include <boost/container_hash/hash.hpp>

#include <utility>

namespace placedpar {

namespace {

constexpr int tried_out = 20; ///< strings that show what one takes

} // namespace

RememberedProblem::RememberedProblem(std::shared_ptr<const SearchProblem> problem, Room room, Duration worth_it)
    : problem_(std::move(problem)), room_(std::move(room)), worth_it_(worth_it) {}

std::size_t RememberedProblem::Hash::operator()(const Genome& genome) const {
    return boost::hash_range(genome.words().begin(), genome.words().end());
}

bool RememberedProblem::is_worth_it() const { return tried_ < tried_out || taken_ >= tried_out * worth_it_; }

double RememberedProblem::compute(const Genome& genome, std::span<const Sample> samples, double bias) const {
    if (tried_ == tried_out)
        return problem_->fitness(genome, samples, bias);
    auto begun = std::chrono::steady_clock::now();
    double fitness = problem_->fitness(genome, samples, bias);
    taken_ += std::chrono::steady_clock::now() - begun;
    ++tried_;
    return fitness;
}

double RememberedProblem::fitness(const Genome& genome, std::span<const Sample> samples, double bias) const {
    if (!is_worth_it())
        return problem_->fitness(genome, samples, bias);
    if (auto known = known_.find(genome); known != known_.end())
        return known->second;
    const double computed = compute(genome, samples, bias);
    if (*room_ < bytes_of_one())
        forget();
    if (*room_ >= bytes_of_one() && known_.emplace(genome, computed).second)
        *room_ -= bytes_of_one();
    return computed;
}

std::size_t RememberedProblem::bytes_of_one() const { return sizeof *known_.begin() + (problem_->bits() + 7) / 8; }

void RememberedProblem::forget() const {
    *room_ += known_.size() * bytes_of_one();
    known_.clear();
}

void RememberedProblem::fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                                   std::span<double> out) const {
    if (!is_worth_it())
        return problem_->fitness_of(population, samples, bias, out);
    for (std::size_t i = 0; i < population.size(); ++i)
        out[i] = fitness(population[i], samples, bias);
}

std::shared_ptr<const SearchProblem> RememberedProblem::coded_plainly(Coding coding) const {
    auto& coded = codings_[coding.text()];
    if (!coded)
        coded = std::make_shared<RememberedProblem>(problem_->coded(coding), room_, worth_it_);
    return coded;
}

ProblemFamily RememberedProblems::around(const ProblemFamily& family) {
    ProblemFamily remembered = family;
    remembered.make = [this, family](const std::vector<double>& numbers) {
        auto& known = problems_[family.description.text(numbers)];
        if (!known)
            known = family.make(numbers);
        if (known->objective() && !std::dynamic_pointer_cast<const RememberedProblem>(known))
            known = std::make_shared<RememberedProblem>(known, room_);
        return known;
    };
    return remembered;
}

} // namespace placedpar
