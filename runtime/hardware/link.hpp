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

/// Receives a call before an end of a link changes the link's state by give(), take() or a reset. A processor that has
/// computed ahead can then return to the present. The function must not wait or throw.
class LinkEngineWatcher {
public:
    virtual void link_will_change() = 0;

protected:
    ~LinkEngineWatcher() = default;
};

/// The memory of a processor, as the engines of its links use it. A part of a message takes one word for each
/// `bytes_in_a_word` bytes; remaining bytes at its end take one more word.
struct LinkEngineMemory {
    std::uint32_t bytes_in_a_word = 4; ///< or 2
    std::uint64_t words_of_ended_parts = 0;
    int parts_under_way = 0;
    LinkEngineWatcher* watcher = nullptr; ///< null if no call is needed

    std::uint64_t words_in(std::uint32_t bytes) const {
        return (std::uint64_t{bytes} + bytes_in_a_word - 1) >> (bytes_in_a_word / 2); // divides by 2 or 4
    }
};

/// A program that writes the bytes of a direction to a register, or reads them from a register. The driver of a link
/// adapter is such a program. It replaces an engine, which would move the bytes from or to memory.
class RegisterUser {
public:
    /// Called when the register is free for the next byte, or when it holds a byte. Must not wait or throw.
    virtual void register_ready() = 0;

protected:
    ~RegisterUser() = default;
};

/// The callbacks of a link that moves bytes by counts. They must not wait or throw. They may call give() and take() of
/// the same direction.
class ByteUser {
public:
    virtual void sent() {}       ///< the acknowledge of the last byte of give() has come
    virtual void taken() {}      ///< the last byte of take() has arrived
    virtual void byte_waits() {} ///< a byte has arrived while no take() was under way

protected:
    ~ByteUser() = default;
};

/// One direction of a link. It carries the messages of one channel, by the two engines that the instructions `out` and
/// `in` start at its ends. A sender continues when the acknowledge of its last byte has arrived, a receiver when the
/// last byte has arrived. If no process has asked for a message, its first byte waits at the receiving end without an
/// acknowledge. The times are exact to the bit.
///
/// If a byte or an acknowledge of a message is lost, the message does not continue. Neither does a message that the
/// process at one end gives up: no further byte is acknowledged, and the other end stays in the message until it, too,
/// gives up the message or is reset. This rule is ours: the real engines would take the rest of one message and the
/// beginning of the next for one message.
///
/// Throws std::logic_error if a second channel uses the direction, and for a message without bytes.
class alignas(64) LinkDirection final : public Carrier {
public:
    /// `number` is 0 for the direction from a to b, 1 for the other direction. Both directions share the link's course.
    LinkDirection(Kernel&, std::string name, const PacketTimes&, LinkCourse&, std::size_t number);

    /// States that one of the two engines moves the messages from or to this memory. Throws std::logic_error if both
    /// engines have a memory. REQUIRES: the memory outlives the run.
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
    /// The unit that ends with a byte that was read: none, a part of the message, or the whole message.
    enum class Ended { nothing, part, message };
    /// Reads the byte. REQUIRES: can_be_read().
    Ended read_byte();

    // These functions are for ends that move bytes by counts. Each end states how many bytes it will give or take; the
    // counts may differ. The end with the smaller count is done first, and the other end continues with its remaining
    // bytes. A fault may strike the bytes. The trace does not show them unless they belong to a channel. Bytes on which
    // both ends agree count as a part, whose words of memory are rounded up.
    /// Makes both ends move bytes by counts. Throws std::logic_error if a channel or an adapter uses the direction.
    /// REQUIRES: the run has not begun; the users outlive the direction.
    void move_by_counts(ByteUser& sender, ByteUser& receiver);
    /// States that the bytes of the counts are messages of this channel: the trace then shows them, and reports of
    /// faults name the channel. REQUIRES: the run has not begun; the channel outlives the direction.
    void carries_bytes_of(AnyChannel& channel) { channel_ = &channel; }
    /// Offers bytes. Throws std::logic_error for 0 bytes, and if sent() has not been called for an earlier give().
    void give(std::uint32_t bytes);
    /// Asks for bytes. Throws std::logic_error for 0 bytes, and if taken() has not been called for an earlier take().
    void take(std::uint32_t bytes);
    /// Returns whether a first byte waits that no receiver has asked for.
    bool byte_waits() const;
    /// Returns whether take() has received all its bytes. The last bits may still be on the wire.
    bool is_taken();
    /// Cancel the current give() or take() of this end. If a part was under way, the bytes of this part that had
    /// arrived are lost, and the other end makes no progress until it is reset, too. Return how many bytes of the part
    /// had arrived.
    std::uint32_t reset_giving();
    std::uint32_t reset_taking();

    bool output_is_lost(const AnyChannel&) const override { return has_sender() && gets_no_further(); }
    bool input_is_lost(const AnyChannel&) const override;
    bool output_must_be_reset(const AnyChannel&) const override;
    bool input_must_be_reset(const AnyChannel&) const override;

    /// Returns whether the current message was given up at this end. The end's program must then leave the message.
    bool output_is_given_up() const { return output_given_up_; }
    bool input_is_given_up() const { return input_given_up_; }

    std::string why_not_given_up() const override { return ""; }
    bool give_up_output(AnyChannel&) override;
    bool give_up_input(AnyChannel&) override;
    /// Returns how many bytes of the given-up message were acknowledged (output) or received (input).
    std::uint64_t reset_output(AnyChannel&) override;
    std::uint64_t reset_input(AnyChannel&) override;

    /// Returns a name such as "t[0].link[1] -> t[1].link[0]".
    const std::string& name() const { return name_; }
    /// Returns how many bytes the wire has begun to carry.
    std::uint64_t bytes_carried() const;
    /// Returns for how long the wire has carried bytes, without acknowledges.
    Time time_occupied() const;

    /// Makes every step of the link an event. Tests compare such a run with a usual run. REQUIRES: the run has not
    /// begun.
    void simulate_every_byte() { course_.show_every_step(); }

    // The other public functions are for the direction's link.
    /// Subjects the direction to the faults of its link.
    void suffer(LinkFaults& faults) { faults_ = &faults; }
    /// Records the bytes carried so far. Call it before the speed of the link changes.
    void note_speed();
    /// Returns whether a fault strikes the packet that begins. REQUIRES: the link has faults.
    bool is_lost(LinkStep);
    /// Acts on a step of this direction. Returns the process that continues, or null.
    Process* step_performed(LinkState&, LinkStep, const LinkState::Outcome&);

private:
    void serve(AnyChannel&);
    void send(Process&, std::uint32_t bytes, bool last_part);
    bool receive(Process&);

    /// The work of the instructions `out` and `in` for a part of a message. Both objects are members of the direction
    /// instead of local variables of a process. The direction is needed next anyway, while the stack of a process may
    /// be in no cache.
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

    // These members move bytes by counts: link_counts.cpp.
    struct Counts {
        ByteUser &sender, &receiver;
        std::uint32_t to_give = 0, to_take = 0; ///< bytes of the counts beyond the current part
        std::uint32_t agreed = 0;               ///< bytes of the current part that belong to the receiver's count
        std::uint32_t given = 0;                ///< the count of give()
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

    // The members are in the order of use, which saves cache lines. The first members are needed for every packet.
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
    std::uint64_t bytes_left_over_ = 0;        ///< bytes that arrived of a message that its sender has given up
    std::uint64_t acknowledged_when_left_ = 0; ///< bytes acknowledged of a message that its receiver has given up
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
    /// Returns whether nothing is under way. If so, the link stays as it is until one of its ends acts on it, and
    /// words_moved() returns the same result at all later times.
    bool is_still() const { return course_.is_still(); }
    /// Prefetches the data that words_moved() reads.
    void fetch() const { course_.fetch(); }
    /// Returns how many words of the current parts the engines at this memory moved before `now`. Performs steps that
    /// are due, without a visible effect.
    std::uint64_t words_moved(const LinkEngineMemory& memory, Time now) {
        return memory.words_in(course_.bytes_begun_before(now, 0)) +
               memory.words_in(course_.bytes_begun_before(now, 1));
    }

    /// Adds a fault. Returns a record of its effects, which is valid as long as the link exists. Throws the exceptions
    /// of LinkFaults::add. REQUIRES: the run has not begun.
    const FaultEffect& suffer(const LinkFault&);

    /// Leads the wires through a device that may stop packets. REQUIRES: the run has not begun; the device outlives the
    /// run.
    void lead_through(SwitchPath&);
    /// Marks a change of a SwitchPath. A path may begin or cease to lead packets only while such an object exists.
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
