#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Does work that may refuse a text, and reports the refusal.
template <class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const StatementRefused&) { // already reported
    } catch (const GiveUp&) {
    }
}

/// Reads overrides as statements that come behind those of the netlist, the most precise first. Each is a source of its
/// own that messages can show.
Statements read_overrides(const Overrides&, Reporter&);
/// Reads what `--fault` says likewise.
Statements read_faults(const std::vector<std::string>&, Reporter&);

} // namespace placedpar
