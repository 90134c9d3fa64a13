#pragma once

#include "runtime/transputer/core.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// The processes of a node that wait, as its memory tells them.
namespace placedpar::transputer {

/// What a process waits for.
enum class Wait : std::uint8_t { input, output, alternative, timer };

struct WaitingProcess {
    Word workspace = not_a_process;
    int priority = 1;
    Word instruction = 0; ///< Iptr: the address at which it goes on
    Wait wait = Wait::timer;
    /// The addresses of the channel words that hold its descriptor: one, or those of an ALT; none of an ALT without a
    /// true guard, whose priority is not known.
    std::vector<Word> channels{};
    std::optional<Word> time{}; ///< the value of its clock after which it goes on, if it is in a timer queue
};

/// Returns the processes that wait, by their workspaces.
///
/// The timer queues and the channel words of links tell theirs. For the others, the memory is searched for words that
/// hold a descriptor. Its workspace must lie in the memory, and its process must neither run nor be ready. Its saved
/// Iptr must follow an instruction that waits, in code that was executed; the word W-3 must be what this instruction
/// leaves there. The address of the channel is computed from the code before the instruction where that only loads,
/// computes addresses, and enables the guards of an ALT; the word there must hold the descriptor, and no other word is
/// taken. Otherwise, as in an ALT with a loop, a copy of a descriptor may be taken for a channel.
/// A process in an ALT without a true guard is found by the state of the ALT, which it keeps in words of its own. A
/// process that waits for nothing, as after stopp, is not found: no word refers to it.
std::vector<WaitingProcess> waiting_processes(const Core&);

/// Returns the workspaces in a queue of ready processes, the front first. It ends early where it leads out of memory.
std::vector<Word> ready_processes(const Core&, int priority);

/// An instruction with its place.
struct PlacedInstruction {
    Word address = 0;
    CodedInstruction instruction{};
};
/// Returns the instruction that ends before an address; `unknown` if there is none. It is unique, since prefixes belong
/// to the instruction that follows them.
PlacedInstruction instruction_before(const Core&, Word address);

/// An end of a channel.
struct ChannelEnd {
    Word channel;
    bool is_output;
    friend bool operator==(const ChannelEnd&, const ChannelEnd&) = default;
};
/// Returns the ends of channels that a process would come to next, if its wait and those that follow ended at once and
/// brought nothing: a copy of the node executes its code, at most some thousand instructions. In an ALT it takes the
/// first guard that has no condition or a true one. REQUIRES: at most 64 Mbyte of memory.
std::vector<ChannelEnd> ends_ahead(const Core&, const WaitingProcess&);
inline constexpr Word most_copied_bytes = 64 * 1024 * 1024;

} // namespace placedpar::transputer
