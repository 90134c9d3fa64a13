#include "runtime/transputer/stepper.hpp"

#include "runtime/transputer/code_text.hpp"
#include "runtime/transputer/core_text.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

namespace placedpar::transputer {
namespace {

constexpr std::uint64_t for_ever = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t most_shown = 1024; // lines; a limit, because a faulty program can turn a queue into a circle

constexpr std::string_view commands_of_stepper =
    "s [N]          execute N instructions; without N: one\n"
    "c              continue to a breakpoint\n"
    "b [ADDRESS]    set a breakpoint before an instruction, or delete it; without ADDRESS: list all\n"
    "r              registers\n"
    "w [N]          words of the workspace, up to W+N\n"
    "q              queues of processes and timers, and the words of links where processes wait\n"
    "m ADDRESS [N]  words of memory\n"
    "l [N]          the next N lines of code; without N: 10\n"
    "quit           end the run\n";

std::optional<std::uint64_t> number_in(std::string_view text, int base) {
    std::uint64_t result = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result, base);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(result) : std::nullopt;
}

std::optional<Word> address_in(std::string_view text) {
    if (text.starts_with('#'))
        text.remove_prefix(1);
    const auto result = number_in(text, 16);
    return result && *result <= 0xffff'ffff ? std::optional(static_cast<Word>(*result)) : std::nullopt;
}

} // namespace

Stepper::Stepper(Core& core, const CodeLines& lines, std::istream& commands,
                 std::function<void(std::string_view)> print)
    : core_(core), lines_(lines), commands_(commands), print_(std::move(print)) {
    core.watch(this);
}

void Stepper::begins(Word at) {
    if (has_left_ || (--steps_ > 0 && !breaks_.contains(at)))
        return;
    print_(fmt::format("{}  {}\n", to_string(core_.local_time()), here()));
    for (std::string line; std::getline(commands_, line);)
        if (obey(line))
            return;
    has_left_ = true;
}

bool Stepper::obey(const std::string& line) {
    std::istringstream words_of_line(line);
    std::string command, first, second;
    words_of_line >> command >> first >> second;
    const auto count = number_in(first, 10), words_asked = number_in(second, 10);
    steps_ = for_ever;
    if (command.empty())
        return false;
    if (command == "quit")
        return has_left_ = true;
    if (command == "c")
        return true;
    if (command == "s" && (first.empty() || count.value_or(0) > 0)) {
        steps_ = count.value_or(1);
        return true;
    }
    if (command == "b")
        break_at(first);
    else if (command == "r")
        print_(print_registers(core_));
    else if (command == "w")
        print_(workspace(count.value_or(8)));
    else if (command == "q")
        print_(print_queues(core_, lines_));
    else if (command == "m" && address_in(first))
        print_(words(*address_in(first), words_asked.value_or(8)));
    else if (command == "l")
        print_(code(count.value_or(10)));
    else
        print_(fmt::format("\"{}\" is not a command. The commands are:\n{}", line, commands_of_stepper));
    return false;
}

void Stepper::break_at(const std::string& address) {
    const auto at = address_in(address);
    if (!at && !address.empty())
        return print_(fmt::format("\"{}\" is not an address such as #80000070\n", address));
    if (at && breaks_.erase(*at) == 0)
        breaks_.insert(*at);
    std::string list;
    for (const Word each : breaks_)
        list += " " + print_address(each);
    print_(fmt::format("breakpoints:{}\n", list.empty() ? " none" : list));
}

/// Returns a text that shows the next instruction.
std::string Stepper::here() const {
    const Word at = core_.registers().instruction, offset = NodeMemory::offset_of(at), size = core_.memory().size();
    if (offset >= size)
        return fmt::format("{} is outside of the memory", print_address(at));
    const auto bytes = core_.memory().bytes(offset, size - offset);
    const CodedInstruction instruction = read_instruction(bytes, core_.model());
    const bool branches = branches_by_operand(instruction.operation);
    const std::string place = lines_.place(at);
    return fmt::format(
        "{}  {}  {}{}{}", print_address(at), print_bytes(bytes.first(instruction.length)),
        print_instruction(instruction, branches ? print_address(at + instruction.length + instruction.operand) : ""),
        place.empty() ? "" : "   -- ", place);
}

std::string Stepper::code(std::uint64_t lines) const {
    constexpr Word bytes_of_line = 16;
    const Word at = core_.registers().instruction, offset = NodeMemory::offset_of(at), size = core_.memory().size();
    if (offset >= size)
        return fmt::format("  {} is outside of the memory\n", print_address(at));
    const auto count = static_cast<Word>(std::min(lines, most_shown));
    return print_memory(core_.memory().bytes(offset, std::min(size - offset, bytes_of_line * count)), at,
                        std::span(&at, 1), core_.model(), count);
}

std::string Stepper::workspace(std::uint64_t words) const {
    const Word base = core_.registers().workspace;
    std::string result;
    for (std::int64_t i = -5; i <= static_cast<std::int64_t>(std::min(words, most_shown)); ++i) {
        const Word address = base + 4 * static_cast<Word>(i), offset = NodeMemory::offset_of(address) & ~Word{3};
        if (core_.memory().holds(offset, 4))
            result += fmt::format("W{:+} {}  {}\n", i, print_address(address), print_word(core_.memory().word(offset)));
    }
    return result;
}

std::string Stepper::words(Word address, std::uint64_t count) const {
    std::string result;
    for (Word i = 0; i < std::min(count, most_shown); ++i) {
        const Word offset = NodeMemory::offset_of(address + 4 * i) & ~Word{3};
        if (!core_.memory().holds(offset, 4))
            return result + fmt::format("{} is outside of the memory\n", print_address(address + 4 * i));
        result +=
            fmt::format("{}  {}\n", print_address(most_negative + offset), print_word(core_.memory().word(offset)));
    }
    return result;
}

} // namespace placedpar::transputer
