#pragma once

#include "runtime/transputer/core.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// Finds the waiting processes of an emulated transputer in its memory, for the report of a deadlock.
namespace placedpar::transputer {

/// What a process waits for.
enum class Wait : std::uint8_t { input, output, alternative, timer };

struct WaitingProcess {
    Word workspace = not_a_process;
    int priority = 1;
    Word instruction = 0; ///< Iptr: the address at which the process continues
    Wait wait = Wait::timer;
    /// The addresses of the channels for which the process waits: one channel, or the channels of an ALT. A channel's
    /// word holds the descriptor (workspace and priority) of the process. For an ALT without a true guard there are no
    /// channels, and the priority is not known.
    std::vector<Word> channels{};
    std::optional<Word> time{}; ///< if the process waits for a time: the value of its clock after which the process
                                ///< continues
};

/// Returns the processes that wait, in the order of their workspaces.
///
/// Processes that wait for a timer or a link are found in the timer queues and in the channel words of links. For other
/// processes, the memory is searched for words that hold the descriptor of a process, that is, its workspace and
/// priority. Such a word counts as a channel under these conditions. The workspace is in the memory, and the process
/// neither runs nor is ready. Its saved Iptr follows an instruction that waits, in code that was executed. The word W-3
/// has a value that this instruction leaves there. Where possible, the address of the channel is computed from the code
/// before the instruction, and only the word at this address counts. Where this is not possible, as in an ALT with a
/// loop, a copy of a descriptor may be mistaken for a channel.
///
/// A process in an ALT without a true guard is found by the state of the ALT below its workspace. A process that waits
/// for nothing, as after stopp, is not found, because no word refers to it.
std::vector<WaitingProcess> waiting_processes(const Core&);

/// Returns the workspaces in a queue of ready processes, the front first. The result ends early if the queue leads out
/// of memory.
std::vector<Word> ready_processes(const Core&, int priority);

/// An instruction with its place.
struct PlacedInstruction {
    Word address = 0;
    CodedInstruction instruction{};
};
/// Returns the instruction that ends before an address, with all its prefixes; `unknown` if there is none.
PlacedInstruction instruction_before(const Core&, Word address);

/// An end of a channel.
struct ChannelEnd {
    Word channel;
    bool is_output;
    friend bool operator==(const ChannelEnd&, const ChannelEnd&) = default;
};
/// Returns the channel ends at which a process would communicate next if its present wait and all later waits ended at
/// once. With these ends a deadlock report can name the partner of a process that waits. To find them, a copy of the
/// transputer executes at most some thousand instructions of the process. In an ALT, the copy chooses the first guard
/// without a condition or with a true one. REQUIRES: at most 64 Mbyte of memory.
std::vector<ChannelEnd> ends_ahead(const Core&, const WaitingProcess&);
inline constexpr Word most_copied_bytes = 64 * 1024 * 1024;

} // namespace placedpar::transputer
