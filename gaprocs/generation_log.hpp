#pragma once

#include "gaprocs/diversity.hpp"
#include "gaprocs/search_observer.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

class Checkpoints; // gaprocs/checkpoints.hpp

/// A generation of one search, or of all searches together. For a problem with an objective, the log has the values of
/// the objective instead of the fitness. So if the objective is minimised, the best value is the least. An objective
/// that is not a finite number is logged as the worst value: plus infinity if the objective is minimised, minus
/// infinity if it is maximised.
struct LoggedGeneration {
    std::optional<Time> time; ///< time of the generation; for all searches together, the latest of their times
    double best_so_far;       ///< best value of `best` up to this generation. If the window of measurements moves, this
                              ///< compares fitness values from different windows
    double best, mean;        ///< fitness or objective; `mean` omits values that are not finite
    double diversity;         ///< how different the individuals of a search are (diversity_within()); for all searches
                              ///< together, the mean over the searches
    double between = 0; ///< how different individuals of different searches are (diversity_between()); only for all
                        ///< searches together

    friend bool operator==(const LoggedGeneration&, const LoggedGeneration&) = default;
};

/// A generation in which the best value so far became better, with this value.
struct LoggedStep {
    std::uint64_t generation;
    double value; ///< as LoggedGeneration::best_so_far

    friend bool operator==(const LoggedStep&, const LoggedStep&) = default;
};

struct LoggedMigration {
    std::uint64_t generation;
    std::size_t from, to; ///< numbers of the two searches
    std::optional<Time> time;
    double fitness;
    bool accepted;
};

/// An answer of an analyst, a process that chooses one of several searches. The answer is the best individual of the
/// chosen search.
struct LoggedAnswer {
    std::uint64_t generation;
    std::string analyst;
    std::size_t chosen; ///< number of the chosen search
    std::optional<Time> time;
    std::vector<std::string> names; ///< names of the parameters
    std::vector<double> values;
};

/// One value of the log, as a row of a table in long form.
struct LogRow {
    std::uint64_t generation; ///< from 1
    std::optional<Time> time;
    std::string_view search; ///< name of the search, or "all"
    std::string_view from;   ///< search from which an immigrant came, or search that an analyst chose; otherwise empty
    std::string_view quantity;
    double value;

    friend bool operator==(const LogRow&, const LogRow&) = default;
};

/// Records every generation of the searches of a run, for tables and plots of convergence.
class GenerationLog : public SearchObserver {
public:
    /// `searches`: names of the searches, in the order of the log. `comparable`: whether all searches solve the same
    /// problem. If not, the log has no generations of all searches together.
    explicit GenerationLog(std::vector<std::string> searches, bool comparable = true);

    /// Makes LoggedGeneration::best_so_far and the steps include the generations before the checkpoints from which the
    /// run continues. REQUIRES: no generation was observed.
    void continue_from(const Checkpoints&);

    /// The three functions observe() throw std::invalid_argument for a search that is not in the log.
    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration&) override;
    void observe(const ObservedAnswer&) override;

    std::span<const std::string> searches() const { return searches_; }
    /// Returns whether there are several searches that solve the same problem.
    bool compares() const { return compared_; }
    /// Returns the number of the first logged generation: 1 unless the searches continue from a checkpoint.
    std::uint64_t first() const { return first_; }
    /// Returns the generations of a search, beginning with generation number first().
    std::span<const LoggedGeneration> of(std::size_t search) const { return generations_.at(search); }
    /// Returns an entry for each generation that all searches have completed. The entry combines the values of all
    /// searches. Empty if compares() is false.
    std::span<const LoggedGeneration> of_all() const { return all_; }
    /// Returns the steps by which the best value of a search became better. They begin with generation 1, also if the
    /// search continues from a checkpoint.
    std::vector<LoggedStep> steps_of(std::size_t search) const;
    /// Returns the steps of all searches together, up to the last generation of of_all().
    std::vector<LoggedStep> steps_of_all() const;
    /// Returns the migrations. Migrations to the same search are in the order of arrival.
    std::span<const LoggedMigration> migrations() const { return migrations_; }
    /// Returns the answers. Answers of the same analyst are in the order of the generations.
    std::span<const LoggedAnswer> answers() const { return answers_; }

    /// Returns whether the search minimises an objective; false before the first generation.
    bool minimises(std::size_t search) const { return goals_.at(search) == Goal::minimise; }
    /// Returns whether the search has an objective instead of measurements; false before the first generation.
    bool has_objective(std::size_t search) const { return goals_.at(search).has_value(); }

    /// Returns the whole log as rows, sorted by generation and then by search. Within a generation, "all" and the
    /// analysts come last. The rows do not depend on the order of the calls of observe(). REQUIRES: the log outlives
    /// the rows, which refer to strings of the log.
    std::vector<LogRow> rows() const;

private:
    struct Evaluated {
        LoggedGeneration found;
        std::size_t finite; ///< number of individuals whose fitness is finite
        Spread spread;
    };
    using Row = std::vector<std::optional<Evaluated>>; ///< one generation, with an element for each search

    std::size_t number_of(std::string_view search) const;
    void wait_for_the_others(std::uint64_t generation, std::size_t search, Evaluated&&);
    LoggedGeneration found_in(const ObservedGeneration&, std::size_t search, const Spread&) const;
    double better(std::size_t search, double a, double b) const;
    void add_to_all(const Row&);
    std::vector<LogRow> rows_of_migrations() const;
    std::vector<LogRow> rows_of_answers() const;

    std::vector<std::string> searches_;
    bool compared_;
    std::uint64_t first_ = 1;
    std::vector<std::optional<Goal>> goals_;        ///< goal of each search
    std::vector<std::vector<Improvement>> earlier_; ///< improvements of each search before its checkpoint
    std::vector<std::vector<LoggedGeneration>> generations_;
    std::vector<LoggedGeneration> all_;
    std::map<std::uint64_t, Row> waiting_; ///< generations that only some searches have completed
    std::vector<LoggedMigration> migrations_;
    std::vector<LoggedAnswer> answers_;
};

} // namespace placedpar
