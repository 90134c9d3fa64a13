#include "runtime/transputer/listing.hpp"

#include "runtime/transputer/code_text.hpp"
#include "runtime/transputer/disassembler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace placedpar::transputer {
namespace {

constexpr std::size_t most_versions = 8; // at one address; a program may rewrite its code without end
constexpr std::size_t most_hot_blocks = 10;

Word end_of(const Listing::Line& line) { return line.address + line.instruction.length; }

/// Instructions that were executed one after the other.
struct ListedBlock {
    std::span<const Listing::Line> lines;
    HalfCycles spent = 0;
};

/// Returns for each instruction the address to which it leads or refers.
std::vector<std::optional<Word>> targets_of(std::span<const Listing::Line> lines) {
    std::vector<std::optional<Word>> result;
    std::array<CodeLine, 2> before{}; // the last line first
    for (const auto& line : lines) {
        if (before[0].at + before[0].instruction.length != line.address)
            before = {};
        CodeLine code{.at = line.address, .content = Content::code, .instruction = line.instruction};
        find_target(code, before);
        result.push_back(code.target);
        before = {code, before[0]};
    }
    return result;
}

std::vector<ListedBlock> blocks_of(std::span<const Listing::Line> lines, std::span<const std::optional<Word>> targets) {
    const std::set<std::optional<Word>> all(targets.begin(), targets.end());
    std::vector<ListedBlock> blocks;
    for (std::size_t i = 0, begin = 0; i < lines.size(); ++i) {
        const auto& line = lines[i];
        const bool goes_on = i + 1 < lines.size() && lines[i + 1].address == end_of(line) &&
                             lines[i + 1].times == line.times && lines[i + 1].is_replaced == line.is_replaced &&
                             !all.contains(end_of(line)) && !leads_away(line.instruction.operation);
        if (goes_on)
            continue;
        const auto block = lines.subspan(begin, i + 1 - begin);
        blocks.push_back({block, std::accumulate(block.begin(), block.end(), HalfCycles{0},
                                                 [](HalfCycles sum, const auto& each) { return sum + each.spent; })});
        begin = i + 1;
    }
    return blocks;
}

/// Returns a number of cycles as a text with commas. Half cycles occur only if code was fetched from outside of the
/// chip.
std::string print_cycles_of(HalfCycles half_cycles) {
    std::string result = fmt::format("{}", half_cycles / 2);
    for (std::size_t i = result.size(); i > 3; i -= 3)
        result.insert(i - 3, ",");
    return result + (half_cycles % 2 ? ".5" : "");
}

std::string print_times(std::uint64_t times) { return print_cycles_of(2 * times); }

double percent(HalfCycles part, HalfCycles all) {
    return all == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(all);
}

std::string print_hot_blocks(std::vector<ListedBlock> blocks, HalfCycles all) {
    std::ranges::stable_sort(blocks, [](const auto& a, const auto& b) { return a.spent > b.spent; });
    blocks.resize(std::min(blocks.size(), most_hot_blocks));
    std::string result = fmt::format("\n{:>7}  {:>17}  {:>15}  {}\n", "share", "cycles", "times", "block");
    for (const ListedBlock& block : blocks)
        result +=
            fmt::format("{:>5.1f} %  {:>17}  {:>15}  {} to {}\n", percent(block.spent, all),
                        print_cycles_of(block.spent), print_times(block.lines.front().times),
                        print_address(block.lines.front().address), print_address(end_of(block.lines.back()) - 1));
    return result;
}

std::string print_line(const Listing::Line& line, const std::optional<Word>& target, HalfCycles all) {
    const std::string address = target ? print_address(*target) : "";
    return fmt::format("{}  {:<17}  {:<20} {:>15}  {:>17}  {:>5.1f} %", print_address(line.address),
                       print_bytes(line.bytes), print_instruction(line.instruction, address), print_times(line.times),
                       print_cycles_of(line.spent), percent(line.spent, all));
}

/// Prints blocks with names of procedures and places in files.
class BlockPrinter {
public:
    BlockPrinter(const CodeLines& lines, HalfCycles all) : lines_(lines), all_(all) {}

    std::string print(const ListedBlock& block, const std::optional<Word>* target) {
        std::string result;
        for (const auto& line : block.lines) {
            if (const std::string entry = lines_.entry(line.address); !entry.empty())
                result += entry + ":\n";
            const std::string sums =
                &line == &block.lines.front()
                    ? fmt::format("  {:>17}  {:>5.1f} %", print_cycles_of(block.spent), percent(block.spent, all_))
                    : "";
            const std::string place = new_place(line.address);
            result += print_line(line, *target++, all_) +
                      (place.empty() ? sums : fmt::format("{:<28}  {}", sums, place)) + '\n';
        }
        return result;
    }

private:
    /// Returns the place of this code in its file; "" if it is the same as for the preceding line.
    std::string new_place(Word address) {
        const std::string place = lines_.file_place(address);
        return std::exchange(place_, place) == place ? "" : place;
    }

    const CodeLines& lines_;
    HalfCycles all_;
    std::string place_;
};

} // namespace

Listing::Listing(Core& core) : core_(core), pages_(core.memory().size() / NodeMemory::page_bytes) { core.watch(this); }

Listing::Place& Listing::place(Word offset) {
    std::unique_ptr<Page>& page = pages_[offset / NodeMemory::page_bytes];
    if (!page)
        page = std::make_unique<Page>();
    return (*page)[offset % NodeMemory::page_bytes];
}

bool Listing::is_in_memory(const std::string& bytes, Word offset) const {
    return core_.memory().holds(offset, static_cast<Word>(bytes.size())) &&
           std::memcmp(core_.memory().data() + offset, bytes.data(), bytes.size()) == 0;
}

void Listing::begins(Word at) {
    const Word offset = NodeMemory::offset_of(at);
    if (offset >= core_.memory().size())
        return; // the instruction will stop the core
    Place& here = place(offset);
    if (here.now.bytes.empty() || !is_in_memory(here.now.bytes, offset))
        code_has_changed(here, offset);
    ++here.now.times;
}

/// Continues the count of the new code if this code was there before, otherwise begins a new count.
void Listing::code_has_changed(Place& here, Word offset) {
    const auto memory = core_.memory().bytes(offset, core_.memory().size() - offset);
    const auto code = memory.first(read_instruction(memory, core_.model()).length);
    const std::string bytes(code.begin(), code.end());
    if (!here.now.bytes.empty())
        here.before.push_back(std::exchange(here.now, {}));
    const auto known = std::ranges::find(here.before, bytes, &Count::bytes);
    if (known != here.before.end()) {
        here.now = std::move(*known);
        here.before.erase(known);
    } else if (here.before.size() == most_versions) { // the last version also counts all later versions
        here.now = std::move(here.before.back());
        here.before.pop_back();
    }
    here.now.bytes = bytes;
}

void Listing::executed(Word at, HalfCycles spent) {
    const Word offset = NodeMemory::offset_of(at);
    if (offset >= core_.memory().size())
        return; // the instruction began before the listing
    place(offset).now.spent += spent;
}

std::vector<Listing::Line> Listing::lines() const {
    std::vector<Line> result;
    const auto add = [&](Word address, const Count& count) {
        if (count.times == 0)
            return;
        const std::vector<std::uint8_t> bytes(count.bytes.begin(), count.bytes.end());
        result.push_back({address, read_instruction(bytes, core_.model()), bytes, count.times, count.spent,
                          !is_in_memory(count.bytes, NodeMemory::offset_of(address))});
    };
    Word address = most_negative;
    for (const auto& page : pages_)
        for (std::size_t i = 0; i < NodeMemory::page_bytes; ++i, ++address) {
            if (!page)
                continue;
            for (const Count& count : (*page)[i].before)
                add(address, count);
            add(address, (*page)[i].now);
        }
    std::stable_partition(result.begin(), result.end(), [](const Line& line) { return !line.is_replaced; });
    return result;
}

std::string print_listing(const Listing& listing, const CodeLines& code_lines) {
    const auto lines = listing.lines();
    HalfCycles all = 0;
    std::uint64_t times = 0;
    for (const auto& line : lines) {
        all += line.spent;
        times += line.times;
    }
    const auto targets = targets_of(lines);
    const auto blocks = blocks_of(lines, targets);
    std::string result = fmt::format("{} instructions of a {}, {} cycles, without waits\n", print_times(times),
                                     traits_of(listing.model()).name, print_cycles_of(all));
    if (lines.empty())
        return result;
    result += print_hot_blocks(blocks, all);
    result += fmt::format("\n{:<9}  {:<17}  {:<20} {:>15}  {:>17}  {:>7}  {:>17}  {:>7}\n", "address", "bytes",
                          "instruction", "times", "cycles", "share", "cycles of block", "share");
    BlockPrinter printer(code_lines, all);
    const Listing::Line* before = &lines.front();
    for (const ListedBlock& block : blocks) {
        const auto& first = block.lines.front();
        if (first.is_replaced && !before->is_replaced)
            result += "\nreplaced by other code\n";
        else if (&first != &lines.front() && end_of(*before) != first.address)
            result += '\n';
        result += printer.print(block, &targets[static_cast<std::size_t>(&first - &lines.front())]);
        before = &block.lines.back();
    }
    return result;
}

} // namespace placedpar::transputer
