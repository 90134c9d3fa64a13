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

/// A generation of one search, or of all searches together. What is minimised is here as it is, not negated: then the
/// best are the least, and an objective that is not a finite number is infinity.
struct LoggedGeneration {
    std::optional<Time> time; ///< time of the generation; of all searches: of the last
    double best_so_far; ///< the best of each `best` until now; where a window moves, each in the window of its time
    double best, mean;  ///< fitness; of all: of all their individuals. The mean is of those that are finite
    double diversity;   ///< diversity_within(); of all: the mean of theirs
    double between = 0; ///< diversity_between(); only of all

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

/// A number of the log, as data in long form: what was found where and when.
struct LogRow {
    std::uint64_t generation; ///< from 1
    std::optional<Time> time;
    std::string_view search; ///< or "all"
    std::string_view from;   ///< of an immigrant, or of an answer; else empty
    std::string_view quantity;
    double value;

    friend bool operator==(const LogRow&, const LogRow&) = default;
};

/// Remembers every generation of the searches of a run.
class GenerationLog final : public SearchObserver {
public:
    /// The searches by name, in the order of the log. `comparable`: they search for the same, so that there is sense in
    /// `all`.
    explicit GenerationLog(std::vector<std::string> searches, bool comparable = true);

    /// Throw std::invalid_argument for a search that is not of the log.
    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration&) override;
    void observe(const ObservedAnswer&) override;

    std::span<const std::string> searches() const { return searches_; }
    /// Are there several, which search for the same?
    bool compares() const { return compared_; }
    /// Generation 1 first.
    std::span<const LoggedGeneration> of(std::size_t search) const { return generations_.at(search); }
    /// Of all searches together, as far as all have come. Empty where there is only one, or they are not comparable.
    std::span<const LoggedGeneration> of_all() const { return all_; }
    /// Of each search in the order in which they came there.
    std::span<const LoggedMigration> migrations() const { return migrations_; }
    /// Of each analyst by generation.
    std::span<const LoggedAnswer> answers() const { return answers_; }

    /// Is the least the best? False before the first generation.
    bool minimises(std::size_t search) const { return goals_.at(search) == Goal::minimise; }
    /// Is it searched for an objective, not over a record? False before the first generation.
    bool has_objective(std::size_t search) const { return goals_.at(search).has_value(); }

    /// By generation, then by search with `all` and the analysts at the end: the same rows whatever the order in which
    /// the log was told. They refer to this.
    std::vector<LogRow> rows() const;

private:
    struct Evaluated {
        LoggedGeneration found;
        std::size_t finite; ///< individuals whose fitness is
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
