#pragma once

#include "gaprocs/problem_registry.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"

#include <cstdint>
#include <filesystem>

namespace placedpar {

/// Reads a netlist with this program's kinds. Warnings go to standard error. Throws RefusedInput.
Network load_network(const std::filesystem::path&, const Overrides&);
/// The same with other problems than the program's own, such as one of a user's record.
Network load_network(const std::filesystem::path&, const Overrides&, const ProblemRegistry&);

/// While one exists, SIGINT and SIGTERM end the run that is going on, and at once each that is begun later, instead of
/// the program. Every run has one; who makes several runs holds one around them all, which is then the only one.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Whether such a signal came.
    static bool interrupted();

private:
    bool outermost_;
    void (*before_int_)(int) = nullptr;
    void (*before_term_)(int) = nullptr;
};

/// Runs a network. SIGINT and SIGTERM end the run early. `trace` may be null. Throws what the processes throw.
RunReport run_netlist(const Network&, std::uint64_t seed, Time limit = Time::max(), TraceSink* trace = nullptr);
/// The same with other problems than the program's own, such as one of a user's record.
RunReport run_netlist(const Network&, const ProblemRegistry&, std::uint64_t seed, Time limit = Time::max(),
                      TraceSink* trace = nullptr);

} // namespace placedpar
