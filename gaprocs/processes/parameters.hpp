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

Split split_named(const std::string&); ///< returns the Split with this value of the parameter `split`
/// Returns the number of bytes that a string takes in a message. This number is `stated`, or, if `stated` is 0, the
/// bits of the problem's string, rounded up to whole bytes.
std::uint32_t string_bytes(std::int64_t stated, const SearchProblem&);
/// Reads from the netlist the computing costs of the process and the lengths of its messages. If the problem has an
/// objective, messages contain 0 bytes of measurements.
Workload read_workload(const ProcessEnvironment&, const SearchProblem&);
Workload read_slave_workload(const ProcessEnvironment&); ///< reads only the values that a slave uses
Coding read_coding(const ProcessEnvironment&);
/// Returns the name of the process's random stream: the parameter `stream`, or, if `stream` is empty, the name of the
/// process.
std::string stream_name(const ProcessEnvironment&);
/// Reads the settings of the search; "usual" stands for the default policy for the problem, from usual_settings().
/// Throws what settings_for() throws, and UserError if the initial population cannot be made or read from a file.
SearchSettings read_search_settings(const ProcessEnvironment&, const SearchProblem&);
Farm::Settings read_farm_settings(const ProcessEnvironment&);

/// Returns the number of samples that the search itself needs before its first generation. An island may have to wait
/// for more samples: see samples_awaited(). REQUIRES: the problem has measurements.
std::size_t samples_needed(const ProcessInstance&);

/// Returns whether the process is a ga.coarse or a ga.fine, whose strings differ from the problem's strings.
bool breeds_recoded(const ProcessInstance&);
/// Reads the number of bits of each field (the bits of one parameter), as in "2 7 7". Throws UserError unless the text
/// consists of whole numbers from 1 to 63.
std::vector<std::size_t> bits_named(const std::string&);
/// Returns how the strings of a ga.coarse or ga.fine are converted to strings of the problem. The first bias point of a
/// ga.fine, around which it searches, is the string of zeros. Throws what Recoding::validate() throws.
Recoding read_recoding(const ProcessInstance&);

} // namespace placedpar
