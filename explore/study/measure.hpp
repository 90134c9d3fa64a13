#pragma once

#include "explore/study/price.hpp"

#include <boost/json/fwd.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

class Catalogue;               // netlist/kinds/catalogue.hpp
class ProblemRegistry;         // gaprocs/problem_registry.hpp
struct MeasurementDescription; // netlist/kinds/process_kind.hpp
struct Network;                // netlist/network/network.hpp
struct ProcessInstance;        // netlist/network/network.hpp
struct RunReport;              // netlist/run_report.hpp

struct StudyFigure {
    double value = 0; ///< NaN if the process measured no number: a best individual that violates a constraint has none
    std::string unit;
};

/// The figures of a run, by name: "time" in ms, the numbers of "processors" and "links" used, the results that
/// processes report, such as "master[0].T_exe", and the load of each processor in percent, such as "t[0][1].busy". If
/// parts have prices, "price" is the price of the machine.
using StudyFigures = std::map<std::string, StudyFigure>;
StudyFigures figures_of(const RunReport&, const Network&, const Prices& = {});

/// Parses JSON and keeps the bytes of its strings, whether they are UTF-8 or not. Throws std::exception.
boost::json::value read_kept_json(const std::string&);

/// Returns the figures as JSON: {"time":[8.9,"ms"], ...}.
std::string figures_text(const StudyFigures&);
/// Reads the figures back without any loss. Throws std::exception if the text was not made by figures_text().
StudyFigures figures_from(const std::string&);

/// One figure of a run, as a study names it: "time" or "master[0].T_exe". The mean over all processes of the array
/// `master` is "master.T_exe" or "mean(master.T_exe)"; there are also min(...), max(...) and sum(...).
class StudyMeasure {
public:
    /// Throws UserError for a text that cannot name a measure.
    explicit StudyMeasure(const std::string& text);

    const std::string& text() const { return text_; }
    /// Returns the measure of a run; nothing if the run has no such figure, or if the figure is not a number. A mean or
    /// a sum is missing if one of its figures is not a number. A least or greatest figure ignores such figures.
    std::optional<StudyFigure> of(const StudyFigures&) const;
    /// Returns whether the run has the figure, be it a number or not.
    bool is_in(const StudyFigures&) const;

    /// Returns the name of the measured quantity: "master.T_exe" for "max(master[0].T_exe)".
    std::string name_without_subscripts() const;
    /// Returns the measure's name in the expressions of tables: "T_exe".
    std::string last_name() const;

private:
    bool matches(const std::string& figure) const;

    enum class Aggregate { mean, least, greatest, sum };
    std::string text_, name_;
    Aggregate way_ = Aggregate::mean;
};

/// Returns a sentence about a measure that a run does not have, or for which it has no number. If the kind of the
/// process has this measurement, the sentence describes the measurement, which the process did not make in this run.
/// Otherwise the sentence suggests a similar name, or lists all measures of the run.
std::string there_is_no_measure(const StudyMeasure&, const StudyFigures&);

/// The measures that runs of these networks may have, as far as the netlists show, including measures that only some
/// runs have. With them, wrong names are found before the first run.
class PossibleMeasures {
public:
    void add(const Network&, const Catalogue&, const ProblemRegistry&);
    void add(const std::string& measure) { abouts_[measure]; }
    /// Returns the descriptions of the measures, with their units. The keys are names without subscripts.
    const std::map<std::string, std::string>& abouts() const { return abouts_; }
    bool has(const StudyMeasure&) const;
    /// Returns a sentence that lists all possible measures.
    std::string why_unknown(const StudyMeasure&) const;

private:
    void add(const ProcessInstance&, const MeasurementDescription&, const ProblemRegistry&);

    std::map<std::string, std::string> abouts_;
    std::set<std::string> unknown_; ///< prefixes such as "column." of processes whose kind does not describe all its
                                    ///< measurements
};

} // namespace placedpar
