#pragma once

#include "runtime/random.hpp"
#include "runtime/time.hpp"
#include "runtime/transputer/fpu.hpp"
#include "runtime/transputer/instruction.hpp"
#include "runtime/transputer/model.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace placedpar::transputer {

/// A number of half cycles of the processor's clock, the unit of time in a core. Half cycles are needed for code
/// outside of the chip: fetching a word of code costs half the additional cycles of an access.
using HalfCycles = std::uint64_t;

/// The registers that a process can see. A, B and C are undefined after a change of process, as on the machine.
struct Registers {
    Word instruction = most_negative; ///< Iptr, an address
    Word workspace = most_negative;   ///< Wptr, an address
    Word a = 0, b = 0, c = 0;
    bool error = false;
};

/// The reason why a core no longer executes; `nothing` if it executes.
enum class Stopped : std::uint8_t { nothing, by_error, by_unknown_instruction, by_bad_address, by_break, by_analyse };

/// An instruction that set Error, and the registers before it.
struct ErrorNote {
    Word after = 0; ///< address of the next instruction
    Word workspace = not_a_process;
    Word a = 0, b = 0, c = 0;
};

/// An instruction that changes queues or uses links. It is interruptible: its cycles pass before its effect.
struct Pending {
    Operation operation;
    HalfCycles left;
    bool begun = true; ///< false: its cycles are not known yet, because they depend on the time at which it begins
    // The following members are for a Core::Watcher.
    Word at = 0;
    HalfCycles spent = 0; ///< the cycles known so far
};

/// The state of a core, that is, an emulated processor, without its memory: registers, queues, flags and clocks. A core
/// executes ahead of the simulation, and saves a copy of its state so that it can return. Core is derived from this
/// struct, so the members have the names of members.
struct CoreState {
    Registers registers_;
    int priority_ = 1;
    bool running_ = false, was_running_ = false; ///< was_running_: whether a process ran when the core stopped
    bool halts_on_error_ = false;
    bool analysed_ = false, breaks_at_j0_ = false;
    bool is_analysed_ = false; ///< the analyse pin is set
    Stopped stopped_ = Stopped::nothing;
    Word stopped_at_ = 0;              ///< the invalid address
    bool other_error_ = false;         ///< Error of the interrupted process
    std::array<ErrorNote, 2> noted_{}; ///< for each priority, the instruction that has set its Error
    std::size_t errors_ = 0;           ///< number of processes that errors stopped
    Fpu fpu_, interrupted_fpu_;
    HalfCycles fpu_free_ = 0;    ///< time at which the floating-point unit has finished
    std::array<Word, 3> move_{}; ///< set by move2dinit: rows, stride of the target, stride of the source

    std::array<Word, 2> front_{not_a_process, not_a_process}, back_{not_a_process, not_a_process};
    std::optional<RandomStream> shuffle_; ///< set if the queues are shuffled
    std::optional<Pending> pending_, interrupted_pending_;
    bool clocks_run_ = false;
    Word clock_start_ = 0;
    Time clocks_since_{};
    std::array<bool, 2> timers_disabled_{};
    Time next_timer_ = Time::max(), slice_ends_{};
    Operation begun_{};   ///< the instruction of the scheduler at which execute() returned
    int slices_seen_ = 0; ///< ends of timeslice periods since the running process got the processor
    int interrupted_slices_ = 0;

    Time origin_{};
    HalfCycles local_ = 0, due_ = 0, on_time_at_ = 0;
    HalfCycles busy_before_ = 0;
    std::uint64_t instructions_ = 0;
    Word last_fetched_ = 1; ///< address of the word of code that was fetched last; odd: none
};

} // namespace placedpar::transputer
