#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Calls `work`, and swallows exceptions by which it ends after having reported an error.
template <class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const StatementRefused&) { // already reported
    } catch (const GiveUp&) {
    }
}

/// Reads overrides as statements that follow the netlist's, the most precise first. Each is a source of its own, which
/// messages can show.
Statements read_overrides(const Overrides&, Reporter&);
/// Reads the values of `--fault` as statements, in the same manner.
Statements read_faults(const std::vector<std::string>&, Reporter&);

} // namespace placedpar
