#include "runtime/transputer/core_text.hpp"

#include "runtime/transputer/code_text.hpp"
#include "runtime/transputer/waiting.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <bit>
#include <string_view>

namespace placedpar::transputer {
namespace {

constexpr std::size_t most_listed = 1024; // a limit, because a program may turn a queue into a circle

std::string print_real(const Real& real) {
    return real.length == Length::real32
               ? fmt::format("{} (REAL32)", std::bit_cast<float>(static_cast<Word>(real.bits)))
               : fmt::format("{} (REAL64)", std::bit_cast<double>(real.bits));
}

/// Returns the address of a workspace with the name of its process.
std::string print_workspace(Word workspace, const CodeLines& lines) {
    const std::string name = lines.process(workspace);
    return print_address(workspace) + (name.empty() ? "" : " " + name);
}

std::string print_instruction_pointer(Word instruction, const CodeLines& lines) {
    const std::string place = lines.place(instruction - 1);
    return print_address(instruction) + (place.empty() ? "" : " " + place);
}

/// Prints a queue of processes. A word below each workspace holds the address of the next workspace.
class QueuePrinter {
public:
    QueuePrinter(const Core& core, const CodeLines& lines) : core_(core), lines_(lines) {}

    std::string print(std::string_view name, Word front, Word back, Word link) const {
        std::string result = fmt::format("{}:{}\n", name, front == not_a_process ? " empty" : "");
        Word process = front;
        for (std::size_t i = 0; process != not_a_process && i < most_listed; ++i) {
            const Word offset = NodeMemory::offset_of(process) & ~Word{3};
            if (offset < below::time || !core_.memory().holds(offset - below::time, below::time))
                return result + fmt::format("  {} is not a workspace\n", print_address(process));
            const bool timer = link == below::timer_link;
            result += fmt::format("  Wptr {}  Iptr {}{}\n", print_workspace(process, lines_),
                                  print_instruction_pointer(core_.memory().word(offset - below::instruction), lines_),
                                  timer ? fmt::format("  until {}", core_.memory().word(offset - below::time)) : "");
            if (process == back)
                break;
            process = core_.memory().word(offset - link);
        }
        return result;
    }

private:
    const Core& core_;
    const CodeLines& lines_;
};

std::string print_flags(const Core& core) {
    const auto flag = [](bool set, const char* name) { return fmt::format("{}{}", set ? "" : "no ", name); };
    std::string result =
        fmt::format("flags: {}, {}, {}", flag(core.has_error(1), "Error at low priority"),
                    flag(core.has_error(0), "Error at high priority"), flag(core.halts_on_error(), "HaltOnError"));
    if ((only(core.model()) & with_reals) != 0)
        result += ", " + flag(core.fpu().error(), "FPError");
    return result + "\n";
}

std::string print_wait(const Core& core, const WaitingProcess& process, const CodeLines& lines) {
    constexpr std::string_view waits[] = {"inputs", "outputs", "is in an ALT", "waits for its timer"};
    const Instruction& last = description_of(instruction_before(core, process.instruction).instruction.operation);
    std::string result =
        fmt::format("  Wptr {}, {} priority, Iptr {} after {}: {}", print_workspace(process.workspace, lines),
                    process.priority == 0 ? "high" : "low", print_instruction_pointer(process.instruction, lines),
                    last.name, waits[static_cast<std::size_t>(process.wait)]);
    for (const Word channel : process.channels)
        result += fmt::format("{} {}", channel == process.channels.front() ? ", its descriptor is at" : " and",
                              print_channel(channel));
    if (process.wait == Wait::alternative && process.channels.empty() && !process.time)
        result += " without a true guard";
    if (process.time)
        result += fmt::format(", until its clock is after {}", signed_of(*process.time));
    return result + "\n";
}

} // namespace

std::string print_word(Word value) { return fmt::format("#{:08X} {:>12}", value, signed_of(value)); }

std::string print_channel(Word channel) {
    const int number = hard_channel(channel);
    return number < 0    ? print_address(channel)
           : number == 8 ? "event"
           : number < 4  ? fmt::format("link {} output", number)
                         : fmt::format("link {} input", number - 4);
}

std::string print_registers(const Core& core) {
    const Registers& r = core.registers();
    const std::string result =
        fmt::format("Iptr {}  Wptr {}  priority {}, {}{}\nA {}  B {}  C {}\nclocks: high {}, low {}\n",
                    print_address(r.instruction), print_address(r.workspace), core.high_priority() ? "high" : "low",
                    r.error ? "Error" : "no Error", core.halts_on_error() ? ", HaltOnError" : "", print_word(r.a),
                    print_word(r.b), print_word(r.c), core.clock(0), core.clock(1));
    if ((only(core.model()) & with_reals) == 0)
        return result;
    const Fpu& fpu = core.fpu();
    return result +
           fmt::format("FA {}  FB {}  FC {}\n", print_real(fpu.fa()), print_real(fpu.fb()), print_real(fpu.fc()));
}

std::string print_queues(const Core& core, const CodeLines& lines) {
    const QueuePrinter queue(core, lines);
    const auto head = [&core](Word address) { return core.memory().word(NodeMemory::offset_of(address)); };
    std::string result = queue.print("high priority", core.front(0), core.back(0), below::link) +
                         queue.print("low priority", core.front(1), core.back(1), below::link);
    for (const Word priority : {0u, 1u})
        result += queue.print(priority == 0 ? "timer, high" : "timer, low", head(reserved::timer_heads + 4 * priority),
                              not_a_process, below::timer_link);
    for (Word channel = most_negative; channel < most_negative + 4 * hard_channels; channel += 4)
        if (const Word waiting = head(channel); waiting != not_a_process)
            result += fmt::format("{}: Wdesc {}\n", print_channel(channel), print_address(waiting));
    if (head(reserved::saved) != not_a_process)
        result += fmt::format("interrupted: Wdesc {}  Iptr {}\n", print_address(head(reserved::saved)),
                              print_address(head(reserved::saved + 4)));
    return result;
}

std::string print_analysis(const Core& core, const CodeLines& lines) {
    std::string result =
        core.is_running() ? "" : "no process runs: the registers still hold the values of the last process\n";
    result += print_registers(core) + print_flags(core) + print_queues(core, lines);
    const std::vector<WaitingProcess> waiting = waiting_processes(core);
    result += fmt::format("waiting:{}\n", waiting.empty() ? " none" : "");
    for (const WaitingProcess& each : waiting)
        result += print_wait(core, each, lines);
    return result;
}

} // namespace placedpar::transputer
