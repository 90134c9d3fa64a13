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

/// The memory of a processor, as the engines of its links use it. A part of a message takes one word for each
/// bytes_in_a_word bytes, and one for the rest at its end.
struct LinkEngineMemory {
    std::uint32_t bytes_in_a_word = 4; ///< or 2
    std::uint64_t words_of_ended_parts = 0;
    int parts_under_way = 0;

    std::uint64_t words_in(std::uint32_t bytes) const {
        return (std::uint64_t{bytes} + bytes_in_a_word - 1) >> (bytes_in_a_word / 2); // a division by 2 or 4
    }
};

/// A program that writes the bytes of a direction to a register, or reads them from one, such as the driver of a link
/// adapter. It stands in the place of an engine, which would move them from memory or to it.
class RegisterUser {
public:
    /// Called when the register is free for the next byte, or holds one. It must not wait and must not throw.
    virtual void register_ready() = 0;

protected:
    ~RegisterUser() = default;
};

/// What a link that moves bytes by counts calls. The calls must not wait and must not throw. They may call give() and
/// take() of the same direction.
class ByteUser {
public:
    virtual void sent() {}       ///< the acknowledge of the last byte of give() has come
    virtual void taken() {}      ///< the last byte of take() has arrived
    virtual void byte_waits() {} ///< a byte has arrived while no take() was under way

protected:
    ~ByteUser() = default;
};

/// One direction of a link, for the messages of one channel: the two engines that the instructions `out` and
/// `in` start at its ends. A sender goes on when the acknowledge of its last byte has arrived, a receiver when
/// the last byte has. If no process has asked for a message, its first byte waits at the receiving end and is not
/// acknowledged. The times are exact to the bit.
///
/// A message gets no further when one of its bytes or acknowledges is lost. It also gets no further when the process at
/// one end gives it up: no byte is acknowledged any more, and the other end stays in the message until it is given up
/// or reset, too. This is our rule: the real engines would mistake the rest of one message and the beginning of the
/// next for one message.
///
/// Throws std::logic_error when a second channel uses it, and for a message without bytes.
class alignas(64) LinkDirection final : public Carrier {
public:
    /// Direction 0, from a to b, or 1 of the link whose course it is.
    LinkDirection(Kernel&, std::string name, const PacketTimes&, LinkCourse&, std::size_t number);

    /// One of its two engines moves the messages from this memory, or to it. Throws std::logic_error when both have a
    /// memory already. REQUIRES: it outlives the run.
    void move_messages_of(LinkEngineMemory&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return byte_waits(); }

    // For a link adapter, whose program sends or receives one byte at a time. Call the first two before the run.
    void is_written_by(RegisterUser&);
    void is_read_by(RegisterUser&);
    /// The running process begins to send a message on the channel.
    void begin_writing(AnyChannel&);
    /// The running process begins to send a part of that message.
    void begin_part(AnyChannel&, std::uint32_t bytes, bool last_part);
    bool can_be_written() const { return phase() == LinkState::Phase::idle; }
    /// REQUIRES: can_be_written().
    void write_byte();
    /// The running process begins to receive a message on the channel.
    void begin_reading(AnyChannel&);
    bool can_be_read() const { return phase() == LinkState::Phase::owed; }
    /// What ended with the byte that was read.
    enum class Ended { nothing, part, message };
    /// REQUIRES: can_be_read().
    Ended read_byte();

    // For ends that move bytes by counts. Each end says how many bytes it will give or take; the counts need not agree.
    // The end with the smaller count is done first, and the other goes on with the rest. A fault may strike the bytes,
    // and the trace does not show them. Each stretch of bytes on which both ends agree counts as a part: its words of
    // memory are rounded up.
    /// Makes both ends move bytes by counts. Throws std::logic_error if a channel or an adapter uses the direction.
    /// REQUIRES: the run has not begun; the users outlive it.
    void move_by_counts(ByteUser& sender, ByteUser& receiver);
    /// Offers bytes. Throws std::logic_error for 0 bytes, and while an earlier give() has not been sent().
    void give(std::uint32_t bytes);
    /// Asks for bytes. Throws std::logic_error for 0 bytes, and while an earlier take() has not been taken().
    void take(std::uint32_t bytes);
    /// Whether a first byte waits for which no receiver has asked.
    bool byte_waits() const;

    bool output_is_lost(const AnyChannel&) const override { return sender_ && gets_no_further(); }
    bool input_is_lost(const AnyChannel&) const override;
    bool output_must_be_reset(const AnyChannel&) const override;
    bool input_must_be_reset(const AnyChannel&) const override;

    /// Whether the message under way was given up at that end. Its program must then leave it.
    bool output_is_given_up() const { return output_given_up_; }
    bool input_is_given_up() const { return input_given_up_; }

    std::string why_not_given_up() const override { return ""; }
    bool give_up_output(AnyChannel&) override;
    bool give_up_input(AnyChannel&) override;
    /// Returns how many bytes of the message that was given up were acknowledged (output) or taken (input).
    std::uint64_t reset_output(AnyChannel&) override;
    std::uint64_t reset_input(AnyChannel&) override;

    /// "t[0].link[1] -> t[1].link[0]"
    const std::string& name() const { return name_; }
    /// Returns how many bytes the wire has begun to carry.
    std::uint64_t bytes_carried() const;
    /// Returns for how long the wire has carried the bits of bytes.
    Time time_occupied() const;

    /// Makes every step of the link an event. Tests compare such a run with the usual one. REQUIRES: the run has not
    /// begun.
    void simulate_every_byte() { course_.show_every_step(); }

    // The rest is for its link.
    /// Gives the direction the faults of its link.
    void suffer(LinkFaults& faults) { faults_ = &faults; }
    /// Call before the speed of the link changes.
    void note_speed();
    /// Whether a fault strikes the packet that begins. REQUIRES: the link has faults.
    bool is_lost(LinkStep);
    /// Acts on a step of this direction that was performed. Returns the process that goes on; null if none does.
    Process* step_performed(LinkState&, LinkStep, const LinkState::Outcome&);

private:
    void serve(AnyChannel&);
    void send(Process&, std::uint32_t bytes, bool last_part);
    bool receive(Process&);

    /// What the instructions `out` and `in` do for a part of a message. Both are members of the direction, not
    /// variables of a process, since the direction is needed next anyway, while the stack of a process may be in no
    /// cache.
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
    bool gets_no_further() const;
    std::uint32_t bytes_started() const;

    void begin_part_of(LinkState&, std::uint32_t bytes);
    void end_part(LinkState&);
    bool receiver_asks(LinkCourse::Touch&);
    void deliver();
    Process* sending_ended(LinkState&);

    // Bytes by counts: link_counts.cpp.
    struct Counts {
        ByteUser &sender, &receiver;
        std::uint32_t to_give = 0, to_take = 0; ///< bytes beyond the part under way
        bool gives = false, takes = false;      ///< whether a give(), a take() is under way
    };
    void begin_part_by_counts(LinkState&);
    bool agree_on_part(LinkState&);
    void ask_by_counts();
    void end_of_taking();
    void step_performed_by_counts(LinkState&, LinkStep, const LinkState::Outcome&);

    // Messages that are given up: link_recovery.cpp.
    std::uint64_t bytes_taken() const;
    std::uint64_t bytes_acknowledged() const;
    void break_off(LinkCourse::Touch&);
    void drop_output(LinkCourse::Touch&);
    void receiver_leaves(LinkCourse::Touch&);

    // The trace: link.cpp.
    void trace_byte(const LinkState&, const LinkState::Outcome&);
    void trace_bytes(Time since);
    void trace_break(Time byte_started);
    void trace_standstill();

    // The members stand in the order of use, which saves lines of the cache: what every packet needs, ...
    Kernel& kernel_;
    LinkCourse& course_;
    Process* sender_ = nullptr;     ///< set from the start of a part to the acknowledge of its last byte
    Process* receiver_ = nullptr;   ///< set while a process waits for a part
    AnyChannel* channel_ = nullptr; ///< the channel that uses the direction; null until one does
    LinkFaults* faults_ = nullptr;  ///< null if its link has no faults
    const std::uint8_t number_;     ///< 0 or 1: its place in its link
    bool last_part_ = false;        ///< the part under way ends its message
    bool took_last_part_ = false;   ///< the last part that was delivered ended its message
    bool output_given_up_ = false;  ///< the sender has given up the message under way
    bool input_given_up_ = false;   ///< the receiver has given up the message under way

    // ... what every message needs, ...
    In input_{*this};
    const PacketTimes& times_;
    Out output_{*this};
    std::array<LinkEngineMemory*, 2> memories_{}; ///< the memories at its ends; null where there is none
    std::uint64_t bytes_of_ended_parts_ = 0;      ///< bytes carried before the part under way
    std::uint64_t bytes_before_part_ = 0;         ///< bytes of the message under way before its present part

    // ... and what few do.
    RegisterUser *writer_ = nullptr, *reader_ = nullptr; ///< null if an engine is at that end
    std::unique_ptr<Counts> counts_;                     ///< null if it carries messages
    std::uint64_t bytes_left_over_ = 0;        ///< bytes that have come of the message that its sender has given up
    std::uint64_t acknowledged_when_left_ = 0; ///< bytes of the message that its receiver has given up
    std::uint64_t sent_when_given_up_ = 0, taken_when_given_up_ = 0; ///< bytes; until the end is reset
    std::uint64_t bytes_at_old_speed_ = 0;                           ///< bytes carried before the speed last changed
    Time occupied_at_old_speed_{}, old_speed_until_{};
    std::uint64_t bytes_traced_ = 0; ///< bytes carried that the trace has been told of
    std::string name_;
};

/// A link: two wires, each carrying the bytes of one direction and the acknowledges of the other.
class Link final : private LinkObserver {
public:
    /// `a` and `b` name its ends in reports. Throws std::logic_error unless bits_per_second > 0 and the wire's delay is
    /// not negative.
    explicit Link(Kernel&, const LinkTiming& = {}, const std::string& a = "a", const std::string& b = "b");
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    LinkDirection& from_a_to_b() { return a_to_b_; }
    LinkDirection& from_b_to_a() { return b_to_a_; }
    const LinkDirection& from_a_to_b() const { return a_to_b_; }
    const LinkDirection& from_b_to_a() const { return b_to_a_; }

    /// Prefetches what words_moved() reads.
    void fetch() const { course_.fetch(); }
    /// Returns how many words of the parts under way the engines at this memory have moved before now. It performs
    /// steps that are due, and changes nothing that can be seen.
    std::uint64_t words_moved(const LinkEngineMemory& memory, Time now) {
        return memory.words_in(course_.bytes_begun_before(now, 0)) +
               memory.words_in(course_.bytes_begun_before(now, 1));
    }

    /// Adds a fault, and returns a record of its effects, which lives as long as the link. REQUIRES: the run has not
    /// begun. Throws what LinkFaults::add throws.
    const FaultEffect& suffer(const LinkFault&);

    /// Leads its wires through a passage that may stop packets. REQUIRES: the run has not begun; the passage outlives
    /// it.
    void lead_through(SwitchPath&);
    /// A passage may be opened or closed only while such an object lives.
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
