#include "runtime/transputer/assembler.hpp"

#include "runtime/transputer/instruction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace placedpar::transputer {

namespace {

using CodeBytes = std::vector<std::uint8_t>;

constexpr unsigned prefix = 2, load_constant = 4, negative_prefix = 6, operate = 15;
constexpr Word enter_reals = 0xAB, load_address = 0x1B; // fpentry, ldpi

/// A mnemonic: a direct function, an operation of `opr`, or an operation that fpentry selects.
struct Mnemonic {
    Unit unit;
    Word code;
    Models models;
};

using Mnemonics = std::map<std::string_view, Mnemonic>;

const Mnemonics& mnemonics() {
    static const Mnemonics all = [] {
        Mnemonics result{{"pfix", {Unit::direct, prefix, all_models}},
                         {"nfix", {Unit::direct, negative_prefix, all_models}},
                         {"opr", {Unit::direct, operate, all_models}}};
        for (int i = 0; i < static_cast<int>(Operation::go_on); ++i) {
            const Instruction& each = description_of(static_cast<Operation>(i));
            const Models others = result[each.name].models; // models for which the table has another row with this name
            result[each.name] = {each.unit, each.code, each.models | others};
        }
        return result;
    }();
    return all;
}

/// Returns the text without the space around it.
std::string_view trimmed(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    return text;
}

/// Returns the position of the first `mark` in the text that is outside of quotes, or the length of the text.
std::size_t place_of(std::string_view mark, std::string_view text) {
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        quoted ^= text[i] == '"';
        if (!quoted && text.substr(i).starts_with(mark))
            return i;
    }
    return text.size();
}

/// Removes and returns the text before the place. Drops the character at the place, and the space around both parts.
std::string_view cut(std::string_view& text, std::size_t place) {
    const auto part = trimmed(text.substr(0, place));
    text = trimmed(text.substr(std::min(place + 1, text.size())));
    return part;
}

bool is_name(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.'; };
    return !text.empty() && letter(text.front()) &&
           std::ranges::all_of(text, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

std::size_t size_of_data(std::string_view name) {
    return name == ".byte" ? 1 : name == ".half" ? 2 : name == ".word" ? 4 : 0;
}

class Assembler {
public:
    Assembler(std::string_view source, Word origin, std::optional<Model> model)
        : program_{.origin = origin, .bytes{}, .labels{}, .lines{}}, model_(model) {
        for (std::size_t from = 0; from <= source.size();) {
            const auto end = std::min(source.find('\n', from), source.size());
            add_line(source.substr(from, end - from));
            from = end + 1;
        }
    }

    /// Assembles in passes until no address changes. Each instruction begins with one byte and only grows, so the
    /// number of passes is finite.
    Assembly run() && {
        pass();
        sizes_known_ = true;
        while (pass())
            ;
        for (const Statement& each : statements_) {
            auto& line = program_.lines[each.line - 1];
            if (line.bytes.empty())
                line.address = each.address;
            line.bytes.insert(line.bytes.end(), each.bytes.begin(), each.bytes.end());
            program_.bytes.insert(program_.bytes.end(), each.bytes.begin(), each.bytes.end());
        }
        return std::move(program_);
    }

private:
    struct Statement {
        std::size_t line;
        const char* line_begin;
        std::string_view label, mnemonic, operand;
        Word address = 0;
        CodeBytes bytes{};
    };

    void add_line(std::string_view text) {
        program_.lines.push_back({0, {}, std::string(text)});
        line_ = program_.lines.size();
        line_begin_ = text.data();
        std::string_view rest = text.substr(0, place_of("--", text));
        do {
            add_statement(cut(rest, place_of(";", rest)));
        } while (!rest.empty());
    }

    void add_statement(std::string_view text) {
        std::string_view label;
        if (const std::size_t colon = place_of(":", text); colon < text.size()) {
            label = cut(text, colon);
            define(program_.labels, label, program_.origin);
        }
        if (const std::size_t equals = place_of("=", text); equals < text.size()) {
            const auto name = cut(text, equals);
            bool has_label = false;
            const Word number = value(text, has_label);
            if (has_label)
                fail(text, "the value of a name cannot contain a label, because labels have no address yet: use only "
                           "numbers, and names that are defined as numbers");
            define(constants_, name, number);
            text = {};
        }
        const auto mnemonic = cut(text, std::min(text.find_first_of(" \t"), text.size()));
        statements_.push_back({line_, line_begin_, label, mnemonic, text});
    }

    void define(std::map<std::string, Word, std::less<>>& names, std::string_view name, Word value) {
        if (!is_name(name))
            fail(name,
                 fmt::format(
                     "\"{}\" cannot be a name: a name has letters, digits, _ and ., and does not begin with a digit",
                     name));
        if (program_.labels.contains(name) || constants_.contains(name))
            fail(name, fmt::format("\"{}\" is defined already: choose another name", name));
        names.emplace(name, value);
    }

    /// Assembles all statements with the addresses of the previous pass. Returns whether any address has changed.
    bool pass() {
        bool changed = false;
        for (Statement& each : statements_) {
            line_ = each.line;
            line_begin_ = each.line_begin;
            each.bytes = bytes(each);
        }
        Word address = program_.origin;
        for (Statement& each : statements_) {
            if (each.mnemonic == ".align")
                each.bytes.resize(-address % 4);
            if (!each.label.empty())
                program_.labels.find(each.label)->second = address;
            changed |= std::exchange(each.address, address) != address;
            address += static_cast<Word>(each.bytes.size());
        }
        return changed;
    }

    CodeBytes bytes(const Statement& statement) {
        const std::string_view name = statement.mnemonic, operand = statement.operand;
        if (const std::size_t size = size_of_data(name))
            return data(operand, size);
        if (name.empty() || name == ".align")
            return {};
        const auto found = mnemonics().find(name);
        if (found == mnemonics().end())
            fail(name, fmt::format("the instruction \"{}\" does not exist", name));
        const Mnemonic& is = found->second;
        if (model_ && !(is.models & only(*model_)))
            fail(name, fmt::format("the {} has no instruction \"{}\"", traits_of(*model_).name, name));
        if (is.unit == Unit::direct)
            return direct(is.code, statement);
        if (name == "ldpi" && !operand.empty())
            return address_of(statement);
        if (!operand.empty())
            fail(operand, fmt::format("\"{}\" has no operand", name));
        const auto code = static_cast<std::int32_t>(is.code);
        return is.unit == Unit::selected ? both(encoded(load_constant, code), enter_reals) : encoded(operate, code);
    }

    static CodeBytes both(CodeBytes load, Word operation) {
        const auto last = encoded(operate, static_cast<std::int32_t>(operation));
        load.insert(load.end(), last.begin(), last.end());
        return load;
    }

    CodeBytes direct(unsigned function, const Statement& statement) {
        const std::string_view name = statement.mnemonic;
        if (statement.operand.empty())
            fail(name, fmt::format("\"{}\" needs an operand", name));
        bool has_label = false;
        const Word sum = value(statement.operand, has_label);
        if (!sizes_known_)
            return {0};
        if (function == prefix || function == negative_prefix)
            return {static_cast<std::uint8_t>(function << 4 | (sum & 15))};
        const bool jumps = name == "j" || name == "cj" || name == "call";
        return jumps && has_label ? relative(function, sum - statement.address, statement.bytes.size())
                                  : encoded(function, static_cast<std::int32_t>(sum), statement.bytes.size());
    }

    /// Returns the instructions ldc and ldpi, which together load the address of a label, wherever the program is in
    /// memory.
    CodeBytes address_of(const Statement& statement) {
        constexpr Word size_of_ldpi = 2;
        bool has_label = false;
        const Word sum = value(statement.operand, has_label);
        const std::size_t least = std::max<std::size_t>(statement.bytes.size(), size_of_ldpi) - size_of_ldpi;
        return sizes_known_ ? both(relative(load_constant, sum - statement.address - size_of_ldpi, least), load_address)
                            : CodeBytes{0};
    }

    /// Returns an instruction whose operand is the distance from the next instruction to a label. The distance depends
    /// on the length of the instruction, so all lengths are tried, shortest first. `from_here` is the distance from the
    /// beginning of the instruction.
    static CodeBytes relative(unsigned function, Word from_here, std::size_t least) {
        for (std::size_t length = std::max(least, std::size_t{1});; ++length)
            if (auto code = encoded(function, static_cast<std::int32_t>(from_here - length), length);
                code.size() == length)
                return code;
    }

    CodeBytes data(std::string_view list, std::size_t size) {
        CodeBytes bytes;
        do {
            const auto item = cut(list, place_of(",", list));
            if (size == 1 && item.size() > 1 && item.front() == '"' && item.back() == '"') {
                bytes.insert(bytes.end(), item.begin() + 1, item.end() - 1);
                continue;
            }
            bool has_label = false;
            const Word sum = value(item, has_label);
            const auto bits = static_cast<unsigned>(8 * size);
            if (size < 4 && sizes_known_ && sum >> bits != 0 && sum >> (bits - 1) != ~Word{0} >> (bits - 1))
                fail(item, fmt::format("{} does not fit into {} bits", static_cast<std::int32_t>(sum), bits));
            for (std::size_t i = 0; i < size; ++i)
                bytes.push_back(static_cast<std::uint8_t>(sum >> 8 * i));
        } while (!list.empty());
        return bytes;
    }

    /// Returns the value of a sum of numbers, constants and labels.
    Word value(std::string_view sum, bool& has_label) {
        if (sum.empty())
            fail(sum, "a number or a name is missing");
        Word total = 0;
        while (!sum.empty()) {
            const bool negative = sum.front() == '-';
            if (negative || sum.front() == '+')
                sum.remove_prefix(1);
            const std::size_t length = std::min(sum.find_first_of("+-"), sum.size());
            const Word each = term(trimmed(sum.substr(0, length)), has_label);
            total += negative ? -each : each;
            sum.remove_prefix(length);
        }
        return total;
    }

    Word term(std::string_view text, bool& has_label) {
        if (is_name(text)) {
            if (const auto constant = constants_.find(text); constant != constants_.end())
                return constant->second;
            const auto found = program_.labels.find(text);
            if (found == program_.labels.end())
                fail(text, fmt::format("no label and no number has the name \"{}\"", text));
            has_label = true;
            return found->second;
        }
        const bool hexadecimal = text.starts_with('#');
        Word number = 0;
        const char* const end = text.data() + text.size();
        const auto [last, failed] = std::from_chars(text.data() + hexadecimal, end, number, hexadecimal ? 16 : 10);
        if (failed != std::errc{} || last != end)
            fail(text, fmt::format("\"{}\" is neither a number of 32 bits nor a name", text));
        return number;
    }

    /// Throws AssemblyError with the line and column of `where`. REQUIRES: `where` is a part of the current line.
    [[noreturn]] void fail(std::string_view where, const std::string& what) const {
        throw AssemblyError(what, line_, static_cast<std::size_t>(where.data() - line_begin_) + 1);
    }

    Assembly program_;
    std::optional<Model> model_;
    std::map<std::string, Word, std::less<>> constants_;
    std::vector<Statement> statements_;
    std::size_t line_ = 0;             ///< number of the current line
    const char* line_begin_ = nullptr; ///< its first character
    bool sizes_known_ = false;         ///< false while labels do not have addresses yet
};

} // namespace

std::vector<std::uint8_t> encoded(unsigned function, std::int32_t operand, std::size_t least) {
    // A prefix shifts the operand register by 4 bits. The last prefix of a negative operand is nfix, which first
    // complements the register. INMOS's assemblers use the same form.
    const bool is_negative = operand < 0;
    const std::int64_t value = operand;
    const std::int64_t prefixed = is_negative ? ~value : value;
    std::size_t length = std::max(least, std::size_t{operand < 0 ? 2U : 1U});
    while (length < 8 && (value >= std::int64_t{1} << 4 * length || value < -(std::int64_t{1} << 4 * length)))
        ++length;
    std::vector<std::uint8_t> bytes;
    const auto add = [&bytes](unsigned code, std::int64_t digit) {
        bytes.push_back(static_cast<std::uint8_t>(code << 4 | (static_cast<unsigned>(digit) & 15)));
    };
    for (std::size_t place = length - 1; place > 0; --place)
        add(place == 1 && is_negative ? negative_prefix : prefix, prefixed >> 4 * place);
    add(function, value);
    return bytes;
}

Word Assembly::operator[](std::string_view label) const {
    const auto found = labels.find(label);
    if (found == labels.end())
        throw std::out_of_range(fmt::format("no line has the label \"{}\"", label));
    return found->second;
}

std::string Assembly::listing() const {
    constexpr std::size_t in_row = 8;
    std::string text;
    for (const Line& line : lines) {
        std::string source = line.source;
        for (std::size_t begin = 0; begin == 0 || begin < line.bytes.size(); begin += in_row) {
            std::string row = line.bytes.empty() ? "" : fmt::format("{:08X} ", line.address + begin);
            for (std::size_t i = begin; i < std::min(begin + in_row, line.bytes.size()); ++i)
                row += fmt::format(" {:02X}", line.bytes[i]);
            text += source.empty() ? row + '\n' : fmt::format("{:34} {}\n", row, std::exchange(source, ""));
        }
    }
    return text;
}

Assembly assemble(std::string_view source, Word origin, std::optional<Model> model) {
    return Assembler(source, origin, model).run();
}

} // namespace placedpar::transputer
