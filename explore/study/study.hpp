#pragma once

#include "explore/study/axis.hpp"
#include "explore/study/expression.hpp"
#include "explore/study/measure.hpp"
#include "explore/study/price.hpp"
#include "explore/study/table.hpp"
#include "netlist/read.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// All combinations of the values of several settings (axes) for which the condition `where` holds. The last axis
/// varies fastest.
struct StudyProduct {
    std::vector<StudyAxis> axes;
    StudyExpression where{""};

    /// Returns the number of combinations, including combinations for which the condition does not hold. Throws
    /// UserError if this number exceeds 64 bits; the message names the cause.
    std::uint64_t count() const;
    /// REQUIRES: index < count().
    Overrides at(std::uint64_t index) const;
    /// Returns whether the settings are one of these combinations.
    bool has(const Overrides&) const;
};

/// A run of a study: settings of the netlist, and a seed.
struct StudyRun {
    Overrides set;
    std::uint64_t seed = 1;

    auto operator<=>(const StudyRun&) const = default;
};

/// The settings of a search for the best of a study's combinations.
struct StudySearch {
    static constexpr std::uint64_t most_population = 10'000, most_generations = 1'000'000;

    std::vector<std::string> minimise; ///< one measure, or two for a Pareto front
    std::uint64_t population = 40;     ///< 4 or more; the better half survives and breeds the other half
    std::uint64_t generations = 20;    ///< 1 or more
    std::uint64_t seed = 1;            ///< seed of the search's random numbers
};

/// A function that is run in place of a netlist. Several threads may call it at the same time. REQUIRES: its figures
/// are finite.
using StudyFunction = std::function<StudyFigures(const StudyRun&)>;

/// A study: many runs of a netlist or of a function with different settings and seeds, and the measures to report.
struct Study {
    std::string netlist;         ///< path of the netlist
    StudyFunction function = {}; ///< empty: the netlist is run
    ReadOptions read = {};
    std::vector<StudyProduct> products;
    std::uint64_t first_seed = 1, seeds = 1; ///< each combination is run with `seeds` seeds
    Time until = Time::max();                ///< simulated time at which unfinished runs are stopped
    std::vector<std::string> measures;
    /// Each figure is divided by the figure of the run with these settings; empty: figures are absolute.
    Overrides relative_to = {};
    std::optional<StudySearch> search = {}; ///< empty: all combinations are run
    std::vector<StudyTable> tables = {};    ///< tables that show figures beside known figures
    std::vector<std::string> figures = {};  ///< measures that occur in the tables
    Prices prices = {};                     ///< empty: runs have no measure "price"
    std::string notes = "";                 ///< text printed below the tables

    /// Returns the number of runs, including runs for which the condition does not hold. Throws UserError if this
    /// number, or the last seed, exceeds 64 bits; the message names the cause.
    std::uint64_t count() const;
    /// Returns a run; nothing if the condition does not hold for it. The seed varies fastest. REQUIRES: index <
    /// count().
    std::optional<StudyRun> at(std::uint64_t index) const;
    /// Returns whether some combination of the study includes these settings; ignores conditions.
    bool has_some(const Overrides&) const;
    /// Returns the names of all settings of the study.
    std::vector<std::string> names() const;
    /// Returns the study's value of the setting `name` that is equal to the argument; nothing if there is none.
    std::optional<SettingValue> find(const std::string& name, const SettingValue&) const;
};

/// Throws UserError unless there are this many consecutive seeds from `first` on. There must be at least one.
void require_seeds(std::uint64_t first, std::uint64_t seeds);

/// Finds the runs of a study by their numbers. A study may have thousands of products, one for each cell of its tables,
/// so the product of a run is found by a binary search. REQUIRES: the study outlives this object, and its products and
/// seeds do not change.
class StudyRuns {
public:
    /// Throws as Study::count() does.
    explicit StudyRuns(const Study&);

    std::uint64_t count() const { return ends_.empty() ? 0 : ends_.back(); }
    std::optional<StudyRun> at(std::uint64_t index) const;

private:
    const Study& study_;
    std::vector<std::uint64_t> ends_; ///< for each product: number of runs of this product and all products before it
};

} // namespace placedpar
