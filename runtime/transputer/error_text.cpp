#include "runtime/transputer/error_text.hpp"

#include "runtime/transputer/waiting.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace placedpar::transputer {
namespace {

std::optional<std::int64_t> word_at(const Core& core, Word address) {
    const Word offset = NodeMemory::offset_of(address) & ~Word{3};
    return core.memory().holds(offset, 4) ? std::optional(std::int64_t{signed_of(core.memory().word(offset))})
                                          : std::nullopt;
}

std::int64_t double_word(std::int64_t upper, std::int64_t lower) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(upper) << 32 | static_cast<Word>(lower));
}

/// Returns the number that the text consists of, with or without a sign. Returns nullopt if the text is something else.
std::optional<int> signed_number(std::string_view text) {
    const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
    int number = 0;
    const auto [end, wrong] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return wrong == std::errc{} && end == digits.data() + digits.size() ? std::optional(number) : std::nullopt;
}

/// Returns the number for which a text between braces stands, such as {a-1} or {w+12}. Returns nullopt if the text has
/// no meaning.
std::optional<std::int64_t> number_for(std::string_view text, const Core& core, const ErrorNote& error) {
    if (text == "ba")
        return double_word(error.b, error.a);
    if (text.empty())
        return std::nullopt;
    const char name = text.front();
    const std::optional<int> number = text.size() > 1 ? signed_number(text.substr(1)) : std::optional(0);
    if (!number)
        return std::nullopt;
    const int more = *number;
    const Word address = error.workspace + 4 * static_cast<Word>(more);
    const std::optional<std::int64_t> word = word_at(core, address), above = word_at(core, address + 4);
    if (name == 'w')
        return word;
    if (name == 'l')
        return word && above ? std::optional(double_word(*above, *word)) : std::nullopt;
    if (name < 'a' || name > 'c')
        return std::nullopt;
    return std::int64_t{signed_of(name == 'a' ? error.a : name == 'b' ? error.b : error.c)} + more;
}

/// Returns the text that stands for a text between two braces, without the braces.
std::string text_for(std::string_view between, const Core& core, const ErrorNote& error) {
    const bool is_kind = between.starts_with('/');
    const auto number = number_for(between.substr(is_kind ? 1 : 0), core, error);
    if (!number)
        return fmt::format("{{{}}}", between);
    return !is_kind ? std::to_string(*number) : *number == 0 ? "division by zero" : "overflow";
}

std::string with_numbers(std::string_view text, const Core& core, const ErrorNote& error) {
    std::string result;
    while (!text.empty()) {
        const std::size_t begin = text.find('{'), end = text.find('}', begin);
        result += text.substr(0, begin);
        if (end == std::string_view::npos)
            return result += begin == std::string_view::npos ? "" : text.substr(begin);
        result += text_for(text.substr(begin + 1, end - begin - 1), core, error);
        text.remove_prefix(end + 1);
    }
    return result;
}

/// Returns the text for an instruction for which the compiler's table has no text.
std::string_view usual_text(const CodedInstruction& instruction, const ErrorNote& error) {
    switch (instruction.operation) {
    case Operation::add: return "overflow: {b} + {a}";
    case Operation::sub: return "overflow: {b} - {a}";
    case Operation::mul: return "overflow: {b} * {a}";
    case Operation::fmul: return "overflow of the product of two fractions, {b} and {a}";
    case Operation::div: return error.a == 0 ? "division by zero: {b} / 0" : "overflow: {b} / {a}";
    case Operation::rem: return error.a == 0 ? "division by zero: {b} \\ 0" : "overflow: {b} \\ {a}";
    case Operation::ladd: return "overflow of the upper words: {b} + {a}";
    case Operation::lsub: return "overflow of the upper words: {b} - {a}";
    case Operation::ldiv: return error.a == 0 ? "division by zero" : "overflow of the quotient of a double word";
    case Operation::csub0: return "{b} is outside of the range 0 to {a-1}";
    case Operation::ccnt1: return "{b} is outside of the range 1 to {a}";
    case Operation::cword: return "{b} is outside of the range -{a} to {a-1}";
    case Operation::csngl: return "a double word does not fit in a word";
    case Operation::cflerr: return "a real is an infinity or a NaN";
    case Operation::fpchkerror: return "an operation on reals: overflow, division by zero, an infinity or a NaN";
    default: return "the program has set the Error flag";
    }
}

constexpr Word bytes_of_call = 16;

/// Returns the call of a routine if the text is of the form "called from {w+12}". The number states which word above
/// the workspace holds the return address.
std::optional<ErrorNote> call_named_by(std::string_view text, const Core& core, const ErrorNote& error) {
    constexpr std::string_view begin = "called from {w";
    if (!text.starts_with(begin) || !text.ends_with('}'))
        return std::nullopt;
    const auto words = signed_number(text.substr(begin.size(), text.size() - begin.size() - 1));
    const Word at = error.workspace + 4 * static_cast<Word>(words.value_or(0));
    const auto returns_to = words ? word_at(core, at) : std::nullopt;
    return returns_to ? std::optional<ErrorNote>({static_cast<Word>(*returns_to), at + bytes_of_call}) : std::nullopt;
}

/// Returns the call that the error's text names. If the text of this call names another call, follows the calls, up to
/// a limit, because a wrong program may form a circle.
ErrorNote follow_calls(const Core& core, ErrorNote error, const CodeLines& lines) {
    constexpr int most_calls = 16;
    for (int i = 0; i < most_calls; ++i)
        if (const auto call = call_named_by(lines.error(error.after), core, error))
            error = *call;
    return error;
}

/// Searches the words above the workspace for the return address of a call for which the table has an error text.
ErrorNote find_call(const Core& core, const ErrorNote& error, const CodeLines& lines) {
    constexpr Word most_words = 32;
    if (!lines.error(error.after).empty() || !lines.file_place(error.after - 1).empty())
        return error;
    for (Word i = 0; i < most_words; ++i) {
        const Word at = error.workspace + 4 * i;
        const auto returns_to = static_cast<Word>(word_at(core, at).value_or(0));
        if (!lines.error(returns_to).empty() &&
            instruction_before(core, returns_to).instruction.operation == Operation::call)
            return {returns_to, at + bytes_of_call};
    }
    return error;
}

} // namespace

ErrorNote error_to_name(const Core& core, const ErrorNote& error, const CodeLines& lines) {
    return follow_calls(core, find_call(core, error, lines), lines);
}

std::string print_error(const Core& core, const ErrorNote& error, const CodeLines& lines) {
    if (const std::string_view text = lines.error(error.after); !text.empty())
        return with_numbers(text, core, error);
    const CodedInstruction instruction = instruction_before(core, error.after).instruction;
    if (instruction.operation == Operation::adc) {
        const std::int64_t constant = signed_of(instruction.operand);
        return fmt::format("overflow: {} {} {}", signed_of(error.a), constant < 0 ? '-' : '+',
                           constant < 0 ? -constant : constant);
    }
    return with_numbers(usual_text(instruction, error), core, error);
}

} // namespace placedpar::transputer
