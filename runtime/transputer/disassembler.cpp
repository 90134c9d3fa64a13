#include "runtime/transputer/disassembler.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace placedpar::transputer {
namespace {

using Bytes = std::span<const std::uint8_t>;

bool is_text(std::uint8_t byte) { return (byte >= ' ' && byte < 0x7f) || byte == '\n' || byte == '\r' || byte == '\t'; }

/// Returns whether an assembler may have made this instruction. No other prefix follows nfix, and there are at most as
/// many prefixes as a word needs. Each pfix 0 at the beginning is ignored, because compilers pad instructions with it.
bool is_proper(Bytes instruction) {
    while (instruction.size() > 1 && instruction.front() == 0x20)
        instruction = instruction.subspan(1);
    for (std::size_t i = 0; i + 2 < instruction.size(); ++i)
        if (instruction[i] >> 4 == 6)
            return false;
    return instruction.size() <= 8;
}

/// Follows the code from its entries, and then searches the remaining bytes for code.
class Disassembly {
public:
    Disassembly(Bytes bytes, Model model)
        : bytes_(bytes), model_(model), roles_(bytes.size(), Role::unknown), is_referred_to_(bytes.size()) {}

    void follow(std::span<const Word> entries) {
        std::vector<Word> to_follow(entries.begin(), entries.end());
        while (!to_follow.empty()) {
            const Word at = to_follow.back();
            to_follow.pop_back();
            follow_from(at, to_follow);
        }
    }

    /// Decides which of the bytes that follow() did not reach are code.
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
    /// Returns the end of the unknown bytes that begin at `at`, or the limit if it comes first.
    Word gap_end(Word at, Word limit) const {
        while (at < limit && roles_[at] == Role::unknown)
            ++at;
        return at;
    }
    /// Returns the last position at which an instruction that begins at `at` can end.
    Word longest_end(Word at) const { return at + std::min<Word>(size() - at, most_prefixes + 1); }

    void mark(Word at, Word length, Role role) {
        std::fill_n(roles_.begin() + at, length, role == Role::data ? role : Role::inside);
        roles_[at] = role;
    }

    /// Follows straight code, and notes where it branches to.
    void follow_from(Word at, std::vector<Word>& to_follow) {
        std::array<CodeLine, 2> before{}; // the last line first
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

    /// Returns whether the program stores the address that ldpi has loaded as the address at which a PAR continues.
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

    /// Returns the position of the next byte to which the code that follow() reached refers, or the end. An instruction
    /// or data begins at this byte.
    Word next_reference(Word at, Word end) const {
        end = std::min(end, longest_end(at));
        while (++at < end && !is_referred_to_[at]) {
        }
        return at;
    }

    /// Returns the length of the text that begins here, or 0 if none begins. A text has at least five characters, and
    /// does not look like proper code.
    Word text_length(Word begin, Word at, Word end) const {
        if (at > begin && is_text(bytes_[at - 1]))
            return 0; // the text was examined from its beginning
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

    /// Returns the number of zeros from `at` on, or 0 if there are fewer than three.
    Word zeros(Word at, Word end) const {
        Word after = at;
        while (after < end && bytes_[after] == 0)
            ++after;
        return after - at < 3 ? 0 : after - at;
    }

    /// Treats short runs of possible code between data as data.
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

    /// Returns how many bytes of data a line shows: at most eight, or all of at least 16 equal bytes.
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
    std::vector<bool> is_referred_to_; ///< for each byte, whether the code that follow() reached refers to it
};

} // namespace

std::vector<CodeLine> disassemble(Bytes bytes, std::span<const Word> entries, Model model) {
    Disassembly disassembly(bytes, model);
    disassembly.follow(entries);
    disassembly.search();
    return disassembly.lines();
}

void find_target(CodeLine& line, const std::array<CodeLine, 2>& before) {
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

} // namespace placedpar::transputer
