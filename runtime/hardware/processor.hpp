#pragma once

#include "runtime/event.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstdint>
#include <string>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

/// The memory that holds a processor's messages, and the other data of its processes.
struct Memory {
    /// Cycles of an access to a word: "external at least 3" (listing of a machine of 64 T800s); 30 Mbyte/s at 30 MHz
    /// (IMS T225 data sheet), the T212, T222 and M212 likewise.
    static constexpr Cycles on_chip{1}, outside{3}, outside_of_a_t2{2}, outside_of_a_t801{2};

    Cycles access = on_chip;
    std::int64_t bytes_in_a_word = 4; ///< 2 in a T2
};

/// A transputer's processor: it shares itself out between its processes by the rules of the hardware
/// scheduler (Transputer Databook, 3rd ed. 1992, architecture 1.3).
///
/// 1. A high-priority process runs until it waits or ends. When one becomes ready, it pre-empts a low one at the end of
///    the instruction that is being executed.
/// 2. Low-priority processes run when no high one can, first in, first out. One that has run for a whole
///    timeslice period goes to the back of the queue at the first descheduling point after the period has ended, if
///    others wait. So one after the other gets the processor shortly after a period has begun, and runs for nearly two.
/// 3. A pre-empted process goes on before the others of its queue.
/// 4. Between two computations or communications a program takes no time, but only the process that has the
///    processor executes it.
/// 5. The engines of its links work beside it, but on the same memory: for each word that one of them moves, a process
///    that computes waits for an access.
class Processor final : public Executive {
public:
    /// 5120 cycles of the 5 MHz input clock (databook), at every clock frequency of the processor.
    static constexpr Time timeslice = std::chrono::nanoseconds{1'024'000};
    /// The periods of the two clocks (INMOS ticks.inc).
    static constexpr Time high_tick = std::chrono::microseconds{1};
    static constexpr Time low_tick = std::chrono::microseconds{64};

    /// 17.5 to 30 MHz models were sold
    static constexpr std::int64_t usual_clock = 20'000'000;

    /// Cycles of a switch to the next process, beyond the instruction that gives the processor up. No table has it.
    /// Genuine code for COMMSTIME takes 282 cycles a loop by the instruction table, and was published as 301.
    static constexpr Cycles usual_switching{0};

    /// `channel_call`: cycles that the program's communication library adds to each input and output, on soft and hard
    /// channels alike; none for occam, which compiles them in line. `switching`: cycles
    /// of a switch to the next process; a process that takes another's place (PAR) and one that goes on after an
    /// interrupt pay none. Throws std::logic_error unless clock_hz > 0, an access takes a cycle or more, a word has 2
    /// or 4 bytes, and switching >= 0.
    Processor(Kernel&, std::string name, std::int64_t clock_hz = usual_clock, Cycles channel_call = Cycles{0},
              const Memory& = {}, Cycles switching = usual_switching);

    /// Adds a link of which one end is this processor's: that end's engines use this processor's memory. REQUIRES: the
    /// link outlives the run.
    void has_link(Link&);
    /// Stops the processor at this time: it executes nothing more, and processes that wait for it wait for ever. Its
    /// links need a fault of their own to fall silent (LinkFault). REQUIRES: before the run.
    void halt_at(Time moment) { halts_at_ = std::min(halts_at_, moment); }
    bool halted() const override;

    std::int64_t clock_hz() const { return clock_.hertz(); }
    /// Returns how long it has computed so far, including waits for its memory.
    Time time_busy() const;
    /// Returns how long its memory has served link engines so far, during computations or not.
    Time memory_taken_by_links();

    Time tick(Priority priority) const override { return priority == Priority::high ? high_tick : low_tick; }
    bool begin_computing(Process&, Cycles, const CodeShape&) override;
    void make_ready(Process&) override;
    /// A successor of the same priority takes the process's place at once, as after startp and endp.
    void leave(Process&, Process* successor) override;

private:
    /// A stretch of time in which one process computes.
    struct Turn final : Event {
        explicit Turn(Processor& p) : processor(p) {}
        void happen() noexcept override { processor.end_turn(); }
        Processor& processor;
    };

    Time duration(Cycles cycles) const { return clock_.duration(static_cast<std::int64_t>(cycles)); }
    std::int64_t words_moved_by_links();
    void dispatch();
    void switch_to(Process&);
    void go_on(Process&);
    void begin_turn();
    void settle();
    void schedule_end();
    void take_turn();
    bool has_low_rivals() const;
    Time end_of_slice() const;
    Time next_point_after_slice() const;
    bool gives_way() const;
    void stop_turn();
    void end_turn();
    void note_computing(const Process&) const;
    void account(const Process&, Time worked);
    void preempt();

    // The members are in the order of use, in lines of the cache: each turn needs all of the first two lines.
    alignas(64) Turn turn_{*this};
    Kernel& kernel_;
    Process* current_ = nullptr; ///< the process that has the processor
    Time turn_began_{};
    Time settled_at_{}; ///< the current process's work up to this time has been subtracted from what is left

    std::int64_t words_settled_ = 0; ///< words_moved_by_links() at that time
    // The last result of words_moved_by_links(). For one time it does not change, unless a part ends.
    Time counted_at_{-1};
    std::uint64_t words_ = 0, ended_when_counted_ = 0;
    LinkEngineMemory engines_;
    Time access_{};    ///< time of an access to a word of its memory
    Time switching_{}; ///< time of a switch to the next process
    Time halts_at_ = Time::max();

    boost::container::small_vector<Link*, 4> links_; ///< a transputer has at most four
    Process* preempted_ = nullptr;                   ///< the low-priority process that was pre-empted

    ProcessQueue high_, low_; ///< the processes that wait for the processor
    Time dispatched_at_{};    ///< when the current low-priority process got the processor
    Time busy_{};             ///< without the current turn
    Clock clock_;
};

} // namespace placedpar::hardware
