#pragma once

#include "explore/generate/topology.hpp"

#include <string>

namespace placedpar {
class RecordedProblem; // gaprocs/problem_registry.hpp
}

namespace placedpar::generate {

/// The processes of a generated netlist, and their placement on its processors, the array `t`.
struct Job {
    bool has_host = false;  ///< whether there is a process `host`, which the netlist must place
    std::string about;      ///< a description, such as "Islands: one on every processor. ..."
    std::string vals;       ///< declarations of constants, such as "val samples 6;", in lines with a newline
    std::string statements; ///< other statements, in lines with a newline
};

/// The netlist statements by which the processes of a job get their search problem.
struct ProblemStatements {
    std::string vals;   ///< declarations of constants, in lines with a newline
    std::string host;   ///< parameters of the host
    std::string search; ///< parameters of each master or island, besides population and workload
    std::string each;   ///< parameters of each process that has a parameter "problem": "", or "problem = problem"
};

/// Returns the statements for the problem `name`; for the default problem if `problem` is null.
ProblemStatements statements_of(const std::string& name, const RecordedProblem* problem);

/// Places a master on the first processor, and a slave on every other processor. Channels to slaves that are not
/// neighbours of the master are routed through other processors.
Job farm(const Topology&, const ProblemStatements&);
/// Places an island, a search that exchanges individuals with its neighbours, on every processor. Islands on
/// neighbouring processors are neighbours.
Job islands(const Topology&, const ProblemStatements&);
/// In the topology `figure-e2`, places an island on the head of each chain, and its slaves along the chain.
Job islands_with_slaves(const ProblemStatements&);
/// Places a process of `kind` on every processor, and connects it with its neighbours by the port arrays named by
/// `output` and `input`. `parameters` are the parameters that each process has; "" for none.
Job processes_of(const std::string& kind, bool has_host, const std::string& output, const std::string& input,
                 const Topology&, const ProblemStatements&, const std::string& parameters);

} // namespace placedpar::generate
