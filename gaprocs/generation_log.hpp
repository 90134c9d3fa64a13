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

/// A generation of one search, or of all searches together. An objective that is minimised is not negated here: the
/// best value is the least, and an objective that is not a finite number is infinity.
struct LoggedGeneration {
    std::optional<Time> time; ///< time of the generation; for all searches together, the latest of their times
    double best_so_far; ///< the best value of `best` so far; with a moving window, each value belongs to the window of
                        ///< its time
    double best, mean;  ///< fitness, or objective; the mean is taken over the finite values
    double diversity;   ///< diversity_within(); for all searches together, its mean
    double between = 0; ///< diversity_between(); only for all searches together

    friend bool operator==(const LoggedGeneration&, const LoggedGeneration&) = default;
};

struct LoggedMigration {
    std::uint64_t generation;
    std::size_t from, to; ///< searches, by number
    std::optional<Time> time;
    double fitness;
    bool accepted;
};

/// An answer of an analyst: it says which search's best individual is the answer of all searches.
struct LoggedAnswer {
    std::uint64_t generation;
    std::string analyst;
    std::size_t chosen; ///< a search, by number
    std::optional<Time> time;
    std::vector<std::string> names; ///< names of the parameters
    std::vector<double> values;
};

/// One value of the log, as a row of data in long form.
struct LogRow {
    std::uint64_t generation; ///< from 1
    std::optional<Time> time;
    std::string_view search; ///< or "all"
    std::string_view from;   ///< origin of an immigrant, or search whose best an answer is; otherwise empty
    std::string_view quantity;
    double value;

    friend bool operator==(const LogRow&, const LogRow&) = default;
};

/// Remembers every generation of the searches of a run.
class GenerationLog final : public SearchObserver {
public:
    /// `searches`: their names, in the order of the log. `comparable`: all solve the same problem, so that rows for all
    /// of them together make sense.
    explicit GenerationLog(std::vector<std::string> searches, bool comparable = true);

    /// Throw std::invalid_argument for a search that is not in the log.
    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration&) override;
    void observe(const ObservedAnswer&) override;

    std::span<const std::string> searches() const { return searches_; }
    /// Returns whether there are several searches that solve the same problem.
    bool compares() const { return compared_; }
    /// Returns the generations of a search, generation 1 first.
    std::span<const LoggedGeneration> of(std::size_t search) const { return generations_.at(search); }
    /// Returns the generations that all searches have completed, for all of them together. Empty unless compares().
    std::span<const LoggedGeneration> of_all() const { return all_; }
    /// Returns the migrations; those to one search are in the order of their arrival.
    std::span<const LoggedMigration> migrations() const { return migrations_; }
    /// Returns the answers; those of one analyst are in the order of generations.
    std::span<const LoggedAnswer> answers() const { return answers_; }

    /// Returns whether the least value is the best. False before the first generation.
    bool minimises(std::size_t search) const { return goals_.at(search) == Goal::minimise; }
    /// Returns whether the search has an objective instead of a record. False before the first generation.
    bool has_objective(std::size_t search) const { return goals_.at(search).has_value(); }

    /// Returns the rows by generation, then by search, with "all" and the analysts at the end. Their order does not
    /// depend on the order of the calls of observe(). The rows refer to this log.
    std::vector<LogRow> rows() const;

private:
    struct Evaluated {
        LoggedGeneration found;
        std::size_t finite; ///< number of individuals whose fitness is finite
        Spread spread;
    };
    using Row = std::vector<std::optional<Evaluated>>; ///< a generation, by search

    std::size_t number_of(std::string_view search) const;
    void wait_for_the_others(std::uint64_t generation, std::size_t search, Evaluated&&);
    LoggedGeneration found_in(const ObservedGeneration&, std::size_t search, const Spread&) const;
    double better(std::size_t search, double a, double b) const;
    void add_to_all(const Row&);
    std::vector<LogRow> rows_of_migrations() const;
    std::vector<LogRow> rows_of_answers() const;

    std::vector<std::string> searches_;
    bool compared_;
    std::vector<std::optional<Goal>> goals_; ///< by search
    std::vector<std::vector<LoggedGeneration>> generations_;
    std::vector<LoggedGeneration> all_;
    std::map<std::uint64_t, Row> waiting_; ///< generations that some searches have not made yet
    std::vector<LoggedMigration> migrations_;
    std::vector<LoggedAnswer> answers_;
};

} // namespace placedpar
