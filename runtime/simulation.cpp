#include "runtime/simulation.hpp"

#include "runtime/surroundings.hpp"

namespace placedpar {

namespace {

std::vector<std::string> who_never_ran(const Kernel& kernel) {
    std::vector<std::string> paths;
    for (const Process* process : kernel.living())
        if (!process->has_begun())
            paths.push_back(process->path());
    return paths;
}

Deadlock deadlock_of(const Kernel& kernel) {
    return kernel.surroundings() ? find_deadlock(kernel.surroundings()->kernels()) : find_deadlock(kernel);
}

} // namespace

Simulation::~Simulation() {
    processes_.clear();
    while (!devices_.empty())
        devices_.pop_back();
}

Process& Simulation::process(std::string name, Process::Body body, Executive* on, Priority priority) {
    Process& process = processes_.emplace_back(kernel_, std::move(name), std::move(body), on, priority);
    kernel_.start(process);
    return process;
}

Process& Simulation::process(std::string name, const std::vector<DeclaredEnd>& ends, Process::Body body, Executive* on,
                             Priority priority) {
    Process& process = this->process(std::move(name), std::move(body), on, priority);
    for (const DeclaredEnd& end : ends)
        end.expect(process);
    return process;
}

RunResult Simulation::run(Time limit, const std::function<void()>& work_over) {
    RunResult result;
    Kernel::Observer observer;
    observer.work_over = [&] {
        result.time = kernel_.now();
        work_over();
    };
    observer.run_over = [&](Ending ending) {
        if (ending == Ending::stuck)
            result.deadlock = deadlock_of(kernel_);
        else if (ending != Ending::completed && !kernel_.surroundings())
            result.deadlock = find_partial_deadlock(kernel_);
        result.never_ran = who_never_ran(kernel_);
    };
    result.ending = kernel_.run(limit, std::move(observer));
    result.fingerprint = kernel_.fingerprint().value();
    result.events = kernel_.future().happened();
    return result;
}

} // namespace placedpar
