#pragma once

#include "runtime/channel.hpp"
#include "runtime/event.hpp"
#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <optional>
#include <utility>

namespace placedpar {

// These functions let a program survive a link that fails. They follow the libraries of the INMOS toolsets. occam has
// InputOrFail and OutputOrFail, with a time-out (.t) or with a channel whose message ends the attempt (.c), and
// Reinitialise. C has ChanInTimeFail, ChanOutTimeFail, ChanInChanFail, ChanOutChanFail and ChanReset.
//
// 1. The channel may be soft, that is, within one processor. If the channel leads over a link, no other channel may use
// the same direction of the link. The link may lead to the link adapter of a host computer. For other channels the
// functions throw std::logic_error. These are broadcast channels, channels through the memory of a bus master, and
// channels that travel in packets. (The toolset refuses such virtual channels, too.)
// 2. A message that was given up is never received later. However, the receiver may already have received a message
// that the sender gives up. This happens if only the acknowledge of the last byte was lost.
// 3. If a message was given up at an end of a channel over a link, this end must be reset before its next use.
// Otherwise the next use throws std::logic_error. If a part of the message was transferred, the other end must be
// reset, too, before the channel transfers anything.
// 4. A soft channel keeps no part of a message that was given up, so a reset changes nothing.
// 5. An attempt costs the cycles of a usual communication plus OperationCosts::attempt. A reset costs
// OperationCosts::reset_channel cycles.

/// A communication of the running process that may be given up. The functions below use this class. Make an Attempt,
/// set until() or until_told_by(), then communicate on the channel. An Attempt is a local variable of the process.
class Attempt final : Event, Listener, AttemptObserver {
public:
    enum class End { output, input };
    /// Makes the running process compute for OperationCosts::attempt cycles. Throws std::logic_error if the channel
    /// cannot give up a message.
    Attempt(AnyChannel&, End);
    ~Attempt();
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;

    /// Sets the virtual time at which the attempt is given up. If this time has passed, the attempt is given up when
    /// nothing else can happen at the current instant.
    void until(Time deadline) { deadline_ = deadline; }
    /// Gives up the attempt when a message waits on `failure`.
    void until_told_by(AnyChannel& failure);
    bool failed() const { return failed_; }

private:
    void entered() override;
    void happen() noexcept override;
    void message_announced() override;

    AnyChannel& channel_;
    End end_;
    Process& process_;
    std::optional<Time> deadline_;
    AnyChannel* failure_ = nullptr;
    bool failed_ = false;
};

/// Outputs the message. Returns whether it was sent and acknowledged before the deadline.
template <class T>
bool output_or_fail(Output<T> to, T message, Time deadline, const SourceLocation& where = SourceLocation::current()) {
    Attempt attempt(to.channel(), Attempt::End::output);
    attempt.until(deadline);
    to.output(std::move(message), where);
    return !attempt.failed();
}

/// Outputs the message. Returns whether it was sent before a message came from `failure`. If not, the message from
/// `failure` is input and discarded.
template <class T, class F>
bool output_or_fail(Output<T> to, T message, Input<F> failure,
                    const SourceLocation& where = SourceLocation::current()) {
    bool failed;
    {
        Attempt attempt(to.channel(), Attempt::End::output);
        attempt.until_told_by(failure.channel());
        to.output(std::move(message), where);
        failed = attempt.failed();
    }
    if (failed)
        failure.input(where);
    return !failed;
}

/// Inputs a message. Returns whether it was received before the deadline. If not, `message` is unchanged.
template <class T>
bool input_or_fail(Input<T> from, T& message, Time deadline, const SourceLocation& where = SourceLocation::current()) {
    std::optional<T> slot;
    Attempt attempt(from.channel(), Attempt::End::input);
    attempt.until(deadline);
    from.input_into(slot, where);
    if (!attempt.failed())
        message = std::move(*slot);
    return !attempt.failed();
}

/// Inputs a message. Returns whether it was received before a message came from `failure`. If not, the message from
/// `failure` is input and discarded, and `message` is unchanged.
template <class T, class F>
bool input_or_fail(Input<T> from, T& message, Input<F> failure,
                   const SourceLocation& where = SourceLocation::current()) {
    std::optional<T> slot;
    bool failed;
    {
        Attempt attempt(from.channel(), Attempt::End::input);
        attempt.until_told_by(failure.channel());
        from.input_into(slot, where);
        failed = attempt.failed();
    }
    if (failed)
        failure.input(where);
    else
        message = std::move(*slot);
    return !failed;
}

/// Makes an end of a channel ready for the next message, after a message was given up at this or the other end
/// (Reinitialise, ChanReset). Returns how many bytes of the message were transferred: at an output the acknowledged
/// bytes, at an input the received bytes. On a soft channel returns 0. Throws std::logic_error if another process owns
/// the end, or if a process is communicating there.
std::uint64_t reset(AnyChannel&, Attempt::End);
template <class T>
std::uint64_t reset(Output<T> end) {
    return reset(end.channel(), Attempt::End::output);
}
template <class T>
std::uint64_t reset(Input<T> end) {
    return reset(end.channel(), Attempt::End::input);
}

} // namespace placedpar
