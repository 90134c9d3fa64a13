#include "app/netlist_run.hpp"

#include "app/problems.hpp"
#include "app/refused_input.hpp"
#include "netlist/diagnostic.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>

namespace placedpar {

namespace {

std::atomic<Machine*> machine_to_interrupt{nullptr};

extern "C" void interrupt_machine(int) {
    if (Machine* machine = machine_to_interrupt.load())
        machine->interrupt();
}

/// While it exists, SIGINT and SIGTERM end the machine's run instead of the program.
class SignalGuard {
public:
    explicit SignalGuard(Machine& machine) {
        machine_to_interrupt = &machine;
        before_int_ = std::signal(SIGINT, interrupt_machine);
        before_term_ = std::signal(SIGTERM, interrupt_machine);
    }
    ~SignalGuard() {
        std::signal(SIGINT, before_int_);
        std::signal(SIGTERM, before_term_);
        machine_to_interrupt = nullptr;
    }

private:
    void (*before_int_)(int);
    void (*before_term_)(int);
};

} // namespace

Network load_network(const std::filesystem::path& path, const Overrides& overrides) {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
    ReadResult read = read_netlist(path, catalogue, overrides);
    if (!read.network)
        throw RefusedInput(render(read.diagnostics));
    fmt::print(stderr, "{}", render(read.diagnostics));
    return std::move(*read.network);
}

RunReport run_netlist(const Network& network, std::uint64_t seed, Time limit, TraceSink* trace) {
    return run_netlist(network, known_problems(seed), seed, limit, trace);
}

RunReport run_netlist(const Network& network, const ProblemRegistry& problems, std::uint64_t seed, Time limit,
                      TraceSink* trace) {
    Catalogue catalogue = known_kinds(problems);
    Machine machine(network, catalogue, seed);
    if (trace)
        machine.trace_to(*trace);
    SignalGuard guard(machine);
    return machine.run(limit);
}

} // namespace placedpar
