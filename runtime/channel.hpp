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

/// Receives a call when a message begins to wait in a channel. Alternations are listeners. An attempt that a message in
/// another channel can end is a listener, too.
class Listener {
public:
    /// Called when a message waits in the channel and no process has asked for it.
    virtual void message_announced() = 0;

protected:
    ~Listener() = default;
};

/// Receives a call when the process of an attempt has begun its input or output.
class AttemptObserver {
public:
    virtual void entered() = 0;

protected:
    ~AttemptObserver() = default;
};

/// A channel of any protocol. It is synchronous and unbuffered, and leads from one process to one other process.
///
/// The two processes need not know whether the channel is soft or hard. On a soft channel, the process that arrives
/// second copies the message and continues, and the first process is made ready. On a hard channel, a carrier transfers
/// the message, for example over a link.
///
/// 1. A channel is put on a carrier before it is used, or never.
/// 2. Each end has one owner: a process at the outermost level. Components of its PARs may use the end one after
/// another. The channel throws std::logic_error if another process uses the end. It also throws if two components of
/// one PAR use the end, or if a component uses it while another component is still using it.
/// 3. If the two processes are on different executives, they need a carrier. Without a carrier, the channel throws
/// std::logic_error.
/// 4. A channel belongs to one simulation and outlives the simulation's run.
class AnyChannel {
public:
    /// A process that used an end of a channel. The process may have ended, and its object may be gone. The object of
    /// its outermost ancestor exists until the end of the simulation.
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
    /// Returns a number that identifies the channel in replay logs. It is different for each channel, and the same in
    /// each run. REQUIRES: channels made before the run have different names.
    std::uint64_t identity() const { return identity_; }
    virtual std::type_index protocol() const = 0;
    /// Makes the channel hard. Throws std::logic_error while a process is in the channel. REQUIRES: no process has used
    /// the channel yet; the carrier outlives the channel.
    void put_on(Carrier&);

    /// Return the last process that used this end, or null if no process has. Use the pointer only while this process
    /// is in the channel.
    const Process* outputter() const { return outputter_.process; }
    const Process* inputter() const { return inputter_.process; }
    /// Return the last user of each end. The user may have ended.
    const User& last_outputter() const { return outputter_; }
    const User& last_inputter() const { return inputter_; }
    /// Declare the process that will use an end. The report of a deadlock can then name this process even if it has not
    /// communicated yet. Throw std::logic_error if another process owns the end. REQUIRES: the process exists until the
    /// end of the simulation.
    void expect_outputter(const Process&);
    void expect_inputter(const Process&);

    // The next functions are for alternations.
    /// Returns whether an input would find a message.
    bool message_waits() const { return carrier_ ? carrier_->message_waits(*this) : message_ != nullptr; }
    /// Reserves the waiting message for the next input. Returns false if the message was given up.
    bool keep_message() { return !carrier_ || carrier_->keep_message(*this); }
    /// Records that the process has a guard on the channel. Throws std::logic_error if the process does not own the
    /// input end.
    void own_input(const Process& process) {
        own(inputter_, process, "inputs from");
        if (input_out_of_order_)
            refuse_unreset(process, "inputs from");
    }
    /// Sets whether the input end is guarded. No other process may use a guarded end.
    void note_guard(bool there) { inputter_inside_ = there; }
    /// Announces messages to the listener until disable() is called.
    void enable(Listener& listener) { listener_ = &listener; }
    void disable() { listener_ = nullptr; }

    // The next functions are for attempts (runtime/recovery.hpp).
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

    /// Return whether the process in output (input) waits for ever, whatever its partner does.
    bool output_is_lost() const { return carrier_ && carrier_->output_is_lost(*this); }
    bool input_is_lost() const { return carrier_ && carrier_->input_is_lost(*this); }
    /// Return whether the other end has given up a message that this end is still transferring
    /// (Carrier::output_must_be_reset).
    bool output_must_be_reset() const { return carrier_ && carrier_->output_must_be_reset(*this); }
    bool input_must_be_reset() const { return carrier_ && carrier_->input_must_be_reset(*this); }
    /// Returns the other channels that keep the outputting process waiting (Carrier::held_up_by).
    std::vector<const AnyChannel*> held_up_by() const {
        return carrier_ ? carrier_->held_up_by(*this) : std::vector<const AnyChannel*>{};
    }

    /// Returns the name of the device that uses one end in place of a process (Carrier::partner_device).
    std::string partner_device() const { return carrier_ ? carrier_->partner_device() : ""; }

    /// Describes the current message of a channel between routers: the user's channel to which the packet belongs, and
    /// whether the packet is an acknowledge. `channel` is null for a message that is not a packet.
    struct PacketPayload {
        const AnyChannel* channel = nullptr;
        bool acknowledges = false;
    };
    const PacketPayload& payload() const { return payload_; }
    void carries(const PacketPayload& payload) { payload_ = payload; }

    // The next functions are for carriers.
    /// Hands the outputter's message to the inputter. REQUIRES: both processes are in the channel.
    void hand_over();
    /// Hands the message of another channel to the inputter of this one: the two channels are the halves of a channel
    /// between two kernels. REQUIRES: both channels have the same protocol; a process is in output on `other`; a
    /// process is in input on this channel.
    void take_from(AnyChannel& other);
    /// Returns how messages of the protocol are written as bytes; null if they have no byte form.
    virtual const AnyByteForm* byte_form() const = 0;
    /// Returns the outputter's message as bytes. REQUIRES: byte_form() is not null; a process is in output.
    MessageBytes message_in_bytes() const;
    /// Tells the trace that the outputter's message has been taken on another kernel. REQUIRES: a process is in output.
    void tell_taken_elsewhere() const {
        if (const Kernel& kernel = outputter_.process->kernel(); kernel.trace())
            tell_trace(kernel);
    }
    /// Notes that a device has taken the outputter's message. REQUIRES: a process is in output.
    void note_taken_by_device() { note_communication(outputter_.process->kernel()); }
    /// Hands a device's message to the inputter. Throws NoMessage if the bytes are not a message of the protocol.
    /// REQUIRES: ByteForm::next_part returns 0 for the bytes; a process is in input.
    void hand_over(std::span<const std::uint8_t> bytes);
    /// Returns the functions that pack messages for another copy of the program; null if messages of the protocol
    /// cannot be packed.
    virtual const AnyPackedForm* packed_form() const = 0;
    /// Appends the outputter's message in packed form. REQUIRES: packed_form() is not null; a process is in output.
    void pack_message(MessageBytes& to) const { packed_form()->write(message_, to); }
    /// Hands a packed message to the inputter. Throws NoMessage if the bytes are damaged. REQUIRES: packed_form() is
    /// not null; a process is in input.
    void hand_over_packed(std::span<const std::uint8_t> bytes);
    /// Returns whether the next input may be given up.
    bool is_attempted_input() const { return input_attempt_ != nullptr; }
    /// Returns whether the messages that wait in both channels are equal. Returns nothing if messages of this protocol
    /// cannot be compared (SameMessage). REQUIRES: a process is outputting on each of the two channels.
    std::optional<bool> has_message_of(const AnyChannel& other) const {
        return protocol() == other.protocol() ? are_same(message_, other.message_) : false;
    }
    /// Notifies the listener, if there is one, that a message waits and no process has asked for it.
    void announce() {
        if (listener_)
            listener_->message_announced();
    }

protected:
    // The common path of a communication is inlined into the caller; waiting and rare cases are not. If the partner
    // waits in a soft channel, the process copies the message and completes the communication. Otherwise it waits. On a
    // hard channel the process always waits, even if its partner is already waiting.

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
    /// Return the slot (message) of a partner that waits in a soft channel, or null if no partner waits.
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
    /// Complete the communication for the second process, which has copied the message. The process pays for the copy,
    /// and its partner continues. During the copy no other process may use this process's end. An output of one word
    /// has already paid for its copy.
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
    /// Marks a process as present at an end of the channel, as long as the object exists. For the same time, stores the
    /// address of the process's message, or of its slot for a message, in `*place`.
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

    // The members are grouped into cache lines in the order of use. The first members are needed for each
    // communication.
    Carrier* carrier_ = nullptr;             ///< null if the channel is soft
    void* message_ = nullptr;                ///< set while an outputter is in the channel
    void* slot_ = nullptr;                   ///< set while an inputter is in the channel
    Process* waiting_ = nullptr;             ///< on a soft channel, the process that arrived first
    const WireForm* waiting_form_ = nullptr; ///< form of the waiting process's message, if the process outputs
    Listener* listener_ = nullptr;     ///< set by an alternation, or by an attempt that a message in this channel ends
    bool is_particular_ = false;       ///< the channel is hard, or has an attempt at an end; one test covers both
                                       ///< cases
    bool outputter_inside_ = false;    ///< a process is in output
    bool inputter_inside_ = false;     ///< a process is in input, or has a guard on the channel
    bool output_out_of_order_ = false; ///< a message was given up at the output end, and the end must be reset
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

/// True if C++ would convert one type to the other and lose information: a number's fraction, or the target of a
/// pointer.
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
    /// Deleted, because a REAL is not a message of a CHAN OF INT.
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
    /// Inputs into a slot, for attempts. If the message is given up, the slot stays empty.
    void input_into(std::optional<T>& slot, const SourceLocation& where) const { own().input_into(slot, where); }
    AnyChannel& channel() const { return own(); }
    explicit operator bool() const { return channel_ != nullptr; }

private:
    friend class Channel<T>;
    explicit Input(Channel<T>& channel) : channel_(&channel) {}
    Channel<T>& own() const { return channel_ ? *channel_ : (refuse_end_without_channel(), *channel_); }
    Channel<T>* channel_ = nullptr;
};

/// An end of a channel of any protocol. It is used to declare that a process will use the end.
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
