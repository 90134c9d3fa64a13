#pragma once

#include "netlist/network/network.hpp"
#include "occam/language/tree.hpp"
#include "text/user_error.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace placedpar::occam {

/// A procedure of a file, as the program of a process.
struct ProgramOfProcess {
    std::string path; ///< of the file
    const Program* program = nullptr;
    const Declaration* procedure = nullptr;
};

/// Returns a program in occam that is all processes on a node that are code: a PAR of instances, with channels between
/// them, and with channels that are placed at the links of the node. A channel to the host is placed at its link.
/// `program_of` returns the program of a process. Throws UserError if the programs cannot be one.
std::string text_of_image(const Network&, std::size_t node,
                          const std::function<ProgramOfProcess(const ProcessInstance&)>& program_of);

} // namespace placedpar::occam
