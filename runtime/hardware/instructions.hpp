#pragma once

#include "runtime/time.hpp"

#include <cstdint>

/// What the instructions of a T800 cost that a process's communications come to, in cycles, code and data in
/// internal memory. Published: instruction table of the T4 notebook (pahihu/t4), checked there against INMOS's
/// "Transputer instruction set: a compiler writer's guide".
namespace placedpar::instructions {

constexpr std::int64_t bytes_in_a_word = 4;

constexpr Cycles input_or_output{19}; ///< in, out: 2w + 19 for w words
constexpr Cycles copied_word{2};      ///< ... of which the second process to arrive pays for the copy
constexpr Cycles start_process{12};   ///< startp
constexpr Cycles end_process{13};     ///< endp
constexpr Cycles load_timer{2};       ///< ldtimer
constexpr Cycles timer_input{30};     ///< tin, when it has to wait
constexpr Cycles timer_input_past{4}; ///< ... when the time has come already
constexpr Cycles alt_start{2};        ///< alt
constexpr Cycles enable_guard{7};     ///< enbc, enbs
constexpr Cycles enable_timeout{8};   ///< enbt
constexpr Cycles alt_wait_ready{5};   ///< altwt when a guard is ready
constexpr Cycles alt_wait{17};        ///< altwt when none is
constexpr Cycles disable_guard{8};    ///< disc, diss
constexpr Cycles disable_timeout{23}; ///< dist
constexpr Cycles alt_end{4};          ///< altend

/// Interrupt latency from low to high priority, typical; 58 at most, 78 while the floating-point unit is busy.
constexpr Cycles preemption{19};

/// What a channel operation of the INMOS C toolset (ChanOut, ChanIn) costs beyond its instruction: for
/// processors whose programs are written in C. Derived: half the round trip of a message of n words between
/// two T805s took 11.0 + 2.250 n us (sarevok/pr, Poznan 2008); 11.0 us are 220 cycles at 20 MHz, of which 19
/// are the instruction's. It includes the rescheduling of the receiver.
constexpr Cycles toolset_channel_call{201};

} // namespace placedpar::instructions
