#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Calls `work`, and catches the exceptions that `work` throws after reporting an error.
template <class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const StatementRefused&) { // already reported
    } catch (const GiveUp&) {
    }
}

/// Reads overrides as statements that are executed after the netlist, beginning with the override that has the most
/// precise target. Each override is a separate source file, so that messages can show its text.
Statements read_overrides(const Overrides&, Reporter&);
/// Reads the values of `--fault` as statements. Each value is a separate source file.
Statements read_faults(const std::vector<std::string>&, Reporter&);

} // namespace placedpar
