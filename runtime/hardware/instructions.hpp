#pragma once

#include "runtime/executive.hpp"

/// The costs of a T800's instructions in cycles, with code and data in internal memory. The source is the instruction
/// table of the T4 notebook (pahihu/t4), which was checked there against INMOS's "Transputer instruction set: a
/// compiler writer's guide".
namespace placedpar::hardware::instructions {

/// The costs of occam's operations, which are compiled in line. On a soft channel, a communication of w words costs the
/// process that arrives second 2w + 19 cycles, and the other process 19 cycles. An output of one word costs 23 cycles
/// in both cases.
constexpr OperationCosts t800{
    .soft_communication = Cycles{19},    // in, out
    .soft_word_output = Cycles{23},      // outword, outbyte
    .hard_communication = Cycles{19},    // in, out
    .copied_word = Cycles{2},            // in, out
    .bytes_in_a_word = 4,                //
    .start_component = Cycles{12},       // startp
    .run_component = Cycles{10},         // runp
    .end_component = Cycles{13},         // endp
    .timer_read = Cycles{2},             // ldtimer
    .timer_wait = Cycles{30},            // tin
    .timer_wait_past = Cycles{4},        // tin
    .alternation_start = Cycles{2},      // alt
    .enable_guard = Cycles{7},           // enbc, enbs
    .enable_guard_not_ready = Cycles{5}, // enbc
    .enable_timeout = Cycles{8},         // enbt
    .alternation_wait_ready = Cycles{5}, // altwt
    .alternation_wait = Cycles{17},      // altwt
    .disable_guard = Cycles{8},          // disc, diss
    .disable_timeout = Cycles{23},       // dist
    .alternation_end = Cycles{4},        // altend
    // Our choice: a communication that may be given up starts a second process, which waits for the time-out or a
    // message, and ends (startp, tin, endp).
    .attempt = Cycles{12 + 30 + 13},
    .reset_channel = Cycles{3}, // our choice: the instruction resetch
};

/// The cycles of a block move (`move`) before its first word. Each word then takes 2 cycles on the chip, or two
/// accesses to memory outside of the chip.
constexpr Cycles block_move_start{8};

/// The typical time in which a high-priority process interrupts a low-priority process. The longest time is 58 cycles,
/// or 78 cycles while the floating-point unit is busy.
constexpr Cycles preemption{19};

/// The cycles that ChanOut or ChanIn of the INMOS C toolset takes beyond the instruction `out` or `in`. Use it for
/// processors whose programs are written in C. It is derived from a measurement (sarevok/pr, Poznan 2008): half the
/// round trip of a message of n words between two T805s took 11.0 + 2.250 n us. 11.0 us are 220 cycles at 20 MHz, and
/// the instruction takes 19 of them. The figure includes the time until the receiver has the processor again.
constexpr Cycles toolset_channel_call{201};

} // namespace placedpar::hardware::instructions
