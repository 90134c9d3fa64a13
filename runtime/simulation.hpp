#pragma once

#include "runtime/channel.hpp"
#include "runtime/deadlock.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/process.hpp"

#include <concepts>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// How a run ended, and when its work did (see wait_until_work_is_over).
struct RunResult {
    Ending ending = Ending::completed;
    Time time{};                   ///< virtual time at the end of the work
    std::uint64_t fingerprint = 0; ///< fingerprint of the whole run
    std::uint64_t events = 0; ///< number of the machine's events: the host's cost of the run, besides the processes
    /// If the run ended stuck: all processes that are left. If it was stopped before its end: those that would never
    /// have gone on, however long it had lasted.
    std::optional<Deadlock> deadlock;
    /// Processes that had not had a single turn at the end, because other processes occupied their processor or it was
    /// halted. In order of creation.
    std::vector<std::string> never_ran;
};

/// Processes and the devices that they run on, to be run once. Where a program that uses PlacedPar as a library begins.
///
///     Simulation simulation;
///     auto& t800 = simulation.add<hardware::Processor>("t800");
///     Channel<int> c("c");
///     simulation.process("sender", [&] { c.out().output(42); }, &t800);
///     simulation.process("receiver", [&] { c.in().input(); });
///     RunResult result = simulation.run();
///
/// 1. Devices, channels and processes are made before run(); run() is called once.
/// 2. A device may refer to those that were added before it. When the simulation is destroyed, the processes go first,
///    then the devices, the last one first.
/// 3. Channels, and everything else that the processes refer to, must outlive run().
/// 4. All of this happens on one thread; only interrupt() may be called from elsewhere.
class Simulation {
public:
    Simulation() = default;
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation();

    /// Makes a device, Device(kernel, arguments...), and owns it. A device is any class that works on a kernel: an
    /// executive, a link, a router, or one of the caller's own.
    template <class Device, class... Arguments>
    requires std::constructible_from<Device, Kernel&, Arguments...> Device& add(Arguments&&... arguments) {
        auto device = std::make_shared<Device>(kernel_, std::forward<Arguments>(arguments)...);
        devices_.push_back(device);
        return *device;
    }
    /// Adds a process that starts when the simulation does. Without an executive its program takes no time.
    Process& process(std::string name, Process::Body, Executive* on = nullptr, Priority = Priority::low);
    /// Adds a process and declares the channel ends that it will use, as a netlist does:
    /// `simulation.process("ping", {there.out(), back.in()}, ...)`. Without the ends, the report of a deadlock before
    /// the first communication cannot name the partners. Throws std::logic_error when another process already owns an
    /// end.
    Process& process(std::string name, const std::vector<DeclaredEnd>&, Process::Body, Executive* on = nullptr,
                     Priority = Priority::low);
    /// Returns the processes in the order of their creation.
    const std::list<Process>& processes() const { return processes_; }

    /// Selects another of the program's possible courses: see Kernel::shuffle.
    void shuffle(std::uint64_t seed) { kernel_.shuffle(seed); }
    /// The sink must outlive run().
    void trace_to(TraceSink& sink) { kernel_.trace_to(sink); }

    /// Runs until every process has ended, none can go on, or the limit is reached; calls `work_over` when the work is,
    /// for figures that are to be those of the work. Rethrows what a process threw;
    /// throws std::overflow_error when the next thing to happen lies beyond the end of virtual time, and
    /// std::logic_error when another simulation is running on this thread or this one has run before.
    RunResult run(
        Time limit = Time::max(), const std::function<void()>& work_over = [] {});
    /// The process whose exception run() rethrew.
    const std::optional<Failure>& who_failed() const { return kernel_.who_failed(); }
    /// Ends a run that is under way. May be called from a signal handler or another thread.
    void interrupt() { kernel_.interrupt(); }

private:
    Kernel kernel_;
    std::vector<std::shared_ptr<void>> devices_; ///< each destroyed as the class that was added
    std::list<Process> processes_;
};

} // namespace placedpar
