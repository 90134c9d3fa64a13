#pragma once

#include "explore/study/axis.hpp"
#include "explore/study/expression.hpp"
#include "explore/study/measure.hpp"
#include "explore/study/table.hpp"
#include "netlist/read.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// All combinations of the axes' values for which the condition holds. The last axis counts fastest.
struct StudyProduct {
    std::vector<StudyAxis> axes;
    StudyExpression where{""};

    /// Throws UserError, which says what makes it so large, where 64 bits do not hold it.
    std::uint64_t count() const;
    /// REQUIRES: index < count().
    Overrides at(std::uint64_t index) const;
    /// Whether it is one of these combinations.
    bool has(const Overrides&) const;
};

/// A run of a study: what is set in the netlist, and the seed.
struct StudyRun {
    Overrides set;
    std::uint64_t seed = 1;

    auto operator<=>(const StudyRun&) const = default;
};

/// How the best of a study's combinations are to be searched for.
struct StudySearch {
    static constexpr std::uint64_t most_population = 10'000, most_generations = 1'000'000;

    std::vector<std::string> minimise; ///< a measure, or two that are weighed against each other
    std::uint64_t population = 40;     ///< 4 or more; the better half stays and breeds the other
    std::uint64_t generations = 20;    ///< 1 or more
    std::uint64_t seed = 1;            ///< of the search's random numbers
};

/// What is run in place of a netlist. Called from several threads at once. REQUIRES: the figures are finite.
using StudyFunction = std::function<StudyFigures(const StudyRun&)>;

/// Which runs of a netlist, or of a function, are to be made, and what is to be known of them.
struct Study {
    std::string netlist;         ///< its path
    StudyFunction function = {}; ///< none: the netlist is run
    ReadOptions read = {};
    std::vector<StudyProduct> products;
    std::uint64_t first_seed = 1, seeds = 1; ///< each combination is run with `seeds` seeds
    Time until = Time::max();                ///< runs that are not over then are stopped
    std::vector<std::string> measures;
    Overrides relative_to = {}; ///< figures are shown relative to those with these settings; none: as they are
    std::optional<StudySearch> search = {}; ///< none: it is only swept
    std::vector<StudyTable> tables = {};    ///< of figures beside known ones
    std::vector<std::string> figures = {};  ///< measures that the tables are made of
    std::string notes = "";                 ///< for people, below the tables

    /// Runs, those with combinations for which the condition does not hold among them. Throws UserError, which says
    /// what makes it so large, where 64 bits do not hold it, or the last seed.
    std::uint64_t count() const;
    /// None where the condition does not hold. The seed counts fastest. REQUIRES: index < count().
    std::optional<StudyRun> at(std::uint64_t index) const;
    /// Whether it has runs with these settings, whatever else they set, were it not for a condition.
    bool has_some(const Overrides&) const;
    /// What it sets.
    std::vector<std::string> names() const;
    /// Its value of that name that is equal to this one, if it has that.
    std::optional<SettingValue> find(const std::string& name, const SettingValue&) const;
};

/// Finds the runs of a study by their numbers, for loops over them: each is found by a binary search among the
/// products, which are as many as the cells of the study's tables. REQUIRES: the study outlives it and keeps its
/// products and seeds.
class StudyRuns {
public:
    /// Throws as Study::count().
    explicit StudyRuns(const Study&);

    std::uint64_t count() const { return ends_.empty() ? 0 : ends_.back(); }
    std::optional<StudyRun> at(std::uint64_t index) const;

private:
    const Study& study_;
    std::vector<std::uint64_t> ends_; ///< of the products: how many runs there are up to each
};

} // namespace placedpar
