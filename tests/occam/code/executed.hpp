#pragma once

#include "occam/code/compile.hpp"
#include "runtime/transputer/core.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::test {

/// What a program of occam has done on an emulated transputer.
struct Executed {
    std::vector<std::int32_t> results; ///< the words that it stored in `memory`
    bool halted = false;               ///< an error has halted the processor
    std::string trouble;               ///< why the core stopped otherwise; "" if it did not
    std::vector<std::string> errors;   ///< those that halted the processor or stopped a process: "5:3 STOP"
    std::vector<std::string> waiting;  ///< the names of processes that wait at the end
    std::uint64_t cycles = 0;          ///< in which instructions were executed
};

/// Compiles a program and boots a transputer with it. `text` is the body of
/// PROC main (CHAN OF SP fs, ts, []INT memory), which stores its results in `memory`; `declarations` stand before it.
/// Throws std::runtime_error with the messages if the program has errors; throws as compile() does.
Executed execute(std::string_view body, const occam::CodeOptions& = {.model = transputer::Model::t800},
                 std::string_view declarations = "");

/// Returns the text with so many blanks in front of each line.
std::string indented(std::string_view text, std::size_t blanks);

} // namespace placedpar::test
