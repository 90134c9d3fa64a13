#include "runtime/alternation.hpp"

#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace placedpar {

namespace {

bool is_ready(const Guard& guard) {
    switch (guard.kind) {
    case Guard::input: return guard.channel->message_waits();
    case Guard::timeout: return guard.due <= now();
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

using namespace instructions;

/// Until the process waits: alt, and enbc, enbs or enbt for each guard.
Cycles cost_of_enabling(std::span<const Guard> guards) {
    Cycles sum = alt_start;
    for (const Guard& guard : guards)
        sum = sum + (guard.kind == Guard::timeout ? enable_timeout : enable_guard);
    return sum;
}

/// Once a guard is ready: disc, diss or dist for each, and altend.
Cycles cost_of_disabling(std::span<const Guard> guards) {
    Cycles sum = alt_end;
    for (const Guard& guard : guards)
        sum = sum + (guard.kind == Guard::timeout ? disable_timeout : disable_guard);
    return sum;
}

} // namespace

/// A process that sleeps on its guards: enabled on their channels for as long as it exists.
class Alternation final : Event {
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
    /// Wakes the process, once.
    void wake() {
        if (!std::exchange(woken_, true))
            process_.kernel().make_ready(process_);
    }

private:
    void happen() noexcept override { wake(); }

    Process& process_;
    std::span<AnyChannel* const> channels_;
    std::size_t enabled_ = 0;
    bool woken_ = false;
};

void AnyChannel::announce() {
    if (alternation_)
        alternation_->wake();
}

/// Waits until a guard is ready.
void sleep(Process& self, std::span<const Guard> guards, const SourceLocation& where) {
    auto channels = awaited_channels(guards);
    auto timeout = earliest_timeout(guards);
    if (channels.empty() && !timeout)
        throw std::logic_error("process " + self.path() + ": an alternation none of whose guards can be ready");
    Alternation alternation(self, channels);
    alternation.enable(timeout);
    self.wait_for(Activity::alternating, {channels.data(), channels.size()}, where);
}

std::size_t select(std::span<const Guard> guards, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    for (const Guard& guard : guards)
        if (guard.kind == Guard::input)
            guard.channel->note_inputter(self);
    compute(cost_of_enabling(guards));
    compute(first_ready(guards) ? alt_wait_ready : alt_wait);
    bool has_to_sleep = !first_ready(guards);
    if (has_to_sleep)
        sleep(self, guards, where);
    std::size_t chosen = *first_ready(guards);
    compute(cost_of_disabling(guards));
    // Who polls and is not placed uses no time: without this nobody else would ever run.
    if (!has_to_sleep && !self.processor() && guards[chosen].kind != Guard::input)
        wait_until(now(), where);
    return chosen;
}

} // namespace placedpar
