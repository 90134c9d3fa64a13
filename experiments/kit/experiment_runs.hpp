#pragma once

#include "experiments/kit/experiment.hpp"

#include <stdexcept>
#include <string>

namespace placedpar {

/// A run of an experiment that did not come to its end, so that there is nothing to compare.
class UnfinishedRun : public std::runtime_error {
public:
    UnfinishedRun(const std::string& what, Ending how) : std::runtime_error(what), ending(how) {}
    Ending ending;
};

/// Throws UnfinishedRun when it was requested.
void end_if_requested(const Interruption&);
/// Runs a netlist of the examples to its end. Throws RefusedInput and UnfinishedRun.
RunReport run_to_the_end(const std::filesystem::path& netlist, const Overrides&, const ReplayContext&);

/// What the boom's identification is to come within of the truth: the thesis's "states within 10 %".
inline constexpr double compliance_tolerance_percent = 10;
/// The compliance that a process identified, beside the one that the record was made with.
Cell compliance_cell(const std::string& column, const RunReport&, const std::string& process);
/// For people: what that row shows.
std::string print_compliance_note();

} // namespace placedpar
