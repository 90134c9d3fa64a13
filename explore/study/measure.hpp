#pragma once

#include <boost/json/fwd.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

class Catalogue;        // netlist/kinds/catalogue.hpp
class ProblemRegistry;  // gaprocs/problem_registry.hpp
struct Network;         // netlist/network/network.hpp
struct ProcessInstance; // netlist/network/network.hpp
struct RunReport;       // netlist/run_report.hpp

/// A number with its unit.
struct StudyFigure {
    double value = 0;
    std::string unit;
};

/// Everything that is known of a run in numbers: "time" in ms, the "processors" and "links" that it took, what the
/// processes measured, "master[0].T_exe", and how busy the processors were, "t[0][1].busy" in percent.
using StudyFigures = std::map<std::string, StudyFigure>;
StudyFigures figures_of(const RunReport&, const Network&);

/// JSON in which texts are the bytes that they were, whether these are UTF-8 or not. Throws std::exception.
boost::json::value read_kept_json(const std::string&);

/// JSON: {"time":[8.9,"ms"], ...}.
std::string figures_text(const StudyFigures&);
/// Reads the figures back, equal to the last bit. Throws std::exception where figures_text() did not make it.
StudyFigures figures_from(const std::string&);

/// One figure of a run, as a study names it: "time", "master[0].T_exe"; "master.T_exe" is the mean of all processes of
/// the array master, and min(...), max(...) and sum(...) are what they say.
class StudyMeasure {
public:
    /// Throws UserError for a text that cannot name a measure.
    explicit StudyMeasure(const std::string& text);

    const std::string& text() const { return text_; }
    /// None where the run has no such figure.
    std::optional<StudyFigure> of(const StudyFigures&) const;

    /// Of what it is a measure: "master.T_exe" of "max(master[0].T_exe)".
    std::string name_without_subscripts() const;
    /// What figures of tables call it: "T_exe".
    std::string last_name() const;

private:
    bool matches(const std::string& figure) const;

    enum class Way { mean, least, greatest, sum };
    std::string text_, name_;
    Way way_ = Way::mean;
};

/// What is so of a measure that a run does not have, a sentence: what it is, where the run was one of those that do not
/// come to it; else what may have been meant, with all that it has.
std::string there_is_no_measure(const StudyMeasure&, const StudyFigures&);

/// What runs can measure, as far as their netlists say before any is made. What is measured only where it came to pass
/// is among it.
class PossibleMeasures {
public:
    void add(const Network&, const Catalogue&, const ProblemRegistry&);
    bool has(const StudyMeasure&) const;
    /// A sentence, with all that there are.
    std::string why_unknown(const StudyMeasure&) const;

private:
    void add(const ProcessInstance&, const std::string& described, const ProblemRegistry&);

    std::set<std::string> names_;   ///< without subscripts
    std::set<std::string> unknown_; ///< "column.": of processes that measure what their kind does not name
};

} // namespace placedpar
