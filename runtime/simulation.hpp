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

/// What a run returns. The run's work lasts until nothing more can happen. Processes that have called
/// wait_until_work_is_over() continue after the work, for example to test the final state.
struct RunResult {
    Ending ending = Ending::completed;
    Time time{};                   ///< virtual time at the end of the work
    std::uint64_t fingerprint = 0; ///< hash of the run's communications, with their times: equal for equal runs
    std::uint64_t events = 0;      ///< number of the machine's events; a measure of the effort of the simulation
    /// If the run ended stuck: the report of all processes that are left. If the run was stopped early: the report of
    /// those processes that would never have continued, if any.
    std::optional<Deadlock> deadlock;
    /// Names of the processes that never had a turn, in the order of their creation. Other processes occupied their
    /// processor, or a fault had halted the processor.
    std::vector<std::string> never_ran;
};

/// Holds processes and the devices on which they run, and runs them once in virtual time. A program that uses PlacedPar
/// as a library begins with this class.
///
///     Simulation simulation;
///     auto& t800 = simulation.add<hardware::Processor>("t800");
///     Channel<int> c("c");
///     simulation.process("sender", [&] { c.out().output(42); }, &t800);
///     simulation.process("receiver", [&] { c.in().input(); });
///     RunResult result = simulation.run();
///
/// 1. Devices, channels and processes are made before run(); run() is called once.
/// 2. A device may refer only to devices that were added before it, because the simulation destroys the devices in
/// reverse order. It destroys the processes before the devices.
/// 3. Channels, and all other objects to which the processes refer, must outlive run().
/// 4. All calls are made on one thread; only interrupt() may be called from another thread.
class Simulation {
public:
    Simulation() = default;
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation();

    /// Makes a device by Device(kernel, arguments...), and owns it. A device is any class that works on a kernel, such
    /// as a processor, a link, a router, or a class of the caller.
    template <class Device, class... Arguments>
    requires std::constructible_from<Device, Kernel&, Arguments...> Device& add(Arguments&&... arguments) {
        auto device = std::make_shared<Device>(kernel_, std::forward<Arguments>(arguments)...);
        devices_.push_back(device);
        return *device;
    }
    /// Adds a process that starts at the beginning of the run. `on` is its executive: the processor or other device
    /// that executes the process. Without an executive the process's computations take no time.
    Process& process(std::string name, Process::Body, Executive* on = nullptr, Priority = Priority::low);
    /// Adds a process and declares the channel ends that it will use: `simulation.process("ping", {there.out(),
    /// back.in()}, ...)`. The declaration lets a deadlock report name the partners even before their first
    /// communication. Throws std::logic_error if another process already owns one of the ends.
    Process& process(std::string name, const std::vector<DeclaredEnd>&, Process::Body, Executive* on = nullptr,
                     Priority = Priority::low);
    /// Returns the processes in the order of their creation.
    const std::list<Process>& processes() const { return processes_; }

    /// Runs ready processes in a random order, to test whether the program depends on the order: see Kernel::shuffle.
    void shuffle(std::uint64_t seed) { kernel_.shuffle(seed); }
    /// Makes run() native: processes run in real time, in several threads or programs. See Kernel::run_among.
    void run_among(Surroundings& surroundings, std::uint32_t number) { kernel_.run_among(surroundings, number); }
    /// REQUIRES: the sink outlives run().
    void trace_to(TraceSink& sink) { kernel_.trace_to(sink); }

    /// Runs until every process has ended, no process can continue, or the limit is reached. Calls `work_over` at the
    /// end of the work, so that the caller can measure the work alone. Rethrows what a process threw. Throws
    /// std::overflow_error if the next event is beyond the end of virtual time. Throws std::logic_error if another
    /// simulation is running on this thread, or if this simulation has run before.
    RunResult run(
        Time limit = Time::max(), const std::function<void()>& work_over = [] {});
    /// Returns the failure of the process whose exception run() rethrew.
    const std::optional<Failure>& who_failed() const { return kernel_.who_failed(); }
    const Kernel& kernel() const { return kernel_; }
    /// Ends the current run. May be called from a signal handler or another thread.
    void interrupt() { kernel_.interrupt(); }

private:
    Kernel kernel_;
    std::vector<std::shared_ptr<void>> devices_; ///< a shared_ptr<void> destroys the device as an object of its own
                                                 ///< class
    std::list<Process> processes_;
};

} // namespace placedpar
