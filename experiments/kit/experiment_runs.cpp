#include "experiments/kit/experiment_runs.hpp"

#include "workbench/netlist_run.hpp"
#include "workbench/problems.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

constexpr const char* compliance = "C_BOi";

double true_compliance() { return known_problems(0).find("boom").problem->true_parameters().at(0); }

} // namespace

void end_if_interrupted() {
    if (InterruptGuard::interrupted())
        throw UnfinishedRun("interrupted: the experiment is not complete, and nothing was written",
                            Ending::interrupted);
}

RunReport run_to_the_end(const std::filesystem::path& netlist, const Overrides& overrides, std::uint64_t seed) {
    RunReport report = run_netlist(load_network(netlist, overrides), seed);
    end_if_interrupted();
    if (Ending ending = report.result.ending; ending != Ending::completed)
        throw UnfinishedRun(
            fmt::format("{} did not come to its end: placedpar run shows where it stands", netlist.string()), ending);
    return report;
}

Cell compliance_cell(const std::string& column, const RunReport& report, const std::string& process) {
    Cell cell{compliance,
              column,
              "in^3/psi",
              true_compliance(),
              report.measured(process, compliance),
              compliance_tolerance_percent};
    cell.decimals = 5;
    return cell;
}

std::string print_compliance_note() {
    return fmt::format(
        "{}: the compliance identified, beside the {} in^3/psi that the record was made with; it depends on the noise\n"
        "and the draws of the seed, and is judged at {:.0f} %\n",
        compliance, true_compliance(), compliance_tolerance_percent);
}

} // namespace placedpar
