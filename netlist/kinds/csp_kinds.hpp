#pragma once

namespace placedpar {

class Catalogue;

/// Adds the small processes of the CSP textbooks, over channels of counted byte arrays: csp.producer,
/// csp.identity, csp.prefix, csp.delta, csp.successor, csp.consumer. Good for a first netlist, for measuring
/// a link, and for deadlocks.
void add_csp_kinds(Catalogue&);

} // namespace placedpar
