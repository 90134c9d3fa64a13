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

/// The lowest bits of a number, the highest of them its sign.
std::int32_t as_word(std::int64_t number, int bits) {
    int above = 64 - bits;
    return static_cast<std::int32_t>(static_cast<std::int64_t>(static_cast<std::uint64_t>(number) << above) >> above);
}

} // namespace

Time now() {
    Kernel& kernel = Kernel::here();
    kernel.reads_clock();
    return kernel.now();
}

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

int Timer::bits() const {
    const Process& self = Kernel::here().running();
    return self.executive() ? static_cast<int>(8 * self.executive()->costs().bytes_in_a_word) : 32;
}

std::int32_t Timer::read() const {
    charge(Kernel::here().running(), &OperationCosts::timer_read);
    return as_word(now() / tick(), bits());
}

std::int32_t Timer::plus(std::int32_t a, std::int32_t b) const { return as_word(std::int64_t{a} + b, bits()); }

std::int32_t Timer::minus(std::int32_t a, std::int32_t b) const { return as_word(std::int64_t{a} - b, bits()); }

Time Timer::moment_after(std::int32_t ticks) const {
    std::int64_t since_start = now() / tick();
    std::int32_t reading = as_word(since_start, bits());
    if (is_after(reading, ticks))
        return times(since_start, tick());
    auto round = std::uint64_t{1} << bits();
    auto to_come = static_cast<std::int64_t>(static_cast<std::uint64_t>(std::int64_t{ticks} - reading) % round);
    return times(since_start + to_come + 1, tick()); // half of a round at most
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
