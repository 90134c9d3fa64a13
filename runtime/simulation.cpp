#include "runtime/simulation.hpp"

namespace placedpar {

Simulation::~Simulation() {
    processes_.clear();
    while (!devices_.empty())
        devices_.pop_back();
}

Process& Simulation::process(std::string name, Process::Body body, Executive* on, Priority priority) {
    Process& process = processes_.emplace_back(kernel_, std::move(name), std::move(body), on, priority);
    kernel_.make_ready(process);
    return process;
}

RunResult Simulation::run(Time limit) {
    std::optional<Deadlock> deadlock;
    Ending ending = kernel_.run(limit, [&](Ending e) {
        if (e == Ending::stuck)
            deadlock = find_deadlock(kernel_);
    });
    return {ending, kernel_.now(), kernel_.fingerprint().value(), std::move(deadlock)};
}

} // namespace placedpar
