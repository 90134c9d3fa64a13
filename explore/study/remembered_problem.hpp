#pragma once

#include "gaprocs/problem_family.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace placedpar {

/// Wraps a problem with an objective, to save computing time. It computes the fitness of each genome once, and
/// remembers the fitness for other processes, generations and runs. Neither this class nor ProblemRegistry is
/// thread-safe.
class RememberedProblem final : public AdaptedProblem {
public:
    /// The number of bytes left for remembered genomes. Several problems may share this number.
    using Room = std::shared_ptr<std::size_t>;
    static Room usual_room() { return std::make_shared<std::size_t>(32 << 20); }

    /// If no bytes are left, the problem forgets all its genomes and begins again. REQUIRES: the problem has an
    /// objective().
    explicit RememberedProblem(std::shared_ptr<const SearchProblem> problem, Room room = usual_room());
    ~RememberedProblem() override { forget(); }

    double fitness(const Genome&, std::span<const Sample>, double bias) const override;
    void fitness_of(std::span<const Genome> population, std::span<const Sample>, double bias,
                    std::span<double> out) const override;

private:
    struct Hash {
        std::size_t operator()(const Genome&) const;
    };

    /// Returns the problem in this coding. All calls with the same coding return the same object, which remembers its
    /// own genomes.
    std::shared_ptr<const SearchProblem> coded_plainly(Coding) const override;
    std::size_t bytes_of_one() const;
    void forget() const;

    Room room_;
    mutable std::unordered_map<Genome, double, Hash> known_; ///< never iterated over, since the order is not defined
    mutable std::map<std::string, std::shared_ptr<const SearchProblem>> codings_;
};

/// Problems that are made once for several registries, such as the registries of different seeds.
class RememberedProblems {
public:
    /// Returns the family, changed so that it makes each problem only once. A problem with an objective becomes a
    /// RememberedProblem. REQUIRES: this object outlives the result, and families with the same name are equal.
    ProblemFamily around(const ProblemFamily& family);

private:
    RememberedProblem::Room room_ = RememberedProblem::usual_room();
    std::map<std::string, std::shared_ptr<const SearchProblem>> problems_;
};

} // namespace placedpar
