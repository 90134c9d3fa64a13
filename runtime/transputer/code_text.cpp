#include "runtime/transputer/code_text.hpp"

#include "runtime/transputer/disassembler.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar::transputer {
namespace {

using CodeView = std::span<const std::uint8_t>;

std::string print_operand(const CodedInstruction& instruction) {
    const std::int32_t operand = signed_of(instruction.operand);
    if (operand > 99'999 || operand < -99'999)
        return fmt::format("#{:X}", instruction.operand);
    return fmt::format("{}", operand);
}

std::string print_cycles(const CycleRange& cycles) {
    if (!cycles.most)
        return fmt::format("{}+", cycles.least);
    return *cycles.most == cycles.least ? fmt::format("{}", cycles.least)
                                        : fmt::format("{}-{}", cycles.least, *cycles.most);
}

std::string print_text(CodeView bytes) {
    std::string result;
    for (const std::uint8_t byte : bytes)
        result += byte >= ' ' && byte < 0x7f ? static_cast<char>(byte) : '.';
    return result;
}

std::string print_data(CodeView bytes) {
    if (bytes.size() > 8)
        return fmt::format("{:<17}   data    {} bytes #{:02X}", print_bytes(bytes), bytes.size(), bytes.front());
    std::string hexadecimal;
    for (const std::uint8_t byte : bytes)
        hexadecimal += fmt::format("{:02X} ", byte);
    return fmt::format("{:<24} {}", hexadecimal, print_text(bytes));
}

/// Prints lines with labels.
class CodePrinter {
public:
    /// `label` returns the text that labels the byte with this index.
    CodePrinter(CodeView bytes, Model model, std::function<std::string(Word)> label)
        : bytes_(bytes), model_(model), label_(std::move(label)) {}

    std::string print(std::span<const CodeLine> lines, std::size_t i) const {
        const CodeLine& line = lines[i];
        const CodeView bytes = bytes_.subspan(line.at, line.instruction.length);
        std::string result = fmt::format("  {:<9}  ", label_(line.at));
        if (line.content == Content::data)
            result += print_data(bytes);
        else
            result +=
                fmt::format("{:<17} {} {:<24}{}", print_bytes(bytes), line.content == Content::code ? ' ' : '?',
                            text_of(line), line.begins_block ? print_cycles(cycles_of_block(lines.subspan(i))) : "");
        return result.substr(0, result.find_last_not_of(' ') + 1) + '\n';
    }

private:
    std::string text_of(const CodeLine& line) const {
        if (line.selected != Operation::unknown)
            return print_instruction(line.instruction, description_of(line.selected).name);
        return print_instruction(line.instruction, line.target ? label_(*line.target) : "");
    }

    CycleRange cycles_of_block(std::span<const CodeLine> lines) const {
        CycleRange sum;
        for (std::size_t i = 0; i < lines.size() && (i == 0 || !lines[i].begins_block); ++i) {
            CycleRange cycles = published_cycles(lines[i].instruction, model_);
            if (lines[i].selected != Operation::unknown) {
                // The cycle of fpentry is counted already.
                const unsigned more = description_of(lines[i].selected).real_cycles - 1u;
                cycles = {cycles.least + more, *cycles.most + more};
            }
            sum.least += cycles.least;
            sum.most = sum.most && cycles.most ? std::optional(*sum.most + *cycles.most) : std::nullopt;
        }
        return sum;
    }

    CodeView bytes_;
    Model model_;
    std::function<std::string(Word)> label_;
};

// Bootable files

/// The collectors of INMOS's toolsets divide code into packets of this number of bytes, each preceded by its length
/// (observed in files).
constexpr std::size_t packet_bytes = 60;
/// The most bytes of a stage. A longer stage is shown in parts.
constexpr std::size_t longest_stage = 4096 * (packet_bytes + 1);

/// A stage of a boot: bytes of the file that are loaded into memory together, such as the loader.
struct BootStage {
    std::string_view name;
    std::size_t first = 0; ///< position in the file
    std::vector<std::uint8_t> bytes{};
    bool in_packets = false;

    std::size_t position(std::size_t i) const { return first + i + (in_packets ? i / packet_bytes : 0); }
    std::size_t last() const { return position(bytes.size() - 1); }
};

/// Splits a bootable file into stages.
class BootStages {
public:
    explicit BootStages(CodeView file) : file_(file) {}

    std::vector<BootStage> split() {
        if (file_.empty())
            return {};
        std::size_t at = 0;
        if (file_[0] >= 2 && file_[0] < file_.size())
            at = add("loader", 1, file_[0]);
        for (const std::size_t end = opening_end(at); at < end;)
            at = is_packets(at) ? add_packets(at) : add("packet", at + 1, file_[at]);
        std::size_t since = at;
        while (at < file_.size()) {
            if (is_packets(at) || at - since == longest_stage) {
                add_rest(since, at);
                since = at = is_packets(at) ? add_packets(at) : at;
            } else {
                ++at;
            }
        }
        add_rest(since, at);
        return std::move(stages_);
    }

private:
    /// Returns the position of the empty packet that ends the packets from `begin` on, or `begin` if no empty packet
    /// ends them.
    std::size_t opening_end(std::size_t begin) const {
        std::size_t at = begin;
        while (at < file_.size() && file_[at] != 0)
            at += 1 + file_[at];
        return at < file_.size() ? at : begin;
    }

    bool is_full_packet(std::size_t at) const { return at + packet_bytes < file_.size() && file_[at] == packet_bytes; }
    bool is_packets(std::size_t at) const { return is_full_packet(at) && is_full_packet(at + packet_bytes + 1); }

    std::size_t add(std::string_view name, std::size_t first, std::size_t bytes) {
        const CodeView part = file_.subspan(first, bytes);
        stages_.push_back({.name = name, .first = first, .bytes = {part.begin(), part.end()}});
        return first + bytes;
    }
    void add_rest(std::size_t since, std::size_t at) {
        if (at > since)
            add("other bytes", since, at - since);
    }

    /// Adds a stage that joins all full packets from `at` on and the shorter packet that follows them. Returns the
    /// position after them.
    std::size_t add_packets(std::size_t at) {
        BootStage stage{.name = "packets", .first = at + 1, .in_packets = true};
        for (bool more = true; more && at < file_.size() && stage.bytes.size() < longest_stage;) {
            const std::size_t bytes = file_[at];
            if (bytes == 0 || bytes > packet_bytes || at + bytes >= file_.size())
                break;
            const CodeView packet = file_.subspan(at + 1, bytes);
            stage.bytes.insert(stage.bytes.end(), packet.begin(), packet.end());
            at += 1 + bytes;
            more = bytes == packet_bytes;
        }
        stages_.push_back(std::move(stage));
        return at;
    }

    CodeView file_;
    std::vector<BootStage> stages_;
};

/// Returns the label of a byte of a stage. For the loader this is the byte's address in memory, for other stages its
/// position in the file.
std::string label_in(const BootStage& stage, bool is_loader, Model model, Word i) {
    if (is_loader)
        return print_address(most_negative + traits_of(model).memory_start + i);
    if (i < stage.bytes.size())
        return fmt::format("+{:05X}", stage.position(i));
    return fmt::format("outside {:+}", signed_of(i));
}

} // namespace

std::string print_instruction(const CodedInstruction& instruction, std::string_view target) {
    const Instruction& description = description_of(instruction.operation);
    if (instruction.operation == Operation::unknown)
        return fmt::format("{:<7} #{:X}", "opr", instruction.operand & 0x3ff);
    const std::string operand =
        !target.empty() || description.unit != Unit::direct ? std::string(target) : print_operand(instruction);
    return operand.empty() ? std::string(description.name) : fmt::format("{:<7} {}", description.name, operand);
}

std::string print_bytes(CodeView bytes) {
    std::string result;
    const bool all = bytes.size() <= 6;
    for (const std::uint8_t byte : bytes.first(all ? bytes.size() : 5))
        result += fmt::format("{}{:02X}", result.empty() ? "" : " ", byte);
    return all ? result : result + " ..";
}

std::string print_address(Word address) { return fmt::format("#{:08X}", address); }

std::string print_memory(CodeView bytes, Word address, std::span<const Word> entries, Model model,
                         std::size_t most_lines) {
    std::vector<Word> offsets;
    for (const Word entry : entries)
        offsets.push_back(entry - address);
    const std::vector<CodeLine> lines = disassemble(bytes, offsets, model);
    const CodePrinter printer(bytes, model, [address](Word i) { return print_address(address + i); });
    std::string result;
    for (std::size_t i = 0; i < std::min(lines.size(), most_lines); ++i)
        result += printer.print(lines, i);
    return result;
}

void print_bootable(CodeView file, Model model, const FileRange& range,
                    const std::function<void(std::string_view)>& write) {
    for (const BootStage& stage : BootStages(file).split()) {
        if (stage.last() < range.from || stage.first >= range.until)
            continue;
        const bool is_loader = stage.name == "loader";
        write(fmt::format("\n{}: bytes +{:05X} to +{:05X}{}\n", stage.name, stage.first, stage.last(),
                          stage.in_packets ? fmt::format(", in packets of {}", packet_bytes) : ""));
        const Word entry = 0;
        const auto lines = disassemble(stage.bytes, std::span(&entry, is_loader ? 1 : 0), model);
        const CodePrinter printer(stage.bytes, model, [&](Word i) { return label_in(stage, is_loader, model, i); });
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (const std::size_t position = stage.position(lines[i].at);
                position >= range.from && position < range.until)
                write(printer.print(lines, i));
    }
}

} // namespace placedpar::transputer
