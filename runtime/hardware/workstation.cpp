#include "runtime/hardware/workstation.hpp"

#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

Workstation::Workstation(Kernel& kernel, std::string name, std::int64_t clock_hz)
    : Executive(std::move(name), OperationCosts{}), kernel_(kernel), clock_hz_(clock_hz) {
    if (clock_hz <= 0)
        throw std::logic_error("workstation " + this->name() + ": its clock frequency must be positive");
}

Time Workstation::time_busy() const { return work_.scheduled() ? busy_ + (kernel_.now() - began_) : busy_; }

void Workstation::Work::happen() noexcept {
    workstation.end_work();
    workstation.kernel_.enqueue(*workstation.current_);
}

bool Workstation::begin_computing(Process& self, Cycles cycles, const CodeShape&) {
    if (cycles < Cycles{0})
        throw std::logic_error("process " + self.path() + " computes for a negative number of cycles");
    if (cycles == Cycles{0})
        return true;
    began_ = kernel_.now();
    Time end = later(began_, duration_of(static_cast<std::int64_t>(cycles), clock_hz_));
    if (TraceSink* trace = kernel_.trace())
        trace->turns(*current_, Activity::computing, began_);
    if (kernel_.pass_time(end))
        return end_work(), true;
    kernel_.future().schedule(work_, end, EventQueue::turn);
    return false;
}

void Workstation::end_work() {
    busy_ += kernel_.now() - began_;
    if (TraceSink* trace = kernel_.trace())
        trace->turns(*current_, Activity::ready, kernel_.now());
}

void Workstation::make_ready(Process& p) {
    (p.priority() == Priority::high ? high_ : low_).push_back(p);
    if (!current_)
        take_next();
}

void Workstation::leave(Process&, Process* successor) {
    current_ = nullptr;
    if (successor)
        make_ready(*successor);
    else
        take_next();
}

void Workstation::take_next() {
    current_ = kernel_.take_next(high_);
    if (!current_)
        current_ = kernel_.take_next(low_);
    if (current_)
        kernel_.enqueue(*current_);
}

} // namespace placedpar::hardware
