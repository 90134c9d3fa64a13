#include "experiments/kit/experiment_runs.hpp"

#include "explore/problems.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

constexpr const char* compliance = "C_BOi";

double true_compliance() { return known_problems(0).find("boom").problem()->true_parameters().at(0); }

void require_end(const RunReport& report, const std::filesystem::path& netlist) {
    if (Ending ending = report.result.ending; ending != Ending::completed)
        throw UnfinishedRun(
            fmt::format("{} did not come to its end: placedpar run shows where it stands", netlist.string()), ending);
}

} // namespace

void end_if_requested(const Interruption& interruption) {
    if (interruption.requested())
        throw UnfinishedRun("interrupted: the experiment is not complete, and no table or plot of it was made",
                            Ending::interrupted);
}

RunReport run_to_the_end(const std::filesystem::path& netlist, const Overrides& overrides,
                         const ReplayContext& context) {
    ProblemRegistry problems = known_problems(context.seed);
    Network network = load_network(netlist, overrides, problems, context.warn);
    RunReport report = run_netlist(network, problems, {.seed = context.seed, .interruption = &context.interruption});
    end_if_requested(context.interruption);
    require_end(report, netlist);
    return report;
}

Cell compliance_cell(const std::string& column, const RunReport& report, const std::string& process) {
    return {.row = compliance,
            .column = column,
            .unit = "in^3/psi",
            .reference = true_compliance(),
            .simulated = report.measured(process, compliance),
            .tolerance_percent = compliance_tolerance_percent,
            .decimals = 5};
}

std::string print_compliance_note() {
    return fmt::format(
        "{}: the compliance identified, beside the {} in^3/psi that the record was made with; it depends on the noise\n"
        "and the draws of the seed, and is judged at {:.0f} %\n",
        compliance, true_compliance(), compliance_tolerance_percent);
}

} // namespace placedpar
