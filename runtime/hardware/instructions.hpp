#pragma once

#include "runtime/executive.hpp"

/// The costs of a T800's instructions in cycles, with code and data in internal memory. Published: instruction table of
/// the T4 notebook (pahihu/t4), which was checked there against INMOS's "Transputer instruction set: a compiler
/// writer's guide".
namespace placedpar::hardware::instructions {

/// The costs of a program's operations, compiled in line as occam compiles them. A communication of w words costs 2w +
/// 19 cycles for the process that copies them and 19 cycles for the process that waits. An output of one word costs 23
/// cycles for either process.
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
    // Ours: an attempt starts a second process, which waits for the time-out or for a message, then ends the attempt
    // and itself: startp, tin, endp.
    .attempt = Cycles{12 + 30 + 13},
    .reset_channel = Cycles{3}, // ours: resetch
};

/// The cycles of a block move before its first word. Each word takes 2 cycles on the chip, or two accesses outside of
/// the chip.
constexpr Cycles block_move_start{8};

/// The typical interrupt latency from low to high priority. At most it is 58 cycles, or 78 while the floating-point
/// unit is busy.
constexpr Cycles preemption{19};

/// The cycles of a channel operation of the INMOS C toolset (ChanOut, ChanIn) beyond its instruction, for processors
/// whose programs are written in C. Derived: half the round trip of a message of n words between two T805s took 11.0 +
/// 2.250 n us (sarevok/pr, Poznan 2008). 11.0 us are 220 cycles at 20 MHz; the instruction takes 19 of them. The
/// rescheduling of the receiver is included.
constexpr Cycles toolset_channel_call{201};

} // namespace placedpar::hardware::instructions
