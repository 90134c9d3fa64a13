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

Split split_named(const std::string&); ///< by its name in the parameter "split"
/// Returns the bytes of a string in a message: `stated`, or if that is 0 the problem's bits rounded up to bytes.
std::uint32_t string_bytes(std::int64_t stated, const SearchProblem&);
/// Reads the costs and message lengths. An objective problem has no measurements to send.
Workload read_workload(const ProcessEnvironment&, const SearchProblem&);
Workload read_slave_workload(const ProcessEnvironment&); ///< only the values that a slave uses
Coding read_coding(const ProcessEnvironment&);
/// Returns the name of the process's random stream: the parameter `stream`, or the name of the process if that is
/// empty.
std::string stream_name(const ProcessEnvironment&);
/// Reads the settings of the search. A policy "usual" is replaced by that of usual_settings(). Throws as
/// settings_for().
SearchSettings read_search_settings(const ProcessEnvironment&, const SearchProblem&);
Farm::Settings read_farm_settings(const ProcessEnvironment&);

/// Returns how many samples the search itself needs before its first generation, regardless of other islands. REQUIRES:
/// a problem with a record.
std::size_t samples_needed(const ProcessInstance&);

/// Returns whether the process breeds strings other than the problem's own: true for ga.coarse and ga.fine.
bool breeds_recoded(const ProcessInstance&);
/// Reads the number of bits of each field, as in "2 7 7". Throws UserError unless all are numbers from 1 to 63.
std::vector<std::size_t> bits_named(const std::string&);
/// Returns the recoding of a ga.coarse or ga.fine; a fine search begins around the string of zeros. Throws as
/// Recoding::validate().
Recoding read_recoding(const ProcessInstance&);

} // namespace placedpar
