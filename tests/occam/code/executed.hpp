#pragma once

#include "occam/code/compile.hpp"
#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/core.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::test {

/// A transputer that has been booted with code.
class BootedCode {
public:
    static constexpr std::uint32_t memory_bytes = 1 << 20;

    /// REQUIRES: the code and its data take at most half of the memory.
    BootedCode(const occam::Code&, const occam::CodeOptions&, std::uint32_t memory = memory_bytes);
    ~BootedCode();
    BootedCode(const BootedCode&) = delete;
    BootedCode& operator=(const BootedCode&) = delete;

    /// Sets the table of error texts. REQUIRES: called before run(); the table outlives this object.
    void know_errors(const transputer::CodeLines& lines) { core_->know_errors(lines); }
    /// Runs until nothing can happen any more. Returns whether this is before the limit.
    bool run(transputer::HalfCycles most);
    /// Sets the first words of the main procedure's free memory. REQUIRES: called before run().
    void set_results(std::span<const std::int32_t>);
    /// Returns a word of the free memory.
    std::int32_t result(std::uint32_t index) const;
    const transputer::Core& core() const;

private:
    class BootLink;
    std::unique_ptr<BootLink> link_;
    std::unique_ptr<transputer::Core> core_;
    transputer::Word results_;
};

/// The results of executing a program in occam on an emulated transputer.
struct Executed {
    std::vector<std::int32_t> results; ///< words that the program stored in `memory`
    bool halted = false;               ///< whether an error has halted the processor
    std::string trouble;               ///< another reason why the core stopped; "" if there is none
    std::vector<std::string> errors;   ///< errors that halted the processor or stopped a process, such as "5:3 STOP"
    std::vector<std::string> waiting;  ///< the names of processes that wait at the end
    std::uint64_t cycles = 0;          ///< cycles in which instructions were executed
};

/// Compiles a program and boots a transputer with it. `body` is the body of PROC main (CHAN OF SP fs, ts, []INT
/// memory), which stores its results in `memory`. `declarations` stand before the procedure. `memory` begins with the
/// words `initial`. Throws std::runtime_error with the messages if the program has errors; throws as compile() does.
Executed execute(std::string_view body, const occam::CodeOptions& = {.model = transputer::Model::t800},
                 std::string_view declarations = "", std::span<const std::int32_t> initial = {});

struct CompiledProgram {
    std::unique_ptr<occam::Program> program;
    occam::Code code;
};
/// Compiles a program. Throws std::runtime_error with the messages if it has errors; throws as compile() does.
CompiledProgram compiled_program(const std::string& text, const occam::CodeOptions&);

/// Returns the text with this number of blanks in front of each line.
std::string indented(std::string_view text, std::size_t blanks);

} // namespace placedpar::test
