#pragma once

#include "runtime/carrier.hpp"
#include "runtime/protocol.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <typeindex>
#include <utility>

namespace placedpar {

class Alternation;
class Process;

/// A channel of any protocol: synchronous, unbuffered, from one process to one other.
///
/// The processes at its ends do not know whether it is soft or hard. On a soft channel the process that arrives second
/// copies the message and goes on, and the first is made ready. On a hard channel a carrier takes the message along a
/// link.
///
/// 1. It is put on a carrier, if at all, before it is used.
/// 2. Each end has one owner: a process at the outermost level with the components of its PARs, one after the other.
///    When another one uses the end, or two components of one PAR do, it throws std::logic_error.
/// 3. Processes on two executives need a carrier between them; without one it throws std::logic_error.
/// 4. It belongs to one simulation and outlives its run.
class AnyChannel {
public:
    /// A process that used an end of a channel. It may have ended since, and its object be gone; its outermost
    /// ancestor's object lasts until the end of the simulation.
    struct User {
        const Process* process = nullptr;
        const Process* outermost = nullptr;
        std::uint32_t ordinal = 0; ///< of the process, by which to find out whether it still lives
    };

    explicit AnyChannel(std::string name) : name_(std::move(name)) {}
    virtual ~AnyChannel() = default;
    AnyChannel(const AnyChannel&) = delete;
    AnyChannel& operator=(const AnyChannel&) = delete;

    const std::string& name() const { return name_; }
    virtual std::type_index protocol() const = 0;
    /// Makes the channel hard. Throws std::logic_error while a process is in it. REQUIRES: no process has used it
    /// yet; the carrier outlives it.
    void put_on(Carrier&);

    /// The process that used this end last, null if none did. It may only be looked at while it is in the channel.
    const Process* outputter() const { return outputter_.process; }
    const Process* inputter() const { return inputter_.process; }
    /// The same, for when it may have ended.
    const User& last_outputter() const { return outputter_; }
    const User& last_inputter() const { return inputter_; }
    /// Says beforehand which process will use an end, so that a deadlock before its first communication can name it.
    /// Throws std::logic_error when it is another's already. REQUIRES: it exists until the end of the simulation.
    void expect_outputter(const Process&);
    void expect_inputter(const Process&);

    // For alternations.
    /// Whether an input would find a message.
    bool message_waits() const { return carrier_ ? carrier_->message_waits(*this) : message_ != nullptr; }
    /// The process has a guard on the channel. Throws std::logic_error when it does not own the end.
    void own_input(const Process&);
    /// From now on a message wakes the alternation.
    void enable(Alternation& alternation) { alternation_ = &alternation; }
    void disable() { alternation_ = nullptr; }

    // For reports.
    /// A process is in the channel to output (input), and the message has not come over.
    bool output_waits() const { return message_ != nullptr; }
    bool input_waits() const { return slot_ != nullptr; }

    // For carriers.
    /// Hands the outputter's message to the inputter. REQUIRES: both are in the channel.
    void hand_over();
    /// A message waits for which no process has asked: wakes the alternation that is enabled, if any.
    void announce();

protected:
    void output_any(void* message, const WireForm&, const SourceLocation&);
    void input_any(void* slot, const SourceLocation&);

private:
    virtual void move_message(void* from, void* to) = 0;
    void output_soft(Process&, const WireForm&, const SourceLocation&);
    void input_soft(Process&, const SourceLocation&);

    std::string name_;
    Carrier* carrier_ = nullptr; ///< null if the channel is soft
    User outputter_, inputter_;
    void* message_ = nullptr;            ///< set while an outputter is in the channel
    void* slot_ = nullptr;               ///< set while an inputter is
    Process* waiting_ = nullptr;         ///< on a soft channel, the first to arrive
    WireForm waiting_form_{0};           ///< of its message, if it is the outputter
    Alternation* alternation_ = nullptr; ///< of an inputter that sleeps on several channels
};

template <class T>
class Channel;

/// Throws std::logic_error: an end that was made by itself belongs to no channel.
[[noreturn]] void refuse_end_without_channel();

/// occam's `c ! x`: the only end that can output.
template <class T>
class Output {
public:
    Output() = default;
    void output(T message, const SourceLocation& where = SourceLocation::current()) const {
        own().output(std::move(message), where);
    }
    AnyChannel& channel() const { return own(); }
    explicit operator bool() const { return channel_ != nullptr; }

private:
    friend class Channel<T>;
    explicit Output(Channel<T>& channel) : channel_(&channel) {}
    Channel<T>& own() const { return channel_ ? *channel_ : (refuse_end_without_channel(), *channel_); }
    Channel<T>* channel_ = nullptr;
};

/// occam's `c ? x`: the only end that can input.
template <class T>
class Input {
public:
    Input() = default;
    T input(const SourceLocation& where = SourceLocation::current()) const { return own().input(where); }
    AnyChannel& channel() const { return own(); }
    explicit operator bool() const { return channel_ != nullptr; }

private:
    friend class Channel<T>;
    explicit Input(Channel<T>& channel) : channel_(&channel) {}
    Channel<T>& own() const { return channel_ ? *channel_ : (refuse_end_without_channel(), *channel_); }
    Channel<T>* channel_ = nullptr;
};

/// An end of a channel of any protocol, as a process declares that it will use it.
class DeclaredEnd {
public:
    template <class T>
    DeclaredEnd(const Output<T>& end) : channel_(end.channel()), expect_(&AnyChannel::expect_outputter) {}
    template <class T>
    DeclaredEnd(const Input<T>& end) : channel_(end.channel()), expect_(&AnyChannel::expect_inputter) {}

    void expect(const Process& process) const { (channel_.*expect_)(process); }

private:
    AnyChannel& channel_;
    void (AnyChannel::*expect_)(const Process&);
};

/// occam's `CHAN OF T`.
template <class T>
class Channel final : public AnyChannel {
public:
    using AnyChannel::AnyChannel;

    Output<T> out() { return Output<T>(*this); }
    Input<T> in() { return Input<T>(*this); }
    std::type_index protocol() const override { return typeid(T); }

private:
    friend class Output<T>;
    friend class Input<T>;

    void output(T message, const SourceLocation& where) { output_any(&message, wire_form(message), where); }
    T input(const SourceLocation& where) {
        std::optional<T> slot;
        input_any(&slot, where);
        return std::move(*slot);
    }
    void move_message(void* from, void* to) override {
        static_cast<std::optional<T>*>(to)->emplace(std::move(*static_cast<T*>(from)));
    }
};

} // namespace placedpar
