#include "explore/explain/answers.hpp"

#include "explore/load.hpp"
#include "explore/problems.hpp"

#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

/// Returns the changes together with the user's settings. If both set the same value, the change prevails.
Overrides with_set(const Overrides& set, Overrides changes) {
    changes.merge(Overrides(set));
    return changes;
}

/// Returns a function that reads the netlist with some changes. The function shows no warnings, since the user has seen
/// the warnings of the netlist before.
ChangedNetlist reading_with(const ChangedRuns& runs) {
    return [parsed = runs.parsed, set = runs.set, host = runs.host](const Overrides& changes) {
        Network network =
            load_network(parsed, with_set(set, changes), known_kinds(known_problems(0)), [](const std::string&) {});
        network.host = host;
        return network;
    };
}

DeclaredWith declaring_with(const ChangedRuns& runs) {
    auto problems = std::make_shared<const ProblemRegistry>(known_problems(0)); // the kinds refer to it
    auto kinds = std::make_shared<const Catalogue>(known_kinds(*problems));
    return [parsed = runs.parsed, set = runs.set, problems, kinds](const Overrides& changes) {
        return parsed.read(*kinds, with_set(set, changes)).declared;
    };
}

/// Returns the reason why a run with this outcome cannot be compared with changed runs. Returns "" if the run can be
/// compared.
std::string why_not_compared(RunOutcome outcome) {
    return outcome == RunOutcome::completed
               ? ""
               : fmt::format("a comparison needs the time at which the work is done, but this run did not "
                             "complete ({})",
                             name_of(outcome));
}

} // namespace

Explanation explanation_of(RunReport report, const CriticalPath& path) {
    Explanation explanation;
    explanation.report = std::move(report);
    explanation.accounts = path.accounts();
    explanation.waits_at_links = path.waits_at_links();
    explanation.path = path.parts();
    explanation.path_too_long = path.too_long();
    return explanation;
}

void add_answers(Explanation& explanation, const Network& network, const ChangedRuns& runs,
                 const Interruption& interruption) {
    explanation.not_tried = why_not_compared(explanation.report.outcome());
    if (!explanation.not_tried.empty())
        return;
    const std::vector<Change> changes = changes_of(network, explanation.report, declaring_with(runs));
    explanation.answers =
        try_out(changes, explanation.path,
                {reading_with(runs), runs.seed, runs.until, interruption, runs.progress, runs.at_once});
    explanation.left_out = changes.size() - explanation.answers.size();
}

} // namespace placedpar
