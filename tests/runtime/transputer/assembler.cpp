#include "assembler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <utility>

namespace placedpar::test {

namespace assembling {

constexpr std::array<std::string_view, 16> functions{"j",   "ldlp", "pfix", "ldnl", "ldc", "ldnlp", "nfix", "ldl",
                                                     "adc", "call", "cj",   "ajw",  "eqc", "stl",   "stnl", "opr"};
constexpr unsigned load_constant = 4, operate = 15;
constexpr int fpentry = 0xAB;

// Codes of operations, and of operations that the floating-point unit selects by a number.
constexpr std::string_view operations =
    "00 rev 01 lb 02 bsub 03 endp 04 diff 05 add 06 gcall 07 in 08 prod 09 gt 0A wsub 0B out 0C sub 0D startp "
    "0E outbyte 0F outword 10 seterr 12 resetch 13 csub0 15 stopp 16 ladd 17 stlb 18 sthf 19 norm 1A ldiv "
    "1B ldpi 1C stlf 1D xdble 1E ldpri 1F rem 20 ret 21 lend 22 ldtimer 24 testlde 25 testldd 27 testste "
    "28 teststd 29 testerr 2A testpranal 2B tin 2C div 2D testhardchan 2E dist 2F disc 30 diss 31 lmul 32 not "
    "33 xor 34 bcnt 35 lshr 36 lshl 37 lsum 38 lsub 39 runp 3A xword 3B sb 3C gajw 3D savel 3E saveh 3F wcnt "
    "40 shr 41 shl 42 mint 43 alt 44 altwt 45 altend 46 and 47 enbt 48 enbc 49 enbs 4A move 4B or 4C csngl "
    "4D ccnt1 4E talt 4F ldiff 50 sthb 51 taltwt 52 sum 53 mul 54 sttimer 55 stoperr 56 cword 57 clrhalterr "
    "58 sethalterr 59 testhalterr 5A dup 5B move2dinit 5C move2dall 5D move2dnonzero 5E move2dzero "
    "63 unpacksn 6C postnormsn 6D roundsn 71 ldinf 72 fmul 73 cflerr 74 crcword 75 crcbyte 76 bitcnt "
    "77 bitrevword 78 bitrevnbits 79 pop 7A timerdisableh 7B timerdisablel 7C timerenableh 7D timerenablel "
    "7E ldmemstartval 81 wsubdb 82 fpldnldbi 83 fpchkerror 84 fpstnldb 86 fpldnlsni 87 fpadd 88 fpstnlsn "
    "89 fpsub 8A fpldnldb 8B fpmul 8C fpdiv 8E fpldnlsn 8F fpremfirst 90 fpremstep 91 fpnan 92 fpordered "
    "93 fpnotfinite 94 fpgt 95 fpeq 96 fpi32tor32 98 fpi32tor64 9A fpb32tor64 9C fptesterror 9D fprtoi32 "
    "9E fpstnli32 9F fpldzerosn A0 fpldzerodb A1 fpint A3 fpdup A4 fprev A6 fpldnladddb A8 fpldnlmuldb "
    "AA fpldnladdsn AB fpentry AC fpldnlmulsn B1 break B2 clrj0break B3 setj0break B4 testj0break 17C lddevid";

constexpr std::string_view entries =
    "01 fpusqrtfirst 02 fpusqrtstep 03 fpusqrtlast 04 fpurp 05 fpurm 06 fpurz 07 fpur32tor64 08 fpur64tor32 "
    "09 fpuexpdec32 0A fpuexpinc32 0B fpuabs 0D fpunoround 0E fpuchki32 0F fpuchki64 11 fpudivby2 "
    "12 fpumulby2 22 fpurn 23 fpuseterror 9C fpuclearerror";

/// Returns the text without the space around it.
std::string_view trimmed(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    return text;
}

/// Removes and returns the text before the first separator, or all of the text. Both lose the space around them.
std::string_view cut(std::string_view& text, std::string_view separators) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    const auto part = trimmed(text.substr(0, end));
    text = trimmed(text.substr(std::min(end + 1, text.size())));
    return part;
}

using Codes = std::map<std::string_view, int>;

Codes codes_of(std::string_view table) {
    Codes codes;
    while (!table.empty()) {
        const auto code = cut(table, " ");
        codes[cut(table, " ")] = static_cast<int>(std::strtol(std::string(code).c_str(), nullptr, 16));
    }
    return codes;
}

int code_of(const Codes& codes, std::string_view name) {
    const auto found = codes.find(name);
    return found == codes.end() ? -1 : found->second;
}

const Codes& operation_codes() {
    static const Codes codes = codes_of(operations);
    return codes;
}

const Codes& entry_codes() {
    static const Codes codes = codes_of(entries);
    return codes;
}

bool is_name(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.'; };
    return !text.empty() && letter(text.front()) &&
           std::ranges::all_of(text, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

class Assembler {
public:
    Assembler(std::string_view source, std::uint32_t origin)
        : program_{.origin = origin, .bytes{}, .labels{}, .lines{}} {
        for (std::size_t from = 0; from <= source.size();) {
            const auto end = std::min(source.find('\n', from), source.size());
            add_line(source.substr(from, end - from));
            from = end + 1;
        }
    }

    /// Assembles until no instruction needs more bytes. Each begins with one byte and only grows, so this ends.
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
        std::string label, mnemonic, operand;
        std::uint32_t address = 0;
        std::vector<std::uint8_t> bytes{};
    };

    void add_line(std::string_view text) {
        program_.lines.push_back({0, {}, std::string(text)});
        line_ = program_.lines.size();
        std::string_view rest = text.substr(0, text.find("--"));
        std::string_view label;
        if (rest.find(':') != rest.npos) {
            label = cut(rest, ":");
            if (!is_name(label) || !program_.labels.emplace(label, program_.origin).second)
                fail(fmt::format("\"{}\" is no name, or a name that another line has: choose another label", label));
        }
        do {
            std::string_view statement = cut(rest, ";");
            const auto mnemonic = cut(statement, " \t");
            statements_.push_back({line_, std::string(label), std::string(mnemonic), std::string(statement)});
            label = "";
        } while (!rest.empty());
    }

    /// Assembles all statements with the addresses of the previous pass. Returns whether any address has changed.
    bool pass() {
        for (Statement& each : statements_) {
            line_ = each.line;
            each.bytes = bytes(each, each.address, each.bytes.size());
        }
        bool changed = false;
        std::uint32_t address = program_.origin;
        for (Statement& each : statements_) {
            if (each.mnemonic == ".align")
                each.bytes.resize(-address % 4);
            if (!each.label.empty())
                program_.labels.find(each.label)->second = address;
            changed |= std::exchange(each.address, address) != address;
            address += static_cast<std::uint32_t>(each.bytes.size());
        }
        return changed;
    }

    std::vector<std::uint8_t> bytes(const Statement& statement, std::uint32_t address, std::size_t least) {
        const std::string_view name = statement.mnemonic, operand = statement.operand;
        if (name.empty() || name == ".align")
            return {};
        if (name == ".byte" || name == ".word")
            return data(operand, name == ".byte" ? 1 : 4);
        if (const auto found = std::ranges::find(functions, name); found != functions.end())
            return direct(static_cast<unsigned>(found - functions.begin()), operand, address, least);
        if (!operand.empty())
            fail(fmt::format("\"{}\" has no operand", name));
        if (const int code = code_of(operation_codes(), name); code >= 0)
            return instruction(operate, code);
        const int entry = code_of(entry_codes(), name);
        if (entry < 0)
            fail(fmt::format("\"{}\" is no instruction", name));
        auto both = instruction(load_constant, entry);
        const auto last = instruction(operate, fpentry);
        both.insert(both.end(), last.begin(), last.end());
        return both;
    }

    std::vector<std::uint8_t> direct(unsigned function, std::string_view operand, std::uint32_t address,
                                     std::size_t least) {
        bool has_label = false;
        const std::uint32_t sum = value(operand, has_label);
        if (!sizes_known_)
            return {0};
        if (functions[function] == "pfix" || functions[function] == "nfix")
            return {static_cast<std::uint8_t>(function << 4 | (sum & 15))};
        const bool jumps = functions[function] == "j" || functions[function] == "cj" || functions[function] == "call";
        if (!jumps || !has_label)
            return instruction(function, static_cast<std::int32_t>(sum), least);
        // The distance counts from the next instruction, so a longer instruction may need a longer distance.
        for (std::size_t length = std::max(least, std::size_t{1});; ++length)
            if (auto code = instruction(function, static_cast<std::int32_t>(sum - address - length), length);
                code.size() == length)
                return code;
    }

    std::vector<std::uint8_t> data(std::string_view list, std::size_t size) {
        std::vector<std::uint8_t> bytes;
        do {
            bool has_label = false;
            const std::uint32_t sum = value(cut(list, ","), has_label);
            for (std::size_t i = 0; i < size; ++i)
                bytes.push_back(static_cast<std::uint8_t>(sum >> 8 * i));
        } while (!list.empty());
        return bytes;
    }

    /// Returns the value of a sum of numbers and labels.
    std::uint32_t value(std::string_view sum, bool& has_label) {
        if (sum.empty())
            fail("the operand is missing");
        std::uint32_t total = 0;
        while (!sum.empty()) {
            const bool negative = sum.front() == '-';
            if (negative || sum.front() == '+')
                sum.remove_prefix(1);
            const std::size_t length = std::min(sum.find_first_of("+-"), sum.size());
            const std::uint32_t each = term(trimmed(sum.substr(0, length)), has_label);
            total += negative ? -each : each;
            sum.remove_prefix(length);
        }
        return total;
    }

    std::uint32_t term(std::string_view text, bool& has_label) {
        if (is_name(text)) {
            const auto found = program_.labels.find(text);
            if (found == program_.labels.end())
                fail(fmt::format("no line has the label \"{}\"", text));
            has_label = true;
            return found->second;
        }
        const bool hexadecimal = text.starts_with('#');
        std::uint32_t number = 0;
        const char* const end = text.data() + text.size();
        const auto [last, failed] = std::from_chars(text.data() + hexadecimal, end, number, hexadecimal ? 16 : 10);
        if (failed != std::errc{} || last != end)
            fail(fmt::format("\"{}\" is neither a number of 32 bits nor a label", text));
        return number;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw AssemblyError(fmt::format("line {}: {}", line_, what));
    }

    Assembly program_;
    std::vector<Statement> statements_;
    std::size_t line_ = 0;     ///< the number of the line under way
    bool sizes_known_ = false; ///< false while labels do not have addresses yet
};

} // namespace assembling

std::vector<std::uint8_t> instruction(unsigned function, std::int32_t operand, std::size_t least) {
    // A prefix shifts what has been loaded by 4 bits. The first prefix of a negative operand is nfix, which
    // complements.
    const std::int64_t value = operand;
    std::size_t length = std::max(least, std::size_t{operand < 0 ? 2U : 1U});
    while (length < 8 && (value >= std::int64_t{1} << 4 * length || value < -(std::int64_t{1} << 4 * length)))
        ++length;
    std::vector<std::uint8_t> bytes;
    for (std::size_t place = length; place-- > 0;) {
        const bool complement = operand < 0 && place + 1 == length;
        const auto four = static_cast<unsigned>((complement ? ~value : value) >> 4 * place) & 15;
        bytes.push_back(static_cast<std::uint8_t>((place == 0 ? function : complement ? 6 : 2) << 4 | four));
    }
    return bytes;
}

int operation_code(std::string_view mnemonic) { return assembling::code_of(assembling::operation_codes(), mnemonic); }

std::uint32_t Assembly::operator[](std::string_view label) const {
    const auto found = labels.find(label);
    if (found == labels.end())
        throw std::out_of_range(fmt::format("no line has the label \"{}\"", label));
    return found->second;
}

std::string Assembly::listing() const {
    std::string text;
    for (const Line& line : lines) {
        std::string bytes_of_line;
        for (const auto byte : line.bytes)
            bytes_of_line += fmt::format("{:02X} ", byte);
        text += line.bytes.empty() ? fmt::format("{:36}{}\n", "", line.source)
                                   : fmt::format("{:08X}  {:26}{}\n", line.address, bytes_of_line, line.source);
    }
    return text;
}

Assembly assemble(std::string_view source, std::uint32_t origin) { return assembling::Assembler(source, origin).run(); }

} // namespace placedpar::test
