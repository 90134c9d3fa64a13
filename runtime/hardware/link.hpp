#pragma once

#include "runtime/carrier.hpp"
#include "runtime/hardware/link_course.hpp"
#include "runtime/hardware/link_faults.hpp"
#include "runtime/hardware/link_state.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/kernel.hpp"
#include "runtime/source_location.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace placedpar::hardware {

/// A watcher is called before an end of a link changes the link's state by LinkDirection::give(), take() or a reset. An
/// emulated transputer executes its code ahead of virtual time. After this call it returns to the present, so that its
/// execution can take the change into account. The function must not wait or throw.
class LinkEngineWatcher {
public:
    virtual void link_will_change() = 0;

protected:
    ~LinkEngineWatcher() = default;
};

/// Counts the words that the engines of a processor's links move from or to its memory. (A link engine moves a message
/// without the processor.) A processor that computes waits for these accesses. The bytes at the end of a message part
/// that do not fill a word count as a word.
struct LinkEngineMemory {
    std::uint32_t bytes_in_a_word = 4; ///< or 2
    std::uint64_t words_of_ended_parts = 0;
    int parts_under_way = 0;
    LinkEngineWatcher* watcher = nullptr; ///< called before a link of this processor changes; null if no call is needed

    std::uint64_t words_in(std::uint32_t bytes) const {
        return (std::uint64_t{bytes} + bytes_in_a_word - 1) >> (bytes_in_a_word / 2); // divides by 2 or 4
    }
};

/// A program that sends or receives the bytes of a link direction one by one, through a register. The driver of a link
/// adapter is such a program. At a transputer's end of a link, an engine does this work.
class RegisterUser {
public:
    /// Called when the register can be written (or read). Must not wait or throw.
    virtual void register_ready() = 0;

protected:
    ~RegisterUser() = default;
};

/// The callbacks of a link whose ends only state how many bytes they send or receive (LinkDirection::move_by_counts).
/// They must not wait or throw. They may call give() and take() of the same direction.
class ByteUser {
public:
    virtual void sent() {}       ///< the acknowledge of the last byte of give() has come
    virtual void taken() {}      ///< the last byte of take() has arrived
    virtual void byte_waits() {} ///< a byte has arrived while no take() was under way

protected:
    ~ByteUser() = default;
};

/// One direction of a link, which carries the messages of one channel. At each end an engine moves the bytes from or to
/// memory, as after a transputer's instructions `out` and `in`. A sender continues when the acknowledge of its last
/// byte has arrived, a receiver when the last byte has arrived. If no process inputs a message, its first byte waits at
/// the receiving end without an acknowledge. The times are exact to the bit.
///
/// If a byte or an acknowledge of a message is lost, no further byte of the message is transferred. If the process at
/// one end gives up a message, no further byte is acknowledged. The other end then stays in the message until it, too,
/// gives up the message or is reset. This rule is our choice: the real engines would take the rest of one message and
/// the beginning of the next for one message.
///
/// Throws std::logic_error if a second channel uses the direction, and for a message without bytes.
class alignas(64) LinkDirection final : public Carrier {
public:
    /// `number` is 0 for the direction from a to b, 1 for the direction from b to a. The LinkCourse has the state of
    /// both directions, and advances it in time.
    LinkDirection(Kernel&, std::string name, const PacketTimes&, LinkCourse&, std::size_t number);

    /// States that the engine at one end uses this memory. Throws std::logic_error if both ends have a memory already.
    /// REQUIRES: the memory outlives the run.
    void move_messages_of(LinkEngineMemory&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return byte_waits(); }

    // These functions are for a link adapter, whose program sends or receives one byte at a time. Call the first two
    // before the run.
    void is_written_by(RegisterUser&);
    void is_read_by(RegisterUser&);
    /// Begins to send a message of the running process on the channel.
    void begin_writing(AnyChannel&);
    /// Begins to send a part of this message.
    void begin_part(AnyChannel&, std::uint32_t bytes, bool last_part);
    bool can_be_written() const { return phase() == LinkState::Phase::idle; }
    /// REQUIRES: can_be_written().
    void write_byte();
    /// Begins to receive a message for the running process on the channel.
    void begin_reading(AnyChannel&);
    bool can_be_read() const { return phase() == LinkState::Phase::owed; }
    /// What ends with a byte: a part of the message, the whole message, or nothing.
    enum class Ended { nothing, part, message };
    /// Reads the byte. REQUIRES: can_be_read().
    Ended read_byte();

    // These functions are for transputers that execute their own code. Each end states how many bytes it will give or
    // take; the two numbers may differ. The end with the smaller number is done first, and the other end continues with
    // its remaining bytes. Faults of the link may lose bytes. The trace shows the bytes only if they belong to a
    // channel. The bytes that both ends have agreed to move count as one part of a message.
    /// Makes both ends move bytes by give() and take(). Throws std::logic_error if a channel or an adapter uses the
    /// direction. REQUIRES: the run has not begun; the users outlive the direction.
    void move_by_counts(ByteUser& sender, ByteUser& receiver);
    /// States that the bytes of give() and take() are messages of this channel. The trace then shows them, and reports
    /// of faults name the channel. REQUIRES: the run has not begun; the channel outlives the direction.
    void carries_bytes_of(AnyChannel& channel) { channel_ = &channel; }
    /// Offers bytes. Throws std::logic_error for 0 bytes, and if sent() has not been called for an earlier give().
    void give(std::uint32_t bytes);
    /// Asks for bytes. Throws std::logic_error for 0 bytes, and if taken() has not been called for an earlier take().
    void take(std::uint32_t bytes);
    /// Returns whether the first byte of a message waits because no receiver has asked for it.
    bool byte_waits() const;
    /// Returns whether take() has received all its bytes. The last bits may still be on the wire.
    bool is_taken();
    /// Cancel the current give() or take() of this end. If a part was under way, its bytes are lost, and the other end
    /// makes no progress until it is reset, too. Return how many bytes of the part had arrived.
    std::uint32_t reset_giving();
    std::uint32_t reset_taking();

    bool output_is_lost(const AnyChannel&) const override { return has_sender() && gets_no_further(); }
    bool input_is_lost(const AnyChannel&) const override;
    bool output_must_be_reset(const AnyChannel&) const override;
    bool input_must_be_reset(const AnyChannel&) const override;

    /// Return whether the current message was given up at this end. A program that writes or reads each byte must then
    /// leave the message.
    bool output_is_given_up() const { return output_given_up_; }
    bool input_is_given_up() const { return input_given_up_; }

    std::string why_not_given_up() const override { return ""; }
    bool give_up_output(AnyChannel&) override;
    bool give_up_input(AnyChannel&) override;
    /// Clear the end after a message was given up. Return how many of its bytes were acknowledged (output) or received
    /// (input).
    std::uint64_t reset_output(AnyChannel&) override;
    std::uint64_t reset_input(AnyChannel&) override;

    /// Returns a name such as "t[0].link[1] -> t[1].link[0]".
    const std::string& name() const { return name_; }
    /// Returns how many bytes the wire has begun to carry.
    std::uint64_t bytes_carried() const;
    /// Returns for how long the wire has carried bytes. Acknowledges do not count.
    Time time_occupied() const;

    /// Makes every step of the link an event of the kernel. Usually only steps that a process can see are events. Tests
    /// compare both ways. REQUIRES: the run has not begun.
    void simulate_every_byte() { course_.show_every_step(); }

    // The other public functions are for the direction's link.
    /// Makes the direction subject to the faults of its link.
    void suffer(LinkFaults& faults) { faults_ = &faults; }
    /// Records the bytes carried so far. Call it before the speed of the link changes.
    void note_speed();
    /// Returns whether a fault strikes the packet that begins. REQUIRES: the link has faults.
    bool is_lost(LinkStep);
    /// Acts on a step that this direction has performed. Returns the process that continues, or null.
    Process* step_performed(LinkState&, LinkStep, const LinkState::Outcome&);

private:
    void serve(AnyChannel&);
    void send(Process&, std::uint32_t bytes, bool last_part);
    bool receive(Process&);

    /// The work of the instructions `out` and `in` for a part of a message. These objects are members of the direction,
    /// which is in the cache, and not local variables on a process's stack, which may not be.
    struct Out final : Communication {
        explicit Out(LinkDirection& d) : direction(d) {}
        void set(std::uint32_t part, bool last, const SourceLocation& place) {
            bytes = part;
            last_part = last;
            where = place;
        }
        bool begin(Process&) noexcept override;
        LinkDirection& direction;
        std::uint32_t bytes = 0;
        bool last_part = false;
        SourceLocation where;
    };
    struct In final : Communication {
        explicit In(LinkDirection& d) : direction(d) {}
        bool begin(Process&) noexcept override;
        LinkDirection& direction;
        SourceLocation where;
    };

    const LinkState& state() const { return course_.state(); }
    LinkState::Ends ends() const { return course_.touched().directions[number_].ends; }
    LinkState::Phase phase() const { return state().directions[number_].phase; }
    bool has_sender() const { return counts_ ? counts_->gives : sender_ != nullptr; }
    bool gets_no_further() const;
    std::uint32_t bytes_started() const;

    void begin_part_of(LinkState&, std::uint32_t bytes);
    void end_part(LinkState&);
    bool receiver_asks(LinkCourse::Touch&);
    void deliver();
    Process* sending_ended(LinkState&);

    // These members serve give() and take(): link_counts.cpp.
    struct Counts {
        ByteUser &sender, &receiver;
        std::uint32_t to_give = 0, to_take = 0; ///< bytes of give() and take() beyond the current part
        std::uint32_t agreed = 0;               ///< bytes of the current part that belong to the current take()
        std::uint32_t given = 0;                ///< the number of bytes of the current give()
        bool gives = false, takes = false;      ///< whether a give() or a take() has not ended
    };
    void tell_watchers() const;
    void begin_part_by_counts(LinkState&);
    bool agree_on_part(LinkState&);
    void ask_by_counts();
    void end_of_taking();
    void step_performed_by_counts(LinkState&, LinkStep, const LinkState::Outcome&);

    // These members handle messages that are given up: link_recovery.cpp.
    bool is_sending() const;
    std::uint64_t bytes_received() const;
    std::uint64_t bytes_acknowledged() const;
    void forget_asked_byte(LinkCourse::Touch&);
    void break_off(LinkCourse::Touch&);
    void drop_output(LinkCourse::Touch&);
    void receiver_leaves(LinkCourse::Touch&);

    // These members write the trace: link.cpp.
    void trace_byte(const LinkState&, const LinkState::Outcome&);
    void trace_bytes(Time since);
    void trace_break(Time byte_started);
    void trace_standstill();

    // The first members are needed for every packet, so they share cache lines.
    Kernel& kernel_;
    LinkCourse& course_;
    Process* sender_ = nullptr;        ///< set from the start of a part until the acknowledge of its last byte
    Process* receiver_ = nullptr;      ///< set while a process waits for a part
    AnyChannel* channel_ = nullptr;    ///< the channel that uses the direction; null before its first message
    LinkFaults* faults_ = nullptr;     ///< null if the link has no faults
    const std::uint8_t number_;        ///< 0 or 1: index in the link
    bool last_part_ = false;           ///< the current part ends its message
    bool delivered_last_part_ = false; ///< the last part that was delivered ended its message
    bool output_given_up_ = false;     ///< the sender has given up the current message
    bool input_given_up_ = false;      ///< the receiver has given up the current message

    // The next members are needed for every message.
    In input_{*this};
    const PacketTimes& times_;
    Out output_{*this};
    std::array<LinkEngineMemory*, 2> memories_{}; ///< memories at the two ends; null at an end without one
    std::uint64_t bytes_of_ended_parts_ = 0;      ///< bytes carried before the current part
    std::uint64_t bytes_before_part_ = 0;         ///< bytes of the current message before the current part

    // The next members are needed rarely.
    RegisterUser *writer_ = nullptr, *reader_ = nullptr; ///< null if an engine moves the bytes at this end
    std::unique_ptr<Counts> counts_;                     ///< null if the direction carries messages
    std::uint64_t bytes_left_over_ = 0;                  ///< bytes that had arrived when the sender gave up the message
    std::uint64_t acknowledged_when_left_ = 0;           ///< bytes acknowledged when the receiver gave up the message
    std::uint64_t sent_when_given_up_ = 0, received_when_given_up_ = 0; ///< bytes of a message that was given up; kept
                                                                        ///< until the end is reset
    std::uint64_t bytes_at_old_speed_ = 0; ///< bytes carried before the last change of speed
    Time occupied_at_old_speed_{}, old_speed_until_{};
    std::uint64_t bytes_traced_ = 0; ///< bytes that the trace has shown
    std::string name_;
};

/// A link of two wires. Each wire carries the bytes of one direction and the acknowledges of the other.
class Link final : private LinkObserver {
public:
    /// `a` and `b`: names of the ends in reports. Throws std::logic_error unless bits_per_second > 0 and the wire's
    /// delay is at least 0.
    explicit Link(Kernel&, const LinkTiming& = {}, const std::string& a = "a", const std::string& b = "b");
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    LinkDirection& from_a_to_b() { return a_to_b_; }
    LinkDirection& from_b_to_a() { return b_to_a_; }
    const LinkDirection& from_a_to_b() const { return a_to_b_; }
    const LinkDirection& from_b_to_a() const { return b_to_a_; }

    const LinkTiming& timing() const { return timing_; }
    /// Returns whether nothing is under way. The link then stays as it is until one of its ends acts on it, and
    /// words_moved() keeps its value.
    bool is_still() const { return course_.is_still(); }
    /// Prefetches the data that words_moved() reads.
    void fetch() const { course_.fetch(); }
    /// Returns how many words of the current message parts the engines at this memory moved before `now`.
    std::uint64_t words_moved(const LinkEngineMemory& memory, Time now) {
        return memory.words_in(course_.bytes_begun_before(now, 0)) +
               memory.words_in(course_.bytes_begun_before(now, 1));
    }

    /// Adds a fault. Returns a record of its effects, which is valid as long as the link exists. Throws the exceptions
    /// of LinkFaults::add. REQUIRES: the run has not begun.
    const FaultEffect& suffer(const LinkFault&);

    /// Leads the wires through a device that may stop packets, such as a switch that is set during the run. REQUIRES:
    /// the run has not begun; the device outlives the run.
    void lead_through(SwitchPath&);
    /// A device on the link's path may begin or cease to pass on packets only while such an object exists. The object
    /// brings the link up to the present time.
    class WayChange {
    public:
        explicit WayChange(Link& link) : touch_(link.course_) {}

    private:
        LinkCourse::Touch touch_;
    };

private:
    LinkFaults& faults();
    Time steady_until() const override;
    LinkState::Fate packet_begins(const LinkState::Next&) override;
    Process* step_performed(LinkState&, const LinkState::Next&, const LinkState::Outcome&) override;
    LinkDirection& direction(std::size_t number) { return number == 0 ? a_to_b_ : b_to_a_; }

    LinkCourse course_;
    Kernel& kernel_;
    PacketTimes times_;
    LinkDirection a_to_b_, b_to_a_;
    LinkTiming timing_;
    std::optional<LinkFaults> faults_;
};

} // namespace placedpar::hardware
