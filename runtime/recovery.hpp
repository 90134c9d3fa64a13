#pragma once

#include "runtime/channel.hpp"
#include "runtime/event.hpp"
#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <optional>
#include <utility>

namespace placedpar {

// How a program survives a link that fails, in the words of the libraries of the INMOS toolsets: InputOrFail and
// OutputOrFail, with a time-out (.t) or with a channel whose message ends the attempt (.c), and Reinitialise; in C
// ChanInTimeFail, ChanOutTimeFail, ChanInChanFail, ChanOutChanFail and ChanReset.
//
// 1. A channel may be soft, or hard and alone on its direction of a link, at whose end a link adapter may be. A channel
//    that travels in packets throws std::logic_error, as the toolset does for virtual channels. So does a broadcast
//    channel, and one through the memory of a bus master.
// 2. A message that was given up is never received later. However, a message that the sender gave up may already have
//    been received, if only the acknowledge of its last byte was lost.
// 3. If a message was given up at an end of a hard channel, that end must be reset before it is used again; otherwise
//    it throws std::logic_error. If this was in the middle of a message, the other end must be reset as well; until
//    then nothing is transferred.
// 4. A soft channel keeps nothing of the message, and a reset changes nothing.
// 5. An attempt costs the communication's usual cycles and OperationCosts::attempt; a reset costs
//    OperationCosts::reset_channel.

/// One communication that may be given up, by the running process on its stack.
class Attempt final : Event, Listener, AttemptObserver {
public:
    enum class End { output, input };
    /// Charges for the attempt. Throws std::logic_error when the channel cannot give up a message.
    Attempt(AnyChannel&, End);
    ~Attempt();
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;

    /// Sets the time at which the attempt is given up. If the deadline has passed, the attempt is given up as soon as
    /// nothing else can happen at the current instant.
    void until(Time deadline) { deadline_ = deadline; }
    /// Gives up the attempt when a message waits in `failure`.
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

/// Outputs the message; returns whether it was sent and acknowledged before the deadline.
template <class T>
bool output_or_fail(Output<T> to, T message, Time deadline, const SourceLocation& where = SourceLocation::current()) {
    Attempt attempt(to.channel(), Attempt::End::output);
    attempt.until(deadline);
    to.output(std::move(message), where);
    return !attempt.failed();
}

/// Outputs the message; returns whether it was sent before a message came from `failure`. The message from `failure` is
/// input if it ends the attempt.
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

/// Inputs a message; returns whether it was received before the deadline. If not, `message` is unchanged.
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

/// Inputs a message; returns whether it was received before a message came from `failure`. If not, the message from
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

/// Reinitialise, ChanReset: makes the end of the channel ready for a next message, after one was given up there or at
/// the other end. Returns how many bytes of that message had been transferred: at an output the acknowledged bytes, at
/// an input the bytes taken; 0 on a soft channel. Throws std::logic_error when another process owns the end, or a
/// process is communicating there.
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
