#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Calls `work`, and catches the exceptions that `work` throws after having reported an error.
template <class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const StatementRefused&) { // already reported
    } catch (const GiveUp&) {
    }
}

/// Reads overrides as statements that follow the netlist's, the most precise first. Each override is a source of its
/// own, so that messages can show its text.
Statements read_overrides(const Overrides&, Reporter&);
/// Reads the values of `--fault` as statements, each as a source of its own.
Statements read_faults(const std::vector<std::string>&, Reporter&);

} // namespace placedpar
