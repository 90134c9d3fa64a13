#include "runtime/transputer/disassembler.hpp"

#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace placedpar::transputer {
namespace {

using Bytes = std::span<const std::uint8_t>;

bool is_text(std::uint8_t byte) {
    return (byte >= ' ' && byte < 0x7f) || byte == '\n' || byte == '\r' || byte == '\t';
}

/// Returns whether an assembler may have made an instruction: nfix stands before no other prefix, and there are only as
/// many prefixes as a word needs. Compilers pad with pfix 0.
bool is_proper(Bytes instruction) {
    while (instruction.size() > 1 && instruction.front() == 0x20)
        instruction = instruction.subspan(1);
    for (std::size_t i = 0; i + 2 < instruction.size(); ++i)
        if (instruction[i] >> 4 == 6)
            return false;
    return instruction.size() <= 8;
}

/// Follows and searches code.
class Disassembly {
public:
    Disassembly(Bytes bytes, Model model) : bytes_(bytes), model_(model), roles_(bytes.size(), Role::unknown),
          is_referred_to_(bytes.size()) {}

    void follow(std::span<const Word> entries) {
        std::vector<Word> to_follow(entries.begin(), entries.end());
        while (!to_follow.empty()) {
            const Word at = to_follow.back();
            to_follow.pop_back();
            follow_from(at, to_follow);
        }
    }

    /// Decides for what was not followed whether it is code.
    void search() {
        for (Word at = 0; at < size();) {
            while (at < size() && roles_[at] != Role::unknown)
                ++at;
            const Word end = gap_end(at, size());
            search_gap(at, end);
            at = end;
        }
    }

    std::vector<CodeLine> lines() const {
        std::vector<CodeLine> result;
        for (Word at = 0; at < size();) {
            const CodeLine line = line_at(at, result);
            at += line.instruction.length;
            result.push_back(line);
        }
        mark_blocks(result);
        return result;
    }

private:
    enum class Role : std::uint8_t { unknown, code, possible_code, data, inside };

    Word size() const { return static_cast<Word>(bytes_.size()); }
    CodedInstruction read(Word at, Word end) const { return read_instruction(bytes_.subspan(at, end - at), model_); }
    /// Returns the end of the bytes that nothing is known of, up to a limit.
    Word gap_end(Word at, Word limit) const {
        while (at < limit && roles_[at] == Role::unknown)
            ++at;
        return at;
    }
    /// Returns a limit that no instruction reaches.
    Word longest_end(Word at) const { return at + std::min<Word>(size() - at, most_prefixes + 1); }

    void mark(Word at, Word length, Role role) {
        std::fill_n(roles_.begin() + at, length, role == Role::data ? role : Role::inside);
        roles_[at] = role;
    }

    /// Follows straight code, and notes where it branches to.
    void follow_from(Word at, std::vector<Word>& to_follow) {
        std::array<CodeLine, 2> before{}; // the last first
        while (at < size() && roles_[at] == Role::unknown) {
            CodeLine line{.at = at, .content = Content::code, .instruction = read(at, gap_end(at, longest_end(at)))};
            if (line.instruction.length == 0 || line.instruction.operation == Operation::unknown)
                return;
            find_target(line, before);
            const Operation operation = line.instruction.operation;
            const Word next = at + line.instruction.length;
            mark(at, line.instruction.length, Role::code);
            if (line.target && *line.target < size())
                is_referred_to_[*line.target] = true;
            if (line.target && (operation != Operation::ldpi || stores_continuation(next)))
                to_follow.push_back(*line.target);
            if (ends_path(operation))
                return;
            before = {line, before[0]};
            at = next;
        }
    }

    /// Returns whether the address that ldpi loads is stored as that at which a PAR goes on.
    bool stores_continuation(Word next) const {
        constexpr std::uint8_t stl_0 = 0xd0;
        return next < size() && bytes_[next] == stl_0;
    }

    static bool ends_path(Operation operation) {
        switch (operation) {
        case Operation::j:
        case Operation::ret:
        case Operation::gcall:
        case Operation::endp:
        case Operation::stopp: return true;
        default: return false;
        }
    }

    /// Finds where an instruction leads, or what it selects. Instructions before it may have loaded a constant.
    static void find_target(CodeLine& line, const std::array<CodeLine, 2>& before) {
        const CodedInstruction& last = before[0].instruction;
        const Word next = line.at + line.instruction.length;
        const Operation operation = line.instruction.operation;
        if (branches_by_operand(operation))
            line.target = next + line.instruction.operand;
        else if (operation == Operation::startp && before[1].instruction.operation == Operation::ldc)
            line.target = next + before[1].instruction.operand;
        if (last.operation != Operation::ldc)
            return;
        if (operation == Operation::lend)
            line.target = next - last.operand;
        else if (operation == Operation::ldpi)
            line.target = next + last.operand;
        else if (operation == Operation::fpentry)
            line.selected = selected_by(last.operand);
    }

    void search_gap(Word at, Word end) {
        const Word begin = at;
        while (at < end) {
            const CodedInstruction instruction = read(at, next_reference(at, end));
            Word data = std::max(text_length(begin, at, end), zeros(at, end));
            if (data == 0 && (instruction.length == 0 || instruction.operation == Operation::unknown ||
                              !is_proper(bytes_.subspan(at, instruction.length))))
                data = std::max<Word>(1, instruction.length);
            mark(at, data > 0 ? data : instruction.length, data > 0 ? Role::data : Role::possible_code);
            at += data > 0 ? data : instruction.length;
        }
        drop_islands(begin, end);
    }

    /// Returns the next byte that followed code refers to, or the end. An instruction or data begins there.
    Word next_reference(Word at, Word end) const {
        end = std::min(end, longest_end(at));
        while (++at < end && !is_referred_to_[at]) {
        }
        return at;
    }

    /// Returns the length of text that begins here: at least five characters, and no proper code. 0: none begins here.
    Word text_length(Word begin, Word at, Word end) const {
        if (at > begin && is_text(bytes_[at - 1]))
            return 0; // it was looked at from its beginning
        Word after = at;
        while (after < end && is_text(bytes_[after]))
            ++after;
        if (after - at < 5)
            return 0;
        for (Word i = at; i < after;) {
            const CodedInstruction instruction = read(i, after);
            if (instruction.length == 0)
                break;
            if (instruction.operation == Operation::unknown || !is_proper(bytes_.subspan(i, instruction.length)))
                return after - at;
            i += instruction.length;
        }
        return 0;
    }

    /// Returns the number of zeros from here on if there are at least three.
    Word zeros(Word at, Word end) const {
        Word after = at;
        while (after < end && bytes_[after] == 0)
            ++after;
        return after - at < 3 ? 0 : after - at;
    }

    /// Takes a few bytes between data for data.
    void drop_islands(Word begin, Word end) {
        constexpr Word shortest_code = 6;
        Word since = begin; // the end of the last data
        bool after_data = false;
        for (Word at = begin; at < end; ++at) {
            if (roles_[at] != Role::data)
                continue;
            if (after_data && at - since < shortest_code)
                mark(since, at - since, Role::data);
            since = at + 1;
            after_data = true;
        }
    }

    CodeLine line_at(Word at, const std::vector<CodeLine>& lines) const {
        CodeLine line{.at = at};
        if (roles_[at] == Role::data) {
            line.instruction.length = data_length(at);
            return line;
        }
        line.content = roles_[at] == Role::code ? Content::code : Content::possible_code;
        line.instruction = read(at, size());
        const std::size_t count = lines.size();
        find_target(line, {count > 0 ? lines[count - 1] : CodeLine{}, count > 1 ? lines[count - 2] : CodeLine{}});
        return line;
    }

    /// Returns how many bytes of data a line shows: eight, or any number of equal bytes.
    Word data_length(Word at) const {
        Word end = at + 1;
        const auto is_data = [&] { return end < size() && roles_[end] == Role::data; };
        while (is_data() && bytes_[end] == bytes_[at])
            ++end;
        if (end - at >= 16)
            return end - at;
        end = at + 1;
        while (end - at < 8 && is_data())
            ++end;
        return end - at;
    }

    void mark_blocks(std::vector<CodeLine>& lines) const {
        std::vector<bool> is_target(bytes_.size());
        for (const CodeLine& line : lines)
            if (line.target && *line.target < size())
                is_target[*line.target] = true;
        for (std::size_t i = 0; i < lines.size(); ++i)
            lines[i].begins_block = i == 0 || is_target[lines[i].at] || lines[i].content != lines[i - 1].content ||
                                    leads_away(lines[i - 1].instruction.operation);
    }

    Bytes bytes_;
    Model model_;
    std::vector<Role> roles_;
    std::vector<bool> is_referred_to_; ///< by code that was followed
};

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

std::string print_text(Bytes bytes) {
    std::string result;
    for (const std::uint8_t byte : bytes)
        result += byte >= ' ' && byte < 0x7f ? static_cast<char>(byte) : '.';
    return result;
}

std::string print_data(Bytes bytes) {
    if (bytes.size() > 8)
        return fmt::format("{:<17}   data    {} bytes #{:02X}", print_bytes(bytes), bytes.size(), bytes.front());
    std::string hexadecimal;
    for (const std::uint8_t byte : bytes)
        hexadecimal += fmt::format("{:02X} ", byte);
    return fmt::format("{:<24} {}", hexadecimal, print_text(bytes));
}

/// Prints lines with labels.
class Printer {
public:
    /// `label` returns the address of a byte by its number.
    Printer(Bytes bytes, Model model, std::function<std::string(Word)> label)
        : bytes_(bytes), model_(model), label_(std::move(label)) {}

    std::string print(std::span<const CodeLine> lines, std::size_t i) const {
        const CodeLine& line = lines[i];
        const Bytes bytes = bytes_.subspan(line.at, line.instruction.length);
        std::string result = fmt::format("  {:<9}  ", label_(line.at));
        if (line.content == Content::data)
            result += print_data(bytes);
        else
            result += fmt::format("{:<17} {} {:<24}{}", print_bytes(bytes),
                                  line.content == Content::code ? ' ' : '?', text_of(line),
                                  line.begins_block ? print_cycles(cycles_of_block(lines.subspan(i))) : "");
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
                const unsigned more = description_of(lines[i].selected).real_cycles - 1u; // fpentry is its first cycle
                cycles = {cycles.least + more, *cycles.most + more};
            }
            sum.least += cycles.least;
            sum.most = sum.most && cycles.most ? std::optional(*sum.most + *cycles.most) : std::nullopt;
        }
        return sum;
    }

    Bytes bytes_;
    Model model_;
    std::function<std::string(Word)> label_;
};

// Bootable files

/// The collectors of INMOS's toolsets cut code into packets of so many bytes, each after its length. Observed in files.
constexpr std::size_t packet_bytes = 60;
/// A stage that is longer is shown in parts.
constexpr std::size_t longest_stage = 4096 * (packet_bytes + 1);

/// Bytes of a file that stand together in memory.
struct Stage {
    std::string_view name;
    std::size_t first = 0; ///< position in the file
    std::vector<std::uint8_t> bytes{};
    bool in_packets = false;

    std::size_t position(std::size_t i) const { return first + i + (in_packets ? i / packet_bytes : 0); }
    std::size_t last() const { return position(bytes.size() - 1); }
};

/// Splits a bootable file.
class Stages {
public:
    explicit Stages(Bytes file) : file_(file) {}

    std::vector<Stage> split() {
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
    /// Returns the position of the packet of no bytes that ends the packets that begin here; the beginning if there is
    /// none.
    std::size_t opening_end(std::size_t begin) const {
        std::size_t at = begin;
        while (at < file_.size() && file_[at] != 0)
            at += 1 + file_[at];
        return at < file_.size() ? at : begin;
    }

    bool is_full_packet(std::size_t at) const { return at + packet_bytes < file_.size() && file_[at] == packet_bytes; }
    bool is_packets(std::size_t at) const { return is_full_packet(at) && is_full_packet(at + packet_bytes + 1); }

    std::size_t add(std::string_view name, std::size_t first, std::size_t bytes) {
        const Bytes part = file_.subspan(first, bytes);
        stages_.push_back({.name = name, .first = first, .bytes = {part.begin(), part.end()}});
        return first + bytes;
    }
    void add_rest(std::size_t since, std::size_t at) {
        if (at > since)
            add("other bytes", since, at - since);
    }

    /// Joins full packets and one that is shorter.
    std::size_t add_packets(std::size_t at) {
        Stage stage{.name = "packets", .first = at + 1, .in_packets = true};
        for (bool more = true; more && at < file_.size() && stage.bytes.size() < longest_stage;) {
            const std::size_t bytes = file_[at];
            if (bytes == 0 || bytes > packet_bytes || at + bytes >= file_.size())
                break;
            const Bytes packet = file_.subspan(at + 1, bytes);
            stage.bytes.insert(stage.bytes.end(), packet.begin(), packet.end());
            at += 1 + bytes;
            more = bytes == packet_bytes;
        }
        stages_.push_back(std::move(stage));
        return at;
    }

    Bytes file_;
    std::vector<Stage> stages_;
};

/// Returns the label of a byte of a stage: its address in the loader, else its position in the file.
std::string label_in(const Stage& stage, bool is_loader, Model model, Word i) {
    if (is_loader)
        return print_address(most_negative + traits_of(model).memory_start + i);
    if (i < stage.bytes.size())
        return fmt::format("+{:05X}", stage.position(i));
    return fmt::format("outside {:+}", signed_of(i));
}

} // namespace

std::vector<CodeLine> disassemble(Bytes bytes, std::span<const Word> entries, Model model) {
    Disassembly disassembly(bytes, model);
    disassembly.follow(entries);
    disassembly.search();
    return disassembly.lines();
}

bool leads_away(Operation operation) {
    const bool in_scheduler = description_of(operation).unit == Unit::scheduler;
    return in_scheduler ? operation == Operation::endp || operation == Operation::stopp : ends_block(operation);
}

CycleRange published_cycles(const CodedInstruction& instruction, Model model) {
    const Operation operation = instruction.operation;
    const Instruction& description = description_of(operation);
    const unsigned least =
        instruction.length - 1 + (description.real_cycles > 0 ? description.real_cycles : cycles_of(operation, model));
    switch (operation) {
    case Operation::in:
    case Operation::out:
    case Operation::move:
    case Operation::move2dall:
    case Operation::move2dnonzero:
    case Operation::move2dzero: return {least, std::nullopt};
    case Operation::outbyte:
    case Operation::outword: return {least - 2, least};
    case Operation::enbc: return {least, least + 2};
    case Operation::altwt: return {least, least + 12};
    case Operation::taltwt: return {least, least + 33};
    case Operation::tin: return {least, least + 26};
    case Operation::fpentry: return {least, least};
    default: return {least, least + (description.real_cycles > 0 ? 0u : description.extra_cycles)};
    }
}

std::string print_instruction(const CodedInstruction& instruction, std::string_view target) {
    const Instruction& description = description_of(instruction.operation);
    if (instruction.operation == Operation::unknown)
        return fmt::format("{:<7} #{:X}", "opr", instruction.operand & 0x3ff);
    const std::string operand =
        !target.empty() || description.unit != Unit::direct ? std::string(target) : print_operand(instruction);
    return operand.empty() ? std::string(description.name) : fmt::format("{:<7} {}", description.name, operand);
}

std::string print_bytes(Bytes bytes) {
    std::string result;
    const bool all = bytes.size() <= 6;
    for (const std::uint8_t byte : bytes.first(all ? bytes.size() : 5))
        result += fmt::format("{}{:02X}", result.empty() ? "" : " ", byte);
    return all ? result : result + " ..";
}

std::string print_address(Word address) { return fmt::format("#{:08X}", address); }

std::string print_memory(Bytes bytes, Word address, std::span<const Word> entries, Model model,
                         std::size_t most_lines) {
    std::vector<Word> offsets;
    for (const Word entry : entries)
        offsets.push_back(entry - address);
    const std::vector<CodeLine> lines = disassemble(bytes, offsets, model);
    const Printer printer(bytes, model, [address](Word i) { return print_address(address + i); });
    std::string result;
    for (std::size_t i = 0; i < std::min(lines.size(), most_lines); ++i)
        result += printer.print(lines, i);
    return result;
}

void print_bootable(Bytes file, Model model, const FileRange& range,
                    const std::function<void(std::string_view)>& write) {
    for (const Stage& stage : Stages(file).split()) {
        if (stage.last() < range.from || stage.first >= range.until)
            continue;
        const bool is_loader = stage.name == "loader";
        write(fmt::format("\n{}: bytes +{:05X} to +{:05X}{}\n", stage.name, stage.first, stage.last(),
                          stage.in_packets ? fmt::format(", in packets of {}", packet_bytes) : ""));
        const Word entry = 0;
        const auto lines = disassemble(stage.bytes, std::span(&entry, is_loader ? 1 : 0), model);
        const Printer printer(stage.bytes, model,
                              [&](Word i) { return label_in(stage, is_loader, model, i); });
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (const std::size_t position = stage.position(lines[i].at);
                position >= range.from && position < range.until)
                write(printer.print(lines, i));
    }
}

} // namespace placedpar::transputer
