#include "runtime/alternation.hpp"

#include "runtime/instructions.hpp"
#include "runtime/kernel.hpp"
#include "runtime/processor.hpp"

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

/// What enbc, enbt and their likes, altwt, and the disabling instructions come to.
Cycles cost(std::size_t guards, bool has_to_wait) {
    using namespace instructions;
    return alt_start_and_end + static_cast<std::int64_t>(guards) * (enable_guard + disable_guard) +
           (has_to_wait ? alt_wait : alt_wait_ready);
}

/// A process that polls costs no time when it is not placed: without this nobody else would ever run.
void give_others_a_turn(Process& self, const SourceLocation& where) {
    self.kernel().make_ready(self);
    self.wait_for(Activity::ready, nullptr, where);
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

std::size_t select(std::span<const Guard> guards, const SourceLocation& where) {
    Process& self = Kernel::current()->running();
    for (const Guard& guard : guards)
        if (guard.kind == Guard::input)
            guard.channel->note_inputter(self);
    auto ready = first_ready(guards);
    compute(cost(guards.size(), !ready));
    if (!ready)
        ready = first_ready(guards); // time may have passed while enabling
    if (!ready) {
        auto channels = awaited_channels(guards);
        auto timeout = earliest_timeout(guards);
        if (channels.empty() && !timeout)
            throw std::logic_error("process " + self.path() + ": an alternation none of whose guards can be ready");
        Alternation alternation(self, channels);
        alternation.enable(timeout);
        self.wait_for(Activity::alternating, {channels.data(), channels.size()}, where);
        ready = first_ready(guards);
    }
    if (guards[*ready].kind == Guard::skip && !self.processor())
        give_others_a_turn(self, where);
    return *ready;
}

} // namespace placedpar
