#include "netlist/elaborate/overrides.hpp"

#include "netlist/language/parser.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

constexpr std::string_view blank_characters = " \t";

[[noreturn]] void pass_on(const std::vector<Diagnostic>& problems, Reporter& reporter) {
    for (const Diagnostic& problem : problems)
        reporter.error(problem.location, problem.message, problem.hint, problem.others);
    throw StatementRefused{};
}

std::string without_blanks_around(std::string text) {
    text.erase(0, text.find_first_not_of(blank_characters));
    text.erase(text.find_last_not_of(blank_characters) + 1);
    return text;
}

/// The option's text as a source of its own, so that messages can show it.
std::shared_ptr<const SourceFile> source_of(const std::string& name, const std::string& value, Reporter& reporter) {
    LoadedSource source = check_source("--set", name + "=" + value);
    if (!source.problems.empty()) {
        reporter.error({source.file, 1, 1}, source.problems.front().message);
        throw StatementRefused{};
    }
    return source.file;
}

/// Where the first problem has none of its own.
std::vector<Diagnostic> with_hint(std::vector<Diagnostic> problems, const std::string& hint) {
    if (problems.front().hint.empty())
        problems.front().hint = hint;
    return problems;
}

} // namespace

Override read_override(const std::string& name, const std::string& value, Reporter& reporter) {
    std::shared_ptr<const SourceFile> source = source_of(name, value, reporter);
    Override read;
    Reporter here;
    TokenStream tokens(source, "--set", here);
    Parser parser(tokens, here);
    attempt([&] { read.target = parser.parse_target(); });
    if (here.failed())
        pass_on(here.take(), reporter);
    attempt([&] { read.expression = parser.parse_whole_expression(); });
    read.value.problems = here.take();
    std::size_t blank = std::min(value.find_first_not_of(blank_characters), value.size());
    read.value.typed = without_blanks_around(value);
    read.value.at = {source, 1, name.size() + std::string_view("=").size() + blank + 1};
    return read;
}

Constant OverrideValue::take(bool text_wanted, const std::string& what_it_takes, Reporter& reporter) const {
    bool is_text = constant && constant->text() != nullptr;
    if (text_wanted && !is_text && !typed.starts_with('"')) {
        if (typed.size() <= longest_string)
            return {typed};
        pass_on({{.message = fmt::format("the string is too long: {} characters are allowed", longest_string),
                  .location = at}},
                reporter);
    }
    if (typed.empty())
        pass_on({{.message = "the value is missing", .location = at, .hint = what_it_takes}}, reporter);
    if (!constant)
        pass_on(with_hint(problems, what_it_takes), reporter);
    return *constant;
}

} // namespace placedpar
