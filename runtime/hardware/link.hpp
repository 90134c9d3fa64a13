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

/// The memory of a processor, as the engines of its links use it: a word for each bytes_in_a_word of a part of a
/// message, and one for what is left at its end.
struct MemoryOfEngines {
    std::uint32_t bytes_in_a_word = 4; ///< or 2
    std::uint64_t words_of_ended_parts = 0;
    int parts_under_way = 0;

    std::uint64_t words_in(std::uint32_t bytes) const {
        return (std::uint64_t{bytes} + bytes_in_a_word - 1) >> (bytes_in_a_word / 2); // divided: by 2 or 4
    }
};

/// A program that writes the bytes of a direction of a link to a register, or reads them there, as that of a link
/// adapter, instead of an engine that moves them from memory or to it.
class RegisterUser {
public:
    /// The register is free for the next byte, or has one. It must not wait and must not throw.
    virtual void register_ready() = 0;

protected:
    ~RegisterUser() = default;
};

/// Is told what becomes of bytes that a link moves by counts. It must not wait and must not throw.
class ByteUser {
public:
    virtual void sent() {}       ///< the acknowledge of the last byte given has come
    virtual void taken() {}      ///< the last byte asked for has arrived
    virtual void byte_waits() {} ///< a byte has arrived for which nobody has asked

protected:
    ~ByteUser() = default;
};

/// One direction of a link, for the messages of one channel: the two engines that the instructions `out` and
/// `in` start at its ends. A sender goes on when the acknowledge of its last byte has arrived, a receiver when
/// the last byte has. If no process has asked for a message, its first byte waits, unacknowledged, at the receiving
/// end. The times are exact to the bit.
///
/// A message of which a byte or an acknowledge is lost gets no further. A process that gives up its end in the middle
/// of a message ends it: none of its bytes is acknowledged any more, and the other end stays in it until it is given up
/// or reset, too. Ours: the real engines would take the rest of one message and the beginning of the next for one.
///
/// Throws std::logic_error when a second channel uses it, and for a message without bytes.
class alignas(64) LinkDirection final : public Carrier {
public:
    /// Direction 0, from a to b, or 1 of the link whose course it is.
    LinkDirection(Kernel&, std::string name, const PacketTimes&, LinkCourse&, std::size_t number);

    /// One of its two engines moves the messages from this memory, or to it. Throws std::logic_error when both have a
    /// memory already. REQUIRES: it outlives the run.
    void move_messages_of(MemoryOfEngines&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return first_byte_waits(); }

    // For a link adapter, whose program is the sender or the receiver: a byte at a time.
    void is_written_by(RegisterUser&);
    void is_read_by(RegisterUser&);
    /// The running process begins to send a message on the channel.
    void begin_writing(AnyChannel&);
    /// It begins to send a part of it.
    void begin_part(AnyChannel&, std::uint32_t bytes, bool last_part);
    bool can_be_written() const { return phase() == LinkState::Phase::idle; }
    /// REQUIRES: can_be_written().
    void write_byte();
    /// The running process begins to receive a message on the channel.
    void begin_reading(AnyChannel&);
    bool can_be_read() const { return phase() == LinkState::Phase::owed; }
    /// What the byte was the last one of.
    enum class Ended { nothing, part, message };
    /// REQUIRES: can_be_read().
    Ended read_byte();

    // For ends that move bytes by counts, which need not agree: each says how many it will give or take, and goes on
    // when they are done, while the other goes on with the rest.
    /// REQUIRES: before the run, and no channel uses the direction; the users outlive the run.
    void move_by_counts(ByteUser& sender, ByteUser& receiver);
    /// REQUIRES: bytes > 0, and what was given before is sent().
    void give(std::uint32_t bytes);
    /// REQUIRES: bytes > 0, and what was asked for before is taken().
    void take(std::uint32_t bytes);
    bool byte_waits() const { return first_byte_waits(); }

    bool output_is_lost(const AnyChannel&) const override { return sender_ && gets_no_further(); }
    bool input_is_lost(const AnyChannel&) const override;
    bool output_must_be_reset(const AnyChannel&) const override;
    bool input_must_be_reset(const AnyChannel&) const override;

    /// Whether the message under way was given up at that end: then its program leaves it.
    bool output_is_given_up() const { return output_given_up_; }
    bool input_is_given_up() const { return input_given_up_; }

    std::string why_not_given_up() const override { return ""; }
    bool give_up_output(AnyChannel&) override;
    bool give_up_input(AnyChannel&) override;
    /// Bytes of the message that was given up at this end, or left in it by the other: those acknowledged, those
    /// taken.
    std::uint64_t reset_output(AnyChannel&) override;
    std::uint64_t reset_input(AnyChannel&) override;

    /// "t[0].link[1] -> t[1].link[0]"
    const std::string& name() const { return name_; }
    /// Those that the wire has begun to carry.
    std::uint64_t bytes_carried() const;
    /// How long the wire has carried their bits.
    Time time_occupied() const;

    /// Simulates every step of its link by an event of its own, at the moment at which it is due: the reference by
    /// which all that saves events is tested. REQUIRES: before the run.
    void simulate_every_byte() { course_.show_every_step(); }

    // For its link.
    /// It has faults from now on.
    void suffer(LinkFaults& faults) { faults_ = &faults; }
    /// The speed of the link is about to change.
    void note_speed();
    /// Whether the packet that begins is lost.
    bool is_lost(LinkStep);
    /// A step of this direction was taken. Returns the process that goes on.
    Process* taken(LinkState&, LinkStep, const LinkState::Outcome&);

private:
    void serve(AnyChannel&);
    void send(Process&, std::uint32_t bytes, bool last_part);
    bool receive(Process&);

    /// What the transputer's instructions `out` and `in` do, each for a part of a message. They are members of the
    /// direction, not variables of its processes: the direction is needed next anyway, and their stacks are in no
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
    bool first_byte_waits() const;
    bool gets_no_further() const;
    std::uint32_t bytes_started() const;

    void begin_part_of(LinkState&, std::uint32_t bytes);
    void end_part(LinkState&);
    bool receiver_asks(LinkCourse::Touch&);
    void deliver();
    Process* sending_ended(LinkState&);

    // By counts (link_counts.cpp).
    struct Counts {
        ByteUser &sender, &receiver;
        std::uint32_t to_give = 0; ///< beyond the part under way
        std::uint32_t to_take = 0; ///< the same
    };
    void begin_part_by_counts(LinkState&);
    bool agree_on_part(LinkState&);
    void ask_by_counts();
    void end_of_taking();
    void taken_by_counts(LinkState&, LinkStep, const LinkState::Outcome&);

    // What is given up (link_recovery.cpp).
    std::uint64_t bytes_taken() const;
    std::uint64_t bytes_acknowledged() const;
    void break_off(LinkCourse::Touch&);
    void drop_output(LinkCourse::Touch&);
    void receiver_leaves(LinkCourse::Touch&);

    // For the trace.
    void trace_byte(const LinkState&, const LinkState::Outcome&);
    void trace_bytes(Time since);
    void trace_break(Time byte_started);
    void trace_standstill();

    // In the order of use, in lines of the cache: what every packet needs, ...
    Kernel& kernel_;
    LinkCourse& course_;
    Process* sender_ = nullptr; ///< from the start of a part to the acknowledge of its last byte
    Process* receiver_ = nullptr;
    AnyChannel* channel_ = nullptr; ///< whose messages it carries
    LinkFaults* faults_ = nullptr;  ///< null if its link has none
    const std::uint8_t number_;     ///< in its link: 0 or 1
    bool last_part_ = false;        ///< the part under way ends its message
    bool took_last_part_ = false;   ///< the part that was taken last ended its message
    bool output_given_up_ = false;  ///< the message under way, by its sender
    bool input_given_up_ = false;   ///< the same, by its receiver

    // ... what every message needs, ...
    In input_{*this};
    const PacketTimes& times_;
    Out output_{*this};
    std::array<MemoryOfEngines*, 2> memories_{}; ///< at its ends; null where nobody uses it
    std::uint64_t bytes_of_ended_parts_ = 0;     ///< that were carried
    std::uint64_t bytes_before_part_ = 0;        ///< of the message under way

    // ... and what few do.
    RegisterUser *writer_ = nullptr, *reader_ = nullptr; ///< null: an engine is at that end
    std::unique_ptr<Counts> counts_;                     ///< null: it carries messages
    std::uint64_t bytes_left_over_ = 0;                  ///< how many came of the message that its sender has given up
    std::uint64_t acknowledged_when_left_ = 0;           ///< bytes of the message that its receiver has given up
    std::uint64_t sent_when_given_up_ = 0, taken_when_given_up_ = 0; ///< bytes; until the end is reset
    // Of those carried the ones that travelled before the speed changed last.
    std::uint64_t bytes_at_old_speed_ = 0;
    Time occupied_at_old_speed_{}, old_speed_until_{};
    std::uint64_t bytes_traced_ = 0; ///< of those carried, how many the trace was told of
    std::string name_;
};

/// A link: two wires, each carrying the bytes of one direction and the acknowledges of the other.
class Link final : private LinkObserver {
public:
    /// The names are those of its ends, for reports. Throws std::logic_error unless bits_per_second > 0 and the wire's
    /// delay is not negative.
    explicit Link(Kernel&, const LinkTiming& = {}, const std::string& a = "a", const std::string& b = "b");
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    LinkDirection& from_a_to_b() { return a_to_b_; }
    LinkDirection& from_b_to_a() { return b_to_a_; }
    const LinkDirection& from_a_to_b() const { return a_to_b_; }
    const LinkDirection& from_b_to_a() const { return b_to_a_; }

    /// Begins to fetch what words_moved looks at.
    void fetch() const { course_.fetch(); }
    /// How many words the engines at this memory have moved before now, of the parts that are under way.
    std::uint64_t words_moved(const MemoryOfEngines& memory, Time now) {
        return memory.words_in(course_.bytes_begun_before(now, 0)) +
               memory.words_in(course_.bytes_begun_before(now, 1));
    }

    /// Adds a fault. REQUIRES: before the run. What it does is found in the effect, which lasts as long as the link.
    /// Throws as LinkFaults::add.
    const FaultEffect& suffer(const LinkFault&);

    /// Its wires lead through something that may stop their packets. REQUIRES: before the run; it outlives the run.
    void lead_through(Passage&);
    /// A passage changes, while this object lasts.
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
    Process* taken(LinkState&, const LinkState::Next&, const LinkState::Outcome&) override;
    LinkDirection& direction(std::size_t number) { return number == 0 ? a_to_b_ : b_to_a_; }

    LinkCourse course_;
    Kernel& kernel_;
    PacketTimes times_;
    LinkDirection a_to_b_, b_to_a_;
    LinkTiming timing_;
    std::optional<LinkFaults> faults_;
};

} // namespace placedpar::hardware
