#include "runtime/alternation.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace placedpar {

namespace {

bool is_ready(const Guard& guard) {
    switch (guard.kind) {
    case Guard::input: return guard.channel->message_waits();
    case Guard::timeout: return guard.due <= Kernel::here().now();
    case Guard::skip: return true;
    case Guard::never: break;
    }
    return false;
}

std::optional<std::size_t> first_ready(std::span<const Guard> guards) {
    auto found = std::ranges::find_if(guards, is_ready);
    if (found == guards.end())
        return std::nullopt;
    return found - guards.begin();
}

/// Returns the first ready guard. If this guard is an input, reserves its message, so that the sender can no longer
/// withdraw the message.
std::optional<std::size_t> first_kept(std::span<const Guard> guards) {
    auto found = std::ranges::find_if(guards, [](const Guard& guard) {
        return is_ready(guard) && (guard.kind != Guard::input || guard.channel->keep_message());
    });
    if (found == guards.end())
        return std::nullopt;
    return found - guards.begin();
}

std::optional<Time> earliest_timeout(std::span<const Guard> guards) {
    std::optional<Time> earliest;
    for (const Guard& guard : guards)
        if (guard.kind == Guard::timeout)
            earliest = std::min(earliest.value_or(guard.due), guard.due);
    return earliest;
}

std::vector<AnyChannel*> awaited_channels(std::span<const Guard> guards) {
    std::vector<AnyChannel*> channels;
    for (const Guard& guard : guards)
        if (guard.kind == Guard::input)
            channels.push_back(guard.channel);
    return channels;
}

Cycles enabling(const Guard& guard, const OperationCosts& cost) {
    if (guard.kind == Guard::timeout)
        return cost.enable_timeout;
    return is_ready(guard) ? cost.enable_guard : cost.enable_guard_not_ready;
}

/// Charges the process for the beginning of the alternation and for enabling each guard.
void charge_enabling(Process& self, std::span<const Guard> guards) {
    charge(self, [guards](const OperationCosts& cost) {
        Cycles sum = cost.alternation_start;
        for (const Guard& guard : guards)
            sum = sum + enabling(guard, cost);
        return sum;
    });
}

/// Charges the process for disabling each guard and for the end of the alternation.
void charge_disabling(Process& self, std::span<const Guard> guards) {
    charge(self, [guards](const OperationCosts& cost) {
        Cycles sum = cost.alternation_end;
        for (const Guard& guard : guards)
            sum = sum + (guard.kind == Guard::timeout ? cost.disable_timeout : cost.disable_guard);
        return sum;
    });
}

} // namespace

/// Wakes a process that sleeps until one of its guards is ready: a message waits, or a time has come. The guards are
/// enabled on their channels as long as the object exists.
class Alternation final : Event, Listener {
public:
    Alternation(Process& process, std::span<AnyChannel* const> channels) : process_(process), channels_(channels) {}
    ~Alternation() {
        for (AnyChannel* channel : channels_.first(enabled_))
            channel->disable();
    }
    void enable(std::optional<Time> timeout) {
        for (; enabled_ < channels_.size(); ++enabled_)
            channels_[enabled_]->enable(*this);
        if (timeout)
            process_.kernel().future().schedule(*this, *timeout, EventQueue::timer);
    }

private:
    void happen() noexcept override { wake(); }
    void message_announced() override { wake(); }
    /// Wakes the process. Only the first call has an effect.
    void wake() {
        if (!std::exchange(woken_, true))
            process_.kernel().make_ready(process_);
    }

    Process& process_;
    std::span<AnyChannel* const> channels_;
    std::size_t enabled_ = 0;
    bool woken_ = false;
};

/// Marks the process as the user of the channel ends in its guards, as long as the object exists. Throws
/// std::logic_error if another process owns one of the ends.
class AtGuards {
public:
    AtGuards(Process& self, std::span<const Guard> guards) : guards_(guards) {
        for (const Guard& guard : guards)
            if (guard.kind == Guard::input)
                guard.channel->own_input(self);
        note(true);
    }
    ~AtGuards() { note(false); }
    AtGuards(const AtGuards&) = delete;
    AtGuards& operator=(const AtGuards&) = delete;

private:
    void note(bool there) const {
        for (const Guard& guard : guards_)
            if (guard.kind == Guard::input)
                guard.channel->note_guard(there);
    }
    std::span<const Guard> guards_;
};

void sleep(Process& self, std::span<const Guard> guards, const SourceLocation& where) {
    auto channels = awaited_channels(guards);
    auto timeout = earliest_timeout(guards);
    if (channels.empty() && !timeout)
        throw std::logic_error("process " + self.path() + ": no guard of its alternation can ever become ready");
    Alternation alternation(self, channels);
    alternation.enable(timeout);
    self.wait_for(Activity::alternating, {channels.data(), channels.size()}, where, timeout.has_value());
}

/// Chooses a guard for select(), which records the choice in the process's history, if it keeps one.
std::size_t choose(Process& self, std::span<const Guard> guards, const SourceLocation& where) {
    AtGuards at_guards(self, guards);
    charge_enabling(self, guards);
    charge(self, first_ready(guards) ? &OperationCosts::alternation_wait_ready : &OperationCosts::alternation_wait);
    std::optional<std::size_t> ready = first_kept(guards);
    const bool has_to_sleep = !ready;
    for (; !ready; ready = first_kept(guards)) // repeated, because the sender may withdraw the message that has woken
                                               // the process
        sleep(self, guards, where);
    const std::size_t chosen = *ready;
    charge_disabling(self, guards);
    // A process without an executive polls in no virtual time. If it did not wait here, no other process would run.
    if (!has_to_sleep && !self.executive() && guards[chosen].kind != Guard::input)
        wait_until(now(), where);
    return chosen;
}

std::uint64_t what_guard_awaits(const Guard& guard) {
    switch (guard.kind) {
    case Guard::input: return guard.channel->identity();
    case Guard::timeout: return static_cast<std::uint64_t>(guard.due.count());
    case Guard::skip:
    case Guard::never: break;
    }
    return 0;
}

void note(std::span<const Guard> guards, ReplayLog& history) {
    for (const Guard& guard : guards)
        history.record(ReplayLog::Action::alternation, guards.size(),
                       {std::uint64_t{guard.kind}, what_guard_awaits(guard)});
}

std::size_t select(std::span<const Guard> guards, const SourceLocation& where) {
    Process& self = Kernel::here().running();
    ReplayLog* history = self.kernel().begin_operation(self);
    if (!history)
        return choose(self, guards, where);
    note(guards, *history);
    return static_cast<std::size_t>(history->observe(
        ReplayLog::Action::alternation, [&] { return static_cast<std::int64_t>(choose(self, guards, where)); }));
}

} // namespace placedpar
