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
// 1. A channel may be soft. If it is hard, it must be alone on its direction of a link; a link adapter may be at the
// end of the link. A channel that travels in packets throws std::logic_error, as the toolset does for virtual channels.
// A broadcast channel and a channel through the memory of a bus master throw this exception, too.
// 2. A message that was given up is never received later. However, a message that the sender gave up may already have
// been received, if only the acknowledge of its last byte was lost.
// 3. If a message was given up at an end of a hard channel, this end must be reset before it is used again. Otherwise
// the end throws std::logic_error. If the message was partly transferred, the other end must be reset as well; until
// then nothing is transferred.
// 4. A soft channel keeps no part of a message that was given up, and a reset changes nothing.
// 5. An attempt costs the communication's usual cycles and OperationCosts::attempt. A reset costs
// OperationCosts::reset_channel.

/// A communication of the running process that may be given up. It is a local variable of the process.
class Attempt final : Event, Listener, AttemptObserver {
public:
    enum class End { output, input };
    /// Charges the running process for the attempt. Throws std::logic_error if the channel cannot give up a message.
    Attempt(AnyChannel&, End);
    ~Attempt();
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;

    /// Sets the time at which the attempt is given up. If this time has passed, the attempt is given up when nothing
    /// else can happen at the current instant.
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

/// Outputs the message. Returns whether it was sent before a message came from `failure`. If a message from `failure`
/// ends the attempt, this message is input.
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
/// `failure` is input, and `message` is unchanged.
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
/// bytes, at an input the bytes taken; 0 on a soft channel. Throws std::logic_error if another process owns the end, or
/// if a process is communicating there.
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
