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

/// The memory that holds the messages and the other data of a processor's processes.
struct Memory {
    /// The cycles of an access to a word. `outside`: memory outside of the chip; INMOS's program ispy lists "external
    /// at least 3" for a machine of 64 T800s. `outside_of_a_t2`: a T2 moves 30 Mbyte/s at 30 MHz (IMS T225 data sheet;
    /// the data sheets of T212, T222 and M212 agree).
    static constexpr Cycles on_chip{1}, outside{3}, outside_of_a_t2{2}, outside_of_a_t801{2};

    Cycles access = on_chip;
    std::int64_t bytes_in_a_word = 4; ///< 2 in a T2
};

/// A transputer's processor, which executes processes in C++. It schedules them by the rules of the hardware scheduler
/// (Transputer Databook, 3rd ed. 1992, architecture 1.3).
///
/// 1. A high-priority process runs until it waits or ends. When it becomes ready, it pre-empts a low-priority process
/// at the end of the current instruction.
/// 2. Low-priority processes run when no high-priority process can, first in, first out. The clock divides the time
/// into timeslice periods. A process gives way to other low-priority processes at its first descheduling point after it
/// has had the processor for a whole period, from start to end. Since the process began shortly after the start of a
/// period, it runs for nearly two periods.
/// 3. A pre-empted process continues before the other processes of its queue.
/// 4. Between two computations or communications a program takes no time. Only the process that has the processor
/// executes its program.
/// 5. The engines of the links work in parallel on the same memory. A computing process waits for one access for each
/// word that an engine moves.
class Processor final : public Executive {
public:
    /// The timeslice period: 5120 cycles of the 5 MHz input clock (databook). It does not depend on the frequency of
    /// the processor.
    static constexpr Time timeslice = std::chrono::nanoseconds{1'024'000};
    /// The periods of the two clocks (INMOS ticks.inc).
    static constexpr Time high_tick = std::chrono::microseconds{1};
    static constexpr Time low_tick = std::chrono::microseconds{64};

    /// The usual clock frequency in Hz. Models were sold with 17.5 to 30 MHz.
    static constexpr std::int64_t usual_clock = 20'000'000;

    /// The cycles of a switch to the next process, beyond the instruction that gives up the processor. No published
    /// table states them. Without them, one loop of the benchmark COMMSTIME in a transputer's own code takes 282 cycles
    /// by the instruction table; the published figure is 301 cycles.
    static constexpr Cycles usual_switching{0};

    /// `channel_call`: cycles that a library, such as that of C, adds to each input and output. It is 0 for occam,
    /// which compiles inputs and outputs in line. `switching`: cycles of a switch to the next process. The switch is
    /// free if a process takes another process's place in a PAR, or continues after an interrupt. Throws
    /// std::logic_error unless clock_hz > 0, an access takes at least one cycle, a word has 2 or 4 bytes, and switching
    /// >= 0.
    Processor(Kernel&, std::string name, std::int64_t clock_hz = usual_clock, Cycles channel_call = Cycles{0},
              const Memory& = {}, Cycles switching = usual_switching);

    /// Adds a link, one end of which is at this processor. The engines at this end use the processor's memory.
    /// REQUIRES: the link outlives the run.
    void has_link(Link&);
    /// Stops the processor at this time, as a fault. From then on it executes nothing, and processes that wait for its
    /// processes wait for ever. Its links continue to work. REQUIRES: the run has not begun.
    void halt_at(Time moment) { halts_at_ = std::min(halts_at_, moment); }
    bool halted() const override;

    std::int64_t clock_hz() const { return clock_.hertz(); }
    /// Returns how long the processor has computed so far, including waits for its memory.
    Time time_busy() const;
    /// Returns how long the memory has served link engines so far, whether or not a process was computing.
    Time memory_taken_by_links();

    Time tick(Priority priority) const override { return priority == Priority::high ? high_tick : low_tick; }
    bool begin_computing(Process&, Cycles, const CodeShape&) override;
    void make_ready(Process&) override;
    /// If the successor has the same priority as the process, it takes the process's place at once, as after startp and
    /// endp.
    void leave(Process&, Process* successor) override;

private:
    /// An interval in which one process computes.
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

    // Each turn of a process needs all members of the first two cache lines.
    alignas(64) Turn turn_{*this};
    Kernel& kernel_;
    Process* current_ = nullptr; ///< the process that has the processor
    Time turn_began_{};
    Time settled_at_{}; ///< the work of the current process up to this time has been subtracted from its remaining work

    std::int64_t words_settled_ = 0; ///< words_moved_by_links() at the time settled_at_
    // The last result of words_moved_by_links(), and its time. At the same time, the result changes only if a part of a
    // message ends.
    Time counted_at_{-1};
    std::uint64_t words_ = 0, ended_when_counted_ = 0;
    LinkEngineMemory engines_;
    Time access_{};    ///< time of an access to a word of the memory
    Time switching_{}; ///< time of a switch to the next process
    Time halts_at_ = Time::max();

    boost::container::small_vector<Link*, 4> links_; ///< a transputer has at most four links
    Process* preempted_ = nullptr;                   ///< low-priority process that was pre-empted

    ProcessQueue high_, low_; ///< processes that wait for the processor
    Time dispatched_at_{};    ///< time at which the current low-priority process got the processor
    Time busy_{};             ///< total time of earlier turns
    Clock clock_;
};

} // namespace placedpar::hardware
