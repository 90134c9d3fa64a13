#pragma once

#include "runtime/transputer/core.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// Finds the waiting processes of a node in its memory.
namespace placedpar::transputer {

/// What a process waits for.
enum class Wait : std::uint8_t { input, output, alternative, timer };

struct WaitingProcess {
    Word workspace = not_a_process;
    int priority = 1;
    Word instruction = 0; ///< Iptr: the address at which the process continues
    Wait wait = Wait::timer;
    /// The addresses of the channel words that hold the process's descriptor: one word, or the words of an ALT's
    /// channels. For an ALT without a true guard there are none, and the priority is not known.
    std::vector<Word> channels{};
    std::optional<Word> time{}; ///< the value of its clock after which the process continues, if it is in a timer queue
};

/// Returns the processes that wait, in the order of their workspaces.
///
/// Processes that wait for a timer or a link are found in the timer queues and in the channel words of links. For other
/// processes, the memory is searched for words that hold the descriptor of a process. The workspace of this process
/// must be in the memory, and the process must neither run nor be ready. Its saved Iptr must follow an instruction that
/// waits, in code that was executed. The word W-3 must have a value that this instruction leaves there. If the code
/// before the instruction only loads, computes addresses and enables the guards of an ALT, the address of the channel
/// is computed from this code. The word at this address must then hold the descriptor, and no other word counts as a
/// channel. Otherwise, as in an ALT with a loop, a copy of a descriptor may be mistaken for a channel. A process in an
/// ALT without a true guard is found by the state of the ALT in the words below its workspace. A process that waits for
/// nothing, as after stopp, is not found, because no word refers to it.
std::vector<WaitingProcess> waiting_processes(const Core&);

/// Returns the workspaces in a queue of ready processes, the front first. The result ends early if the queue leads out
/// of memory.
std::vector<Word> ready_processes(const Core&, int priority);

/// An instruction with its place.
struct PlacedInstruction {
    Word address = 0;
    CodedInstruction instruction{};
};
/// Returns the instruction that ends before an address; `unknown` if there is none. The result is unique, because
/// prefixes belong to the instruction that follows them.
PlacedInstruction instruction_before(const Core&, Word address);

/// An end of a channel.
struct ChannelEnd {
    Word channel;
    bool is_output;
    friend bool operator==(const ChannelEnd&, const ChannelEnd&) = default;
};
/// Returns the channel ends at which a process would communicate next if its present wait and all later waits ended at
/// once, without a message. To find them, a copy of the node executes the process's code, at most some thousand
/// instructions. In an ALT, the copy chooses the first guard that has no condition or a true condition. REQUIRES: at
/// most 64 Mbyte of memory.
std::vector<ChannelEnd> ends_ahead(const Core&, const WaitingProcess&);
inline constexpr Word most_copied_bytes = 64 * 1024 * 1024;

} // namespace placedpar::transputer
