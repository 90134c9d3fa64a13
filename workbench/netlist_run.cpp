#include "workbench/netlist_run.hpp"

#include "text/diagnostic.hpp"
#include "text/user_error.hpp"
#include "workbench/problems.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>

namespace placedpar {

namespace {

bool guarded = false;
std::atomic<bool> signal_came{false};
std::atomic<Machine*> machine_to_interrupt{nullptr};

extern "C" void interrupt_machine(int) {
    signal_came = true;
    if (Machine* machine = machine_to_interrupt.load())
        machine->interrupt();
}

/// While it exists, the signal knows the machine.
class Interruptible {
public:
    explicit Interruptible(Machine& machine) {
        machine_to_interrupt = &machine;
        if (InterruptGuard::interrupted()) // before the signal knew it
            machine.interrupt();
    }
    ~Interruptible() { machine_to_interrupt = nullptr; }

private:
    InterruptGuard guard_;
};

} // namespace

InterruptGuard::InterruptGuard() : outermost_(!guarded) {
    if (!outermost_)
        return;
    guarded = true;
    signal_came = false;
    before_int_ = std::signal(SIGINT, interrupt_machine);
    before_term_ = std::signal(SIGTERM, interrupt_machine);
}

InterruptGuard::~InterruptGuard() {
    if (!outermost_)
        return;
    std::signal(SIGINT, before_int_);
    std::signal(SIGTERM, before_term_);
    guarded = false;
}

bool InterruptGuard::interrupted() { return signal_came; }

Network load_network(const std::filesystem::path& path, const Overrides& overrides) {
    return load_network(path, overrides, known_problems(0));
}

Network load_network(const std::filesystem::path& path, const Overrides& overrides, const ProblemRegistry& problems) {
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
    Interruptible interruptible(machine);
    return machine.run(limit);
}

} // namespace placedpar
