#include "runtime/timer.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"

#include <algorithm>

namespace placedpar {

namespace {

struct Alarm final : Event {
    explicit Alarm(Process& p) : process(p) {}
    void happen() noexcept override { process.kernel().make_ready(process); }
    Process& process;
};

/// Returns the value of look(), or the recorded value if the process repeats a history (a log of its actions:
/// runtime/replay_log.hpp).
template <class Look>
std::int64_t seen_by(const Process& self, ReplayLog::Action what, Look look) {
    ReplayLog* history = self.history();
    return history ? history->observe(what, look) : look();
}

// The next functions serve the few processes that keep a history. They are not inlined, so that the stack frames of
// other processes stay small.

[[gnu::noinline]] Time now_as_seen(Kernel& kernel) {
    return Time{seen_by(kernel.running(), ReplayLog::Action::now, [&] {
        kernel.count_timeless_operation(Kernel::unchecked_readings);
        kernel.look_at_clock();
        return kernel.now().count();
    })};
}

/// Records a delay in the history. Returns whether the process only repeats the history, in which delays take no time.
[[gnu::noinline]] bool only_repeats(ReplayLog& history, Time due) {
    history.record(ReplayLog::Action::delay, 0, {static_cast<std::uint64_t>(due.count())});
    return history.repeats();
}

Time tick_of(const Process& self) {
    return self.executive() ? self.executive()->tick(self.priority()) : std::chrono::microseconds{1};
}

/// Returns the lowest `bits` bits of a number as a signed word.
std::int32_t as_word(std::int64_t number, int bits) {
    int above = 64 - bits;
    return static_cast<std::int32_t>(static_cast<std::int64_t>(static_cast<std::uint64_t>(number) << above) >> above);
}

} // namespace

namespace {

inline Time now(Kernel& kernel) {
    if (kernel.keeps_histories()) [[unlikely]]
        return now_as_seen(kernel);
    kernel.count_timeless_operation(Kernel::unchecked_readings);
    kernel.look_at_clock();
    return kernel.now();
}

inline void wait_until(Kernel& kernel, Time due, const SourceLocation& where) {
    Process& self = kernel.running();
    if (ReplayLog* history = kernel.begin_operation(self); history && only_repeats(*history, due)) [[unlikely]]
        return;
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

} // namespace

Time now() { return now(Kernel::here()); }

void wait_until(Time due, const SourceLocation& where) { wait_until(Kernel::here(), due, where); }

void wait_for(Time how_long, const SourceLocation& where) {
    Kernel& kernel = Kernel::here();
    wait_until(kernel, later(now(kernel), how_long), where);
}

void wait_until_work_is_over(const SourceLocation& where) {
    Kernel& kernel = Kernel::here();
    if (ReplayLog* history = kernel.begin_operation(kernel.running())) {
        history->record(ReplayLog::Action::after_work, 0);
        if (history->repeats())
            return;
    }
    kernel.after_work(kernel.running());
    kernel.running().wait_for(Activity::after_work, nullptr, where);
}

Time Timer::tick() const {
    const Process& self = Kernel::here().running();
    return Time{seen_by(self, ReplayLog::Action::tick, [&] { return tick_of(self).count(); })};
}

int Timer::bits() const {
    const Process& self = Kernel::here().running();
    return static_cast<int>(seen_by(self, ReplayLog::Action::bits, [&] {
        return self.executive() ? 8 * self.executive()->costs().bytes_in_a_word : 32;
    }));
}

std::int32_t Timer::read() const {
    Process& self = Kernel::here().running();
    return static_cast<std::int32_t>(seen_by(self, ReplayLog::Action::timer, [&] {
        charge(self, &OperationCosts::timer_read);
        return as_word(now() / tick(), bits());
    }));
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
    return times(since_start + to_come + 1, tick()); // at most half of the clock's range
}

void Timer::wait_after(std::int32_t ticks, const SourceLocation& where) const {
    Kernel& kernel = Kernel::here();
    if (ReplayLog* history = kernel.begin_operation(kernel.running()))
        history->record(ReplayLog::Action::timer_wait, static_cast<std::uint32_t>(ticks));
    Time moment = moment_after(ticks);
    bool has_to_wait = moment > now();
    if (has_to_wait)
        charge(kernel.running(), &OperationCosts::timer_wait);
    if (!has_to_wait || moment > now())
        wait_until(moment, where);
}

} // namespace placedpar
