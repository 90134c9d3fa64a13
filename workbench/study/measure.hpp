#pragma once

#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// A number with its unit.
struct StudyFigure {
    double value = 0;
    std::string unit;
};

/// Everything that is known of a run in numbers: "time" in ms, the "processors" and "links" that it took, what the
/// processes measured, "master[0].T_exe", and how busy the processors were, "t[0][1].busy" in percent.
using StudyFigures = std::map<std::string, StudyFigure>;
StudyFigures figures_of(const RunReport&, const Network&);

/// JSON: {"time":[8.9,"ms"], ...}.
std::string figures_text(const StudyFigures&);
/// The same to the last bit. REQUIRES: figures_text() made it.
StudyFigures figures_from(const std::string&);

/// One figure of a run, as a study names it: "time", "master[0].T_exe"; "master.T_exe" is the mean of all processes of
/// the array master, and min(...), max(...) and sum(...) are what they say.
class StudyMeasure {
public:
    /// Throws UserError for what can be none.
    explicit StudyMeasure(const std::string& text);

    const std::string& text() const { return text_; }
    /// None where the run has no such figure.
    std::optional<StudyFigure> of(const StudyFigures&) const;

private:
    bool matches(const std::string& figure) const;

    enum class Way { mean, least, greatest, sum };
    std::string text_, name_;
    Way way_ = Way::mean;
};

/// What may have been meant by a measure that a run does not have: a sentence, with all that it has.
std::string there_is_no_measure(const StudyMeasure&, const StudyFigures&);

} // namespace placedpar
