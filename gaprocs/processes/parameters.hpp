#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/processes/farm.hpp"
#include "gaprocs/processes/workload.hpp"
#include "gaprocs/recoding.hpp"
#include "gaprocs/settings.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

class ProcessEnvironment;

// The parameters that the process kinds describe, in the form that their bodies use.

Split split_named(const std::string&); ///< as the parameter "split" names it
/// What a string takes in a message: as stated, or where that is 0 the problem's bits in whole bytes.
std::uint32_t string_bytes(std::int64_t stated, const SearchProblem&);
/// An objective problem has no measurements to send.
Workload read_workload(const ProcessEnvironment&, const SearchProblem&);
Workload read_slave_workload(const ProcessEnvironment&); ///< only what a slave uses
Coding read_coding(const ProcessEnvironment&);
/// Returns the name of the random stream of the process.
std::string stream_name(const ProcessEnvironment&);
/// What the netlist does not give is as usual_settings() where that depends on the problem. Throws as settings_for().
SearchSettings read_search_settings(const ProcessEnvironment&, const SearchProblem&);
Farm::Settings read_farm_settings(const ProcessEnvironment&);

/// Samples that a search waits for before its first generation, other processes aside. REQUIRES: a problem with a
/// record.
std::size_t samples_needed(const ProcessInstance&);

/// Does it breed other strings than the problem's, as ga.coarse and ga.fine do?
bool breeds_recoded(const ProcessInstance&);
/// "2 7 7": bits of each field. Throws UserError for anything else than numbers from 1 to 63.
std::vector<std::size_t> bits_named(const std::string&);
/// How one that does breeds; a fine search around 0, until it knows better. Throws as Recoding::validate().
Recoding read_recoding(const ProcessInstance&);

} // namespace placedpar
