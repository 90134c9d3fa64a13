#include "runtime/timer.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>

namespace placedpar {

namespace {

/// Wakes a process.
struct Alarm final : Event {
    explicit Alarm(Process& p) : process(p) {}
    void happen() noexcept override { process.kernel().make_ready(process); }
    Process& process;
};

} // namespace

Time now() { return Kernel::here().now(); }

void wait_until(Time due, const SourceLocation& where) {
    Kernel& kernel = Kernel::here();
    Process& self = kernel.running();
    if (self.executive() && due <= kernel.now())
        return charge(self, &OperationCosts::timer_wait_past);
    Time since = kernel.now();
    due = std::max(due, since);
    if (!self.executive() && kernel.pass_time(due))
        return self.was_delayed(since, where);
    Alarm alarm(self);
    kernel.future().schedule(alarm, due, EventQueue::timer);
    self.wait_for(Activity::delayed, nullptr, where);
}

void wait_for(Time how_long, const SourceLocation& where) { wait_until(later(now(), how_long), where); }

void wait_until_work_is_over(const SourceLocation& where) {
    Kernel& kernel = Kernel::here();
    kernel.after_work(kernel.running());
    kernel.running().wait_for(Activity::after_work, nullptr, where);
}

Time Timer::tick() const {
    const Process& self = Kernel::here().running();
    return self.executive() ? self.executive()->tick(self.priority()) : std::chrono::microseconds{1};
}

std::int32_t Timer::read() const {
    charge(Kernel::here().running(), &OperationCosts::timer_read);
    return static_cast<std::int32_t>(now() / tick());
}

Time Timer::moment_after(std::int32_t ticks) const {
    std::int64_t since_start = now() / tick();
    auto reading = static_cast<std::int32_t>(since_start);
    if (is_after(reading, ticks))
        return times(since_start, tick());
    std::int64_t to_come = static_cast<std::uint32_t>(minus(ticks, reading)); // half of a round at most
    return times(since_start + to_come + 1, tick());
}

void Timer::wait_after(std::int32_t ticks, const SourceLocation& where) const {
    Time moment = moment_after(ticks);
    bool has_to_wait = moment > now();
    if (has_to_wait)
        charge(Kernel::here().running(), &OperationCosts::timer_wait);
    if (!has_to_wait || moment > now())
        wait_until(moment, where);
}

} // namespace placedpar
