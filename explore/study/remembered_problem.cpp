#include "explore/study/remembered_problem.hpp"

#include <boost/container_hash/hash.hpp>

#include <utility>

namespace placedpar {

RememberedProblem::RememberedProblem(std::shared_ptr<const SearchProblem> problem, Room room)
    : AdaptedProblem(std::move(problem)), room_(std::move(room)) {}

std::size_t RememberedProblem::Hash::operator()(const Genome& genome) const {
    return boost::hash_range(genome.words().begin(), genome.words().end());
}

double RememberedProblem::fitness(const Genome& genome, std::span<const Sample> samples, double bias) const {
    if (auto known = known_.find(genome); known != known_.end())
        return known->second;
    const double computed = problem_->fitness(genome, samples, bias);
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
    for (std::size_t i = 0; i < population.size(); ++i)
        out[i] = fitness(population[i], samples, bias);
}

std::shared_ptr<const SearchProblem> RememberedProblem::coded_plainly(Coding coding) const {
    auto& coded = codings_[coding.text()];
    if (!coded)
        coded = std::make_shared<RememberedProblem>(problem_->coded(coding), room_);
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
