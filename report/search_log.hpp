#pragma once

#include "gaprocs/generation_log.hpp"
#include "netlist/network/network.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace placedpar {

/// Returns whether the process has a population: ga.traditional, ga.master, ga.island, ga.coarse or ga.fine.
bool searches(const ProcessInstance&);

/// Throws UserError if no process searches.
void require_searches(const Network&);

/// Makes an empty log of the processes that search, in the order of the netlist. The log compares the searches if all
/// of them have the same problem and coding, and none is a ga.coarse or ga.fine, whose strings differ.
GenerationLog log_of(const Network&);

/// Holds the log of the searches of a run with this seed.
struct SeededLog {
    std::uint64_t seed;
    GenerationLog log;
};

/// Prints the rows of the logs as comma-separated values, in long form:
/// seed,generation,time_ms,process,from,quantity,value. Numbers have the fewest digits from which the same number is
/// read back.
std::string log_csv(std::span<const SeededLog>);

} // namespace placedpar
