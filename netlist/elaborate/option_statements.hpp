#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Calls `work`, which reports its errors. Catches the exceptions that `work` then throws.
template <class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const StatementRefused&) { // already reported
    } catch (const GiveUp&) {
    }
}

/// Parses the options `--set NAME=VALUE` as statements, which are executed after the netlist. Options with more precise
/// targets come first: `p[1].n` before `p.n`, and `p.n` before `n`. Each option counts as a separate source file, so
/// that messages can show its text.
Statements read_overrides(const Overrides&, Reporter&);
/// Parses the values of the options `--fault` as statements. Each value counts as a separate source file.
Statements read_faults(const std::vector<std::string>&, Reporter&);

} // namespace placedpar
