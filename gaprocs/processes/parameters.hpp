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

// These functions convert the parameters of the process kinds to the types that the processes use.

Split split_named(const std::string&); ///< by the name in the parameter "split"
/// Returns the length of a string in a message, in bytes: `stated`, or if `stated` is 0, the problem's number of bits
/// rounded up to whole bytes.
std::uint32_t string_bytes(std::int64_t stated, const SearchProblem&);
/// Reads the costs and the lengths of messages. An objective has no measurements to send.
Workload read_workload(const ProcessEnvironment&, const SearchProblem&);
Workload read_slave_workload(const ProcessEnvironment&); ///< reads only the values that a slave uses
Coding read_coding(const ProcessEnvironment&);
/// Returns the name of the process's random stream: the parameter `stream`, or if `stream` is empty, the name of the
/// process.
std::string stream_name(const ProcessEnvironment&);
/// Reads the settings of the search. Replaces a policy "usual" by the policy of usual_settings(). Throws as
/// settings_for().
SearchSettings read_search_settings(const ProcessEnvironment&, const SearchProblem&);
Farm::Settings read_farm_settings(const ProcessEnvironment&);

/// Returns the number of samples that the search needs before its first generation, without regard to other islands.
/// REQUIRES: the problem has a record.
std::size_t samples_needed(const ProcessInstance&);

/// Returns true for ga.coarse and ga.fine, which breed recoded strings of their problem.
bool breeds_recoded(const ProcessInstance&);
/// Reads the number of bits of each field, as in "2 7 7". Throws UserError unless all are numbers from 1 to 63.
std::vector<std::size_t> bits_named(const std::string&);
/// Returns the recoding of a ga.coarse or ga.fine; a fine search begins around the string of zeros. Throws as
/// Recoding::validate().
Recoding read_recoding(const ProcessInstance&);

} // namespace placedpar
