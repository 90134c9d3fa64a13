#pragma once

#include "experiments/kit/experiment.hpp"
#include "occam/code/code.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// The output of a program with a host, and the fingerprint of its run.
struct PrintedRun {
    std::string text;
    std::uint64_t fingerprint = 0;

    /// Returns the first number in the text after `words`. Throws UserError if no number follows them.
    double number_behind(std::string_view words) const;
    /// Returns the numbers of the text, in order. Only a whole word counts as a number.
    std::vector<double> numbers() const;
};

/// Compiles a program in occam and runs it on a T800 with 2 Mbyte. An access to external memory takes `memory_cycles`
/// cycles. Throws RefusedInput and UnfinishedRun.
PrintedRun run_occam(const std::filesystem::path&, const occam::CodeOptions&, int memory_cycles, const ReplayContext&);

/// Runs a netlist of the examples in which one processor has a host. Throws as run_to_the_end().
PrintedRun run_printing(const std::filesystem::path& netlist, const Overrides&, const ReplayContext&);

} // namespace placedpar
