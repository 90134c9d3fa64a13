#pragma once

#include "runtime/byte_form.hpp"
#include "runtime/carrier.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/packed_form.hpp"
#include "runtime/process.hpp"
#include "runtime/protocol.hpp"
#include "runtime/same_message.hpp"
#include "runtime/source_location.hpp"

#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace placedpar {

/// A listener is called when a message begins to wait in a channel. An ALT listens to its channels. A communication
/// that may be given up (runtime/recovery.hpp) listens to the channel whose message ends it.
class Listener {
public:
    /// Called when a message begins to wait in the channel while no process is inputting from the channel.
    virtual void message_announced() = 0;

protected:
    ~Listener() = default;
};

/// An observer is called when a communication that may be given up has begun.
class AttemptObserver {
public:
    virtual void entered() = 0;

protected:
    ~AttemptObserver() = default;
};

/// A channel of any protocol. The channel is synchronous and unbuffered, and leads from one process to one other
/// process. A process is "in" the channel from the beginning to the end of its output or input.
///
/// On a soft channel, within one processor, the process that arrives second copies the message and continues, and the
/// first process is made ready. On a hard channel a carrier, such as a link or a bus, transfers the message.
///
/// 1. A channel is put on a carrier before its first use, or never.
/// 2. Each end belongs to one process at the outermost level, that is, not a component of a PAR. Components of this
/// process's PARs may use the end one after another, but not two components of one PAR. Other uses throw
/// std::logic_error.
/// 3. If the two processes are on different executives (processors), the channel throws std::logic_error without a
/// carrier.
/// 4. A channel belongs to one simulation and outlives the simulation's run.
class AnyChannel {
public:
    /// A process that used an end of a channel. `process` dangles once the process has ended; `outermost` stays valid.
    struct User {
        const Process* process = nullptr;
        const Process* outermost = nullptr;
        std::uint32_t ordinal = no_process; ///< number of the process, unique in its simulation
        static constexpr std::uint32_t no_process = 0xffffffff;
    };

    explicit AnyChannel(std::string name) : name_(std::move(name)), identity_(new_identity(name_)) {}
    /// Makes a hard channel, occam's PLACE ... AT: `Channel<int> there("there", link.from_a_to_b())`. REQUIRES: the
    /// carrier outlives the channel.
    AnyChannel(std::string name, Carrier& on) : AnyChannel(std::move(name)) { put_on(on); }
    virtual ~AnyChannel() = default;
    AnyChannel(const AnyChannel&) = delete;
    AnyChannel& operator=(const AnyChannel&) = delete;

    const std::string& name() const { return name_; }
    /// Returns a number that identifies the channel in every run, for logs of actions (runtime/replay_log.hpp).
    /// REQUIRES: channels made before the run have different names.
    std::uint64_t identity() const { return identity_; }
    virtual std::type_index protocol() const = 0;
    /// Makes the channel hard. Throws std::logic_error while a process is in the channel. REQUIRES: no process has used
    /// the channel yet; the carrier outlives the channel.
    void put_on(Carrier&);

    /// Return the process that used this end last, or null. The pointer is valid only while this process is in the
    /// channel.
    const Process* outputter() const { return outputter_.process; }
    const Process* inputter() const { return inputter_.process; }
    /// Return the last user of the end. This process may have ended.
    const User& last_outputter() const { return outputter_; }
    const User& last_inputter() const { return inputter_; }
    /// Declare the process that will use an end. A deadlock report can then name this process even before its first
    /// communication. Throw std::logic_error if another process owns the end. REQUIRES: the process exists until the
    /// end of the simulation.
    void expect_outputter(const Process&);
    void expect_inputter(const Process&);

    // The next functions are for ALTs.
    /// Returns whether a message waits to be input.
    bool message_waits() const { return carrier_ ? carrier_->message_waits(*this) : message_ != nullptr; }
    /// Reserves the waiting message for the next input. Returns false if its sender has given up the message.
    bool keep_message() { return !carrier_ || carrier_->keep_message(*this); }
    /// Records that an ALT of the process has a guard on the channel. Throws std::logic_error if the process does not
    /// own the input end.
    void own_input(const Process& process) {
        own(inputter_, process, "inputs from");
        if (input_out_of_order_)
            refuse_unreset(process, "inputs from");
    }
    /// Sets whether an ALT has a guard on the channel. Meanwhile no other process may use the input end.
    void note_guard(bool there) { inputter_inside_ = there; }
    void enable(Listener& listener) { listener_ = &listener; }
    void disable() { listener_ = nullptr; }

    // The next functions are for attempts, that is, communications that may be given up (runtime/recovery.hpp).
    /// Set the observer of the next output (input); null removes the observer. Throw std::logic_error if the channel's
    /// carrier cannot give up a message.
    void attempt_output(AttemptObserver*);
    void attempt_input(AttemptObserver*);
    /// Let the process in output (input) continue without the message. Return false if the message has already been
    /// transferred.
    bool give_up_output();
    bool give_up_input();
    /// Clear the end after a message was given up. Return how many bytes of the message were transferred, always 0 on a
    /// soft channel. Throw std::logic_error if the running process does not own the end, or if a process uses it now.
    std::uint64_t reset_output();
    std::uint64_t reset_input();

    // The next functions are for reports.
    /// Return whether a process is in output (input) and its message has not been transferred.
    bool output_waits() const { return message_ != nullptr; }
    bool input_waits() const { return slot_ != nullptr; }

    /// Return whether the process in output (input) can never continue. A part of the message was lost, or one of the
    /// two processes has given up the message.
    bool output_is_lost() const { return carrier_ && carrier_->output_is_lost(*this); }
    bool input_is_lost() const { return carrier_ && carrier_->input_is_lost(*this); }
    /// Return whether the other end has given up the message in the middle. This end then waits until it, too, gives up
    /// the message and is reset.
    bool output_must_be_reset() const { return carrier_ && carrier_->output_must_be_reset(*this); }
    bool input_must_be_reset() const { return carrier_ && carrier_->input_must_be_reset(*this); }
    /// Returns the other channels of a broadcast that keep the outputting process waiting (Carrier::held_up_by).
    std::vector<const AnyChannel*> held_up_by() const {
        return carrier_ ? carrier_->held_up_by(*this) : std::vector<const AnyChannel*>{};
    }

    /// Returns the name of the device that uses one end in place of a process; "" if processes use both ends.
    std::string partner_device() const { return carrier_ ? carrier_->partner_device() : ""; }

    /// Describes a packet that is the current message of this channel between two routers. `channel` is the user's
    /// channel to which the packet belongs; null for a message that is not a packet. `acknowledges`: the packet is an
    /// acknowledge.
    struct PacketPayload {
        const AnyChannel* channel = nullptr;
        bool acknowledges = false;
    };
    const PacketPayload& payload() const { return payload_; }
    void carries(const PacketPayload& payload) { payload_ = payload; }

    // The next functions are for carriers.
    /// Hands the outputter's message to the inputter. REQUIRES: both processes are in the channel.
    void hand_over();
    /// Hands the message of another channel to the inputter of this channel. The two objects are the ends of one
    /// channel between two threads of a native run. REQUIRES: both channels have the same protocol; a process is in
    /// output on `other`; a process is in input on this channel.
    void take_from(AnyChannel& other);
    /// Returns how messages of the protocol are written as bytes for a transputer's own code; null if they cannot be.
    virtual const AnyByteForm* byte_form() const = 0;
    /// Returns the outputter's message as bytes. REQUIRES: byte_form() is not null; a process is in output.
    MessageBytes message_in_bytes() const;
    /// Tells the trace that another thread of a native run has taken the outputter's message. REQUIRES: a process is in
    /// output.
    void tell_taken_elsewhere() const {
        if (const Kernel& kernel = outputter_.process->kernel(); kernel.trace())
            tell_trace(kernel);
    }
    /// Notes in the fingerprint and the trace that a device has taken the outputter's message. REQUIRES: a process is
    /// in output.
    void note_taken_by_device() { note_communication(outputter_.process->kernel()); }
    /// Hands a device's message to the inputter. Throws NoMessage if the bytes are not a message of the protocol.
    /// REQUIRES: the bytes are complete (ByteForm::next_part returns 0); a process is in input.
    void hand_over(std::span<const std::uint8_t> bytes);
    /// Returns the functions that pack messages as bytes for another copy of this program; null if messages of the
    /// protocol cannot be packed.
    virtual const AnyPackedForm* packed_form() const = 0;
    /// Appends the outputter's message in packed form. REQUIRES: packed_form() is not null; a process is in output.
    void pack_message(MessageBytes& to) const { packed_form()->write(message_, to); }
    /// Hands a packed message to the inputter. Throws NoMessage if the bytes are damaged. REQUIRES: packed_form() is
    /// not null; a process is in input.
    void hand_over_packed(std::span<const std::uint8_t> bytes);
    /// Returns whether the next input may be given up.
    bool is_attempted_input() const { return input_attempt_ != nullptr; }
    /// Returns whether the messages that wait in both channels are equal. Returns nothing if messages of this protocol
    /// cannot be compared. REQUIRES: a process is outputting on each of the two channels.
    std::optional<bool> has_message_of(const AnyChannel& other) const {
        return protocol() == other.protocol() ? are_same(message_, other.message_) : false;
    }
    /// Tells the listener that a message begins to wait.
    void announce() {
        if (listener_)
            listener_->message_announced();
    }

protected:
    // The steps of output and input. If the partner waits in a soft channel, the process copies the message and
    // completes the communication. Otherwise, and on a hard channel, the process waits.

    void begin_output(Process& self, const WireForm& form) {
        if (ReplayLog* history = self.kernel().begin_operation(self)) [[unlikely]]
            note_output(*history, form);
        if (const OperationCosts* costs = soft_costs(self))
            begin(self, costs->is_one_word(form) ? costs->soft_word_output : costs->soft_communication);
        own(outputter_, self, "outputs to");
    }
    void begin_input(Process& self) {
        if (ReplayLog* history = self.kernel().begin_operation(self)) [[unlikely]]
            note_input(*history);
        if (const OperationCosts* costs = soft_costs(self))
            begin(self, costs->soft_communication);
        own(inputter_, self, "inputs from");
    }
    /// Return the partner's slot (message) if the partner waits in a soft channel, or null otherwise.
    void* soft_slot(const Process& self) const {
        if (is_particular_) [[unlikely]]
            return soft_partner(self, slot_, output_out_of_order_, output_attempt_, "outputs to");
        return slot_;
    }
    void* soft_message(const Process& self) const {
        if (is_particular_) [[unlikely]]
            return soft_partner(self, message_, input_out_of_order_, input_attempt_, "inputs from");
        return message_;
    }
    /// Records in the fingerprint and in the trace that the second process has arrived at a soft channel. Throws
    /// std::logic_error if the two processes are on different executives.
    void meet(Process& self) {
        const Executive *own = self.executive(), *other = waiting_->executive();
        if (own != other && own && other) [[unlikely]]
            refuse_without_carrier(self, *waiting_);
        note_communication(self.kernel());
    }
    /// Complete the communication for the second process, which has copied the message. The process computes for the
    /// cycles of the copy, and then its partner continues. During the copy no other process may use this process's end.
    /// The cost of an output of one word already includes the copy.
    void part_from_inputter(Process& self, const WireForm& form) {
        const Executive* executive = self.executive();
        bool pays = executive && !executive->costs().is_one_word(form);
        part(self, outputter_inside_, pays ? executive->costs().copy(form.total()) : Cycles{0});
    }
    void part_from_outputter(Process& self) {
        const Executive* executive = self.executive();
        part(self, inputter_inside_, executive ? executive->costs().copy(waiting_form_->total()) : Cycles{0});
    }
    void wait_to_output(Process& self, void* message, const WireForm& form, const SourceLocation& where) {
        Inside inside(outputter_inside_, &message_, message);
        if (is_particular_) [[unlikely]] {
            if (output_attempt_)
                output_attempt_->entered();
            if (carrier_)
                return carrier_->output(*this, form, where);
        }
        waiting_ = &self;
        waiting_form_ = &form;
        announce();
        self.wait_for(Activity::outputting, this, where);
    }
    void wait_to_input(Process& self, void* slot, const SourceLocation& where) {
        Inside inside(inputter_inside_, &slot_, slot);
        if (is_particular_) [[unlikely]] {
            if (input_attempt_)
                input_attempt_->entered();
            if (carrier_)
                return carrier_->input(*this, where);
        }
        waiting_ = &self;
        self.wait_for(Activity::inputting, this, where);
    }

private:
    static std::uint64_t new_identity(const std::string& name);
    /// Marks an end of the channel as in use, as long as the object exists. During this time `*place` holds the address
    /// of the process's message, or of its slot for a message.
    class Inside {
    public:
        explicit Inside(bool& flag, void** place = nullptr, void* mine = nullptr) : flag_(flag), place_(place) {
            flag_ = true;
            if (place_)
                *place_ = mine;
        }
        ~Inside() {
            flag_ = false;
            if (place_)
                *place_ = nullptr;
        }
        Inside(const Inside&) = delete;
        Inside& operator=(const Inside&) = delete;

    private:
        bool& flag_;
        void** place_;
    };

    virtual void move_message(void* from, void* to) = 0;
    virtual std::optional<bool> are_same(const void* message, const void* other) const = 0;

    void note_output(ReplayLog&, const WireForm&) const;
    void note_input(ReplayLog&) const;
    /// Returns the costs of the process's operations on the channel; null without an executive or with a carrier.
    const OperationCosts* soft_costs(const Process& self) const {
        const Executive* executive = self.executive();
        return executive && !carrier_ ? &executive->costs() : nullptr;
    }
    static void begin(Process& self, Cycles cost) { self.compute(cost, {}); }
    void own(User& end, const Process& process, const char* verb) {
        if (end.ordinal != process.ordinal()) [[unlikely]]
            change_owner(end, process, verb);
    }
    void change_owner(User& end, const Process&, const char* verb);
    void* soft_partner(const Process& self, void* partner, bool out_of_order, AttemptObserver* attempt,
                       const char* verb) const {
        if (out_of_order)
            refuse_unreset(self, verb);
        if (carrier_)
            return nullptr;
        if (partner && attempt)
            attempt->entered();
        return partner;
    }
    void note_particulars();
    void part(Process& self, bool& inside, Cycles cost) {
        message_ = slot_ = nullptr;
        Process& partner = *waiting_;
        if (cost > Cycles{0}) {
            Inside still(inside);
            self.compute(cost, {});
        }
        self.kernel().make_ready(partner);
    }
    void note_communication(Kernel& kernel) {
        kernel.fingerprint().mix(static_cast<std::uint64_t>(kernel.now().count()));
        kernel.fingerprint().mix(std::uint64_t{outputter_.ordinal} << 32 | inputter_.ordinal);
        if (kernel.trace())
            tell_trace(kernel);
    }
    void tell_trace(const Kernel&) const;
    [[noreturn]] void refuse_without_carrier(const Process& self, const Process& other) const;
    [[noreturn]] void refuse_unreset(const Process& self, const char* verb) const;

    // The first members are needed for each communication, so they share cache lines.
    Carrier* carrier_ = nullptr;             ///< null if the channel is soft
    void* message_ = nullptr;                ///< set while an outputter is in the channel
    void* slot_ = nullptr;                   ///< set while an inputter is in the channel
    Process* waiting_ = nullptr;             ///< on a soft channel, the process that arrived first
    const WireForm* waiting_form_ = nullptr; ///< form of the waiting process's message, if the process outputs
    Listener* listener_ = nullptr;           ///< set by an ALT, or by an attempt that a message in this channel ends
    bool is_particular_ = false;             ///< the channel is hard, or a communication on it may be given up
    bool outputter_inside_ = false;          ///< a process is in output
    bool inputter_inside_ = false;           ///< a process is in input, or has a guard on the channel
    bool output_out_of_order_ = false;       ///< a message was given up at the output end, so the end must be reset
    bool input_out_of_order_ = false;
    User outputter_, inputter_;

    // The next members are needed rarely.
    AttemptObserver* output_attempt_ = nullptr; ///< null if the outputter waits without limit
    AttemptObserver* input_attempt_ = nullptr;
    PacketPayload payload_;
    std::string name_;
    std::uint64_t identity_;
};

template <class T>
class Channel;

namespace detail {

/// True if an implicit conversion would lose information: from a floating-point number to an integer, or from a pointer
/// to bool.
template <class From, class To>
concept Loses = (std::floating_point<From> && std::integral<To>) || (std::is_pointer_v<From> && std::same_as<To, bool>);

} // namespace detail

/// Throws std::logic_error for a default-constructed end, which belongs to no channel.
[[noreturn]] void refuse_end_without_channel();

/// The end that can output: occam's `c ! x`.
template <class T>
class Output {
public:
    Output() = default;
    void output(T message, const SourceLocation& where = SourceLocation::current()) const {
        own().output(std::move(message), where);
    }
    /// Deleted, because the conversion would lose information: a REAL is not a message of a CHAN OF INT.
    template <detail::Loses<T> Other>
    void output(Other, const SourceLocation& = SourceLocation::current()) const = delete;
    AnyChannel& channel() const { return own(); }
    explicit operator bool() const { return channel_ != nullptr; }

private:
    friend class Channel<T>;
    explicit Output(Channel<T>& channel) : channel_(&channel) {}
    Channel<T>& own() const { return channel_ ? *channel_ : (refuse_end_without_channel(), *channel_); }
    Channel<T>* channel_ = nullptr;
};

/// The end that can input: occam's `c ? x`.
template <class T>
class Input {
public:
    Input() = default;
    T input(const SourceLocation& where = SourceLocation::current()) const { return own().input(where); }
    /// Inputs a message into the slot. If the message is given up (runtime/recovery.hpp), the slot stays empty.
    void input_into(std::optional<T>& slot, const SourceLocation& where) const { own().input_into(slot, where); }
    AnyChannel& channel() const { return own(); }
    explicit operator bool() const { return channel_ != nullptr; }

private:
    friend class Channel<T>;
    explicit Input(Channel<T>& channel) : channel_(&channel) {}
    Channel<T>& own() const { return channel_ ? *channel_ : (refuse_end_without_channel(), *channel_); }
    Channel<T>* channel_ = nullptr;
};

/// An end of a channel of any protocol. Simulation::process takes such ends to declare which process will use them.
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

/// A channel of messages of type T: occam's `CHAN OF T`.
template <class T>
class Channel final : public AnyChannel {
    static_assert(Protocol<T>,
                  "a message must have a fixed size, or wire_form() const must return its form on a wire; moving it "
                  "must not throw; it must not be a pointer, a reference or a view, since processes share no memory");

public:
    using AnyChannel::AnyChannel;

    Output<T> out() & { return Output<T>(*this); }
    Input<T> in() & { return Input<T>(*this); }
    /// Deleted, because a temporary channel is destroyed at the end of the statement, so its ends would dangle.
    Output<T> out() && = delete;
    Input<T> in() && = delete;
    std::type_index protocol() const override { return typeid(T); }

private:
    friend class Output<T>;
    friend class Input<T>;

    void output(T message, const SourceLocation& where) {
        const WireForm form = wire_form(message);
        Process& self = Kernel::here().running();
        begin_output(self, form);
        if (void* slot = soft_slot(self)) {
            meet(self);
            copy(&message, slot);
            part_from_inputter(self, form);
        } else {
            wait_to_output(self, &message, form, where);
        }
    }
    void input_into(std::optional<T>& slot, const SourceLocation& where) {
        Process& self = Kernel::here().running();
        begin_input(self);
        if (void* message = soft_message(self)) {
            meet(self);
            copy(message, &slot);
            part_from_outputter(self);
        } else {
            wait_to_input(self, &slot, where);
        }
    }
    T input(const SourceLocation& where) {
        std::optional<T> slot;
        input_into(slot, where);
        return std::move(*slot);
    }
    static void copy(void* message, void* slot) {
        static_cast<std::optional<T>*>(slot)->emplace(std::move(*static_cast<T*>(message)));
    }
    void move_message(void* from, void* to) override { copy(from, to); }
    const AnyByteForm* byte_form() const override { return byte_form_of<T>(); }
    const AnyPackedForm* packed_form() const override { return packed_form_of<T>(); }
    std::optional<bool> are_same(const void* message, const void* other) const override {
        return SameMessage<T>::of(*static_cast<const T*>(message), *static_cast<const T*>(other));
    }
};

} // namespace placedpar
