#pragma once

#include "runtime/carrier.hpp"
#include "runtime/hardware/link_agenda.hpp"
#include "runtime/hardware/link_faults.hpp"
#include "runtime/hardware/link_streams.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/hardware/wire.hpp"
#include "runtime/kernel.hpp"
#include "runtime/source_location.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
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

class LinkDirection;

/// The closed form of a link: packets that nobody can see need no events. When one begins, those that follow are
/// computed at once, in both directions (LinkStreams), up to the first that others can see. The directions and the
/// wires then go to that moment, and only the steps that follow it stand in the agenda. If anybody acts on the link
/// before, they come back to the moment at which he does.
///
/// Processors ask for the progress of all their links whenever a computation begins or ends: what that takes mostly
/// stands in one line of the cache.
class ClosedForm {
public:
    ClosedForm(Kernel&, const PacketTimes&, LinkDirection& a_to_b, LinkDirection& b_to_a);

    /// Of direction 0, from a to b, or 1, the part of a message that is under way. While the link is ahead, as it is
    /// then.
    LinkStreams::Progress& part(std::size_t direction) { return parts_[direction]; }
    /// The length of that; 0 between two parts.
    std::uint32_t& part_bytes(std::size_t direction) { return repetition_.part_bytes[direction]; }

    /// Begins to fetch what bytes_begun_before looks at.
    void fetch() const { __builtin_prefetch(&repetition_); }

    /// REQUIRES: a packet has just begun.
    void look_ahead();
    /// The directions and wires have the state of a moment that is still to come.
    bool is_ahead() const { return kernel_.now() < ahead_until_; }
    /// They have that of now.
    void leave() {
        if (is_ahead())
            come_back();
    }
    /// What a direction has done by now, of the part under way.
    LinkStreams::Progress progress(std::size_t direction) {
        if (!is_ahead())
            return parts_[direction];
        return repetition_.is_simple(kernel_.now()) ? repetition_.progress(direction, kernel_.now())
                                                    : passed_until_now(direction);
    }
    /// The same for bytes, now. One that begins now is not counted: whether it has begun yet depends on the order of
    /// this instant's events.
    std::uint32_t bytes_begun_before(Time now, std::size_t direction) {
        if (repetition_.is_simple_around(now)) [[likely]]
            return repetition_.part_bytes[direction] - repetition_.bytes_left(direction, now - Time{1});
        auto [bytes_left, last_start] = progress(direction);
        std::uint32_t bytes = repetition_.part_bytes[direction] - bytes_left;
        return bytes > 0 && last_start >= now ? bytes - 1 : bytes;
    }

private:
    Time end_of_what_is_certain() const;
    void follow(Time before);
    void come_back();
    LinkStreams::Progress passed_until_now(std::size_t direction);
    void go_to(const LinkStreams&, Time);

    Repetition repetition_; ///< until ahead_until_; from then on it is of no use
    Kernel& kernel_;
    Time ahead_until_{};
    std::array<LinkStreams::Progress, 2> parts_;
    LinkDirection &a_to_b_, &b_to_a_;
    const PacketTimes& times_;
    LinkStreams behind_; ///< at a moment that has been
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
class alignas(64) LinkDirection final : public Carrier, private WireUser {
public:
    /// Its bytes travel on `out`, their acknowledges on `back`. The closed form is that of its link, in which this is
    /// direction 0, from a to b, or 1.
    LinkDirection(Kernel&, std::string name, const PacketTimes&, Wire& out, Wire& back, LinkAgenda&, ClosedForm&,
                  std::size_t number);

    /// One of its two engines moves the messages from this memory, or to it. Throws std::logic_error when both have a
    /// memory already. REQUIRES: it outlives the run.
    void move_messages_of(MemoryOfEngines&);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return first_byte_waits_; }

    // For a link adapter, whose program is the sender or the receiver: a byte at a time.
    void is_written_by(RegisterUser& user) {
        writer_ = &user;
        every_byte_ = true;
    }
    void is_read_by(RegisterUser& user) {
        reader_ = &user;
        every_byte_ = true;
    }
    /// The running process begins to send a message on the channel.
    void begin_writing(AnyChannel&);
    /// It begins to send a part of it.
    void begin_part(AnyChannel&, std::uint32_t bytes, bool last_part);
    bool can_be_written() const { return writable_; }
    /// REQUIRES: can_be_written().
    void write_byte();
    /// The running process begins to receive a message on the channel.
    void begin_reading(AnyChannel&);
    bool can_be_read() const { return readable_; }
    /// What the byte was the last one of.
    enum class Ended { nothing, part, message };
    /// REQUIRES: can_be_read().
    Ended read_byte();

    bool output_is_lost(const AnyChannel&) const override { return sender_ && stalled_; }
    bool input_is_lost(const AnyChannel&) const override { return left_over_ || (stalled_ && bytes_taken() > 0); }

    bool output_must_be_reset(const AnyChannel&) const override { return sender_ && receiver_left_; }
    bool input_must_be_reset(const AnyChannel&) const override { return left_over_; }

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

    /// Its link has faults from now on.
    void suffer(LinkFaults& faults) { faults_ = &faults; }
    /// The speed of the link is about to change.
    void note_speed();
    /// Simulates every packet by events of its own, each at the moment at which it is due: the reference by which all
    /// that saves events is tested.
    void simulate_every_byte() { every_byte_ = true; }

    // For its link.
    /// REQUIRES: the step is not its wire's.
    void take(LinkStep);
    void plan();

    /// "t[0].link[1] -> t[1].link[0]"
    const std::string& name() const { return name_; }
    /// Those that the wire has begun to carry.
    std::uint64_t bytes_carried() const { return bytes_carried_ + part_.bytes_left - progress().bytes_left; }
    /// How long the wire has carried their bits.
    Time time_occupied() const;

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

    // What happens to a byte, in this order.
    void acknowledge_is_due();
    void byte_is_due();
    void start_byte();
    void byte_started() override;
    void may_be_written();
    Time arrival(Time started) const { return later(started, times_.wire_delay + times_.byte().carried); }
    void foresee_arrival();
    /// A byte has certainly been noticed by the time it has arrived.
    bool arrives_noticed() const { return times_.overlaps() && !faults_; }
    void foresee_arrival_of_first();
    void foresee_arrival_of_last(Time started);
    void first_byte_arrived();
    void last_byte_arrived();
    void acknowledge_started() override;
    void sending_ended();
    void take_part();
    void enter_memories(std::uint32_t bytes);
    void leave_memories();

    // What is lost, and what is given up (link_recovery.cpp).
    bool is_lost(bool acknowledge);
    void stall();
    std::uint64_t bytes_taken() const;
    std::uint64_t bytes_acknowledged() const;
    void withdraw_acknowledge();
    void drop_bytes_on_their_way();
    void drop_output();
    void receiver_leaves();

    // For the trace.
    void trace_bytes(Time since);
    void trace_break(Time byte_started);

    // For the closed form.
    friend class ClosedForm;
    std::uint32_t& part_bytes() const { return closed_form_.part_bytes(number_); }
    LinkStreams::Stream stream() const;
    /// By now.
    LinkStreams::Progress progress() const { return closed_form_.progress(number_); }
    bool must_be_seen() const;
    bool receiver_takes_byte() const;
    bool waits_for_receiver() const;
    bool is_unnoticed() const;
    bool is_sure_of_its_receiver() const { return part_.bytes_left > 0 && receiver_takes_byte(); }
    void go_to(const LinkStreams::Stream&, Time);
    /// The packet that it asks a wire for next, at a moment that is known: its next byte, or the acknowledge of the
    /// byte under way, once that is noticed.
    enum class Packet : std::uint8_t { none, byte, acknowledge };
    void await(Packet, Time due);
    /// It has asked.
    void await_none() { next_ = Packet::none; }
    /// None will follow.
    void await_no_more() { await(Packet::none, LinkStreams::past); }
    bool has_asked_early() const { return kernel_.now() < next_due_; }
    void ask_early();
    void take_back_early_acknowledge();

    bool has(LinkStep step) const { return agenda_.has(step, number_); }
    void enter(LinkStep step, Time at) { agenda_.enter(step, number_, at); }
    void drop(LinkStep step) { agenda_.drop(step, number_); }
    /// The steps of last bytes, of which those of two parts can be to come.
    static constexpr std::array arrivals_of_last{LinkStep::last_byte_arrives, LinkStep::later_last_byte_arrives};
    /// That of the part under way.
    LinkStep arrival_of_last() const { return arrivals_of_last[last_of_part_]; }
    bool last_byte_is_on_its_way() const { return has(arrivals_of_last[0]) || has(arrivals_of_last[1]); }

    // In the order of use, in lines of the cache: what every packet needs, ...
    Kernel& kernel_;
    ClosedForm& closed_form_;
    LinkAgenda& agenda_;
    LinkStreams::Progress& part_;
    Wire& out_;
    Wire& back_;

    Process* sender_ = nullptr; ///< from the start of a part to the acknowledge of its last byte
    Process* receiver_ = nullptr;
    AnyChannel* channel_ = nullptr; ///< whose messages it carries
    LinkFaults* faults_ = nullptr;  ///< null if its link has none
    Time may_start_{};              ///< no byte before this
    Time next_due_{};               ///< when the next packet asks for its wire, or would have if it had not early
    Packet next_ = Packet::none;
    const std::uint8_t number_;     ///< in its link: 0 or 1
    bool every_byte_ = false;       ///< is an event, for a program that writes or reads it, or as a reference
    bool last_part_ = false;        ///< the part under way ends its message
    bool first_byte_waits_ = false; ///< it has arrived, and no process has asked for it
    bool acknowledge_owed_ = false; ///< to the first byte, once a process asks for it
    /// The receiver has been given the part, and either its last byte or that byte's acknowledge is still to come.
    bool taken_ = false;
    bool took_last_part_ = false; ///< the part that was taken last ended its message
    bool stalled_ = false;        ///< the message under way gets no further
    bool unacknowledged_ = false; ///< the byte begun last: its acknowledge has not begun, or is lost
    bool byte_comes_over_ = true; ///< the byte begun last does
    bool last_of_part_ = false;   ///< which is the step of the part under way: arrivals_of_last[...]
    bool receiver_left_ = false;  ///< the receiving end has given up the message under way
    bool left_over_ = false;      ///< the receiving end is in a message that its sender has given up
    bool trace_carries_ = false;  ///< the trace was told that bytes follow each other

    // ... what every message needs, ...
    In input_{*this};
    const PacketTimes& times_;
    Out output_{*this};
    std::array<MemoryOfEngines*, 2> memories_{}; ///< at its ends; null where nobody uses it
    std::uint64_t bytes_carried_ = 0;
    std::uint64_t bytes_before_part_ = 0; ///< of the message under way

    // ... and what few do.
    RegisterUser *writer_ = nullptr, *reader_ = nullptr; ///< null: an engine is at that end
    bool output_given_up_ = false;                       ///< the message under way, by its sender
    bool input_given_up_ = false;                        ///< the same, by its receiver
    bool writable_ = true;                               ///< the register for the next byte
    bool readable_ = false;
    std::uint64_t bytes_left_over_ = 0; ///< how many came of the message that its sender has given up
    std::uint64_t sent_when_given_up_ = 0, taken_when_given_up_ = 0; ///< bytes; until the end is reset
    // Of those carried the ones that travelled before the speed changed last.
    std::uint64_t bytes_at_old_speed_ = 0;
    Time occupied_at_old_speed_{}, old_speed_until_{};
    std::uint64_t bytes_traced_ = 0; ///< of those carried, how many the trace was told of
    std::string name_;
};

/// A link: two wires, each carrying the bytes of one direction and the acknowledges of the other.
class Link final : private WireWatch, private LinkWalker {
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
    void fetch() const { closed_form_.fetch(); }
    /// How many words the engines at this memory have moved before now, of the parts that are under way.
    std::uint64_t words_moved(const MemoryOfEngines& memory, Time now) {
        return memory.words_in(closed_form_.bytes_begun_before(now, 0)) +
               memory.words_in(closed_form_.bytes_begun_before(now, 1));
    }

    /// Adds a fault. REQUIRES: before the run. What it does is found in the effect, which lasts as long as the link.
    /// Throws as LinkFaults::add.
    const FaultEffect& suffer(const LinkFault&);

    /// Its wires lead through something that may stop their packets. REQUIRES: before the run; it outlives the run.
    void lead_through(Passage&);
    /// A passage is about to change.
    void way_changes() {
        closed_form_.leave();
        agenda_.settle();
    }

private:
    LinkFaults& faults();
    void packet_begins() override;
    void take(LinkStep, std::size_t direction) override;
    void plan() override;

    LinkAgenda agenda_;
    ClosedForm closed_form_;
    Kernel& kernel_;
    PacketTimes times_;
    Wire wire_from_a_, wire_from_b_;
    LinkDirection a_to_b_, b_to_a_;
    LinkTiming timing_;
    std::optional<LinkFaults> faults_;
};

} // namespace placedpar::hardware
