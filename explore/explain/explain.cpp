#include "explore/explain/explain.hpp"

#include "explore/load.hpp"
#include "explore/problems.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace placedpar {

namespace {

/// Adds the netlist's settings to the changes, except settings that a change replaces.
Overrides with_set(const NetlistToChange& netlist, Overrides changes) {
    changes.merge(Overrides(netlist.set));
    return changes;
}

/// Reads changed netlists silently, since their warnings have been shown.
ChangedNetlist reading_with(const NetlistToChange& netlist) {
    return [netlist](const Overrides& changes) {
        return load_network(netlist.parsed, with_set(netlist, changes), known_kinds(known_problems(0)),
                            [](const std::string&) {});
    };
}

DeclaredWith declaring_with(const NetlistToChange& netlist) {
    auto problems = std::make_shared<const ProblemRegistry>(known_problems(0)); // the kinds refer to it
    auto kinds = std::make_shared<const Catalogue>(known_kinds(*problems));
    return [netlist, problems, kinds](const Overrides& changes) {
        return netlist.parsed.read(*kinds, with_set(netlist, changes)).declared;
    };
}

/// Returns why a run with this ending cannot be compared with changed runs; "" if it can.
std::string why_not_compared(Ending ending) {
    return ending == Ending::completed
               ? ""
               : fmt::format("a comparison needs the time at which the work is done, but this run did not "
                             "complete ({})",
                             name_of(ending));
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

void add_answers(Explanation& explanation, const Network& network, const NetlistToChange& netlist, std::uint64_t seed,
                 Time until, const Interruption& interruption,
                 const std::function<void(std::size_t, std::size_t)>& progress) {
    explanation.not_tried = why_not_compared(explanation.report.result.ending);
    if (!explanation.not_tried.empty())
        return;
    std::vector<Change> changes = changes_of(network, explanation.report, declaring_with(netlist));
    explanation.answers =
        try_out(changes, explanation.path, {reading_with(netlist), seed, until, interruption, progress});
    explanation.left_out = changes.size() - explanation.answers.size();
}

} // namespace placedpar
