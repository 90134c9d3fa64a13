#include "netlist/elaborate/option_statements.hpp"

#include "netlist/language/parser.hpp"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <functional>

namespace placedpar {

namespace {

std::shared_ptr<const SourceFile> source_of(const char* option, const std::string& text, Reporter& reporter) {
    LoadedSource source = check_source(option, text);
    if (source.problems.empty())
        return source.file;
    reporter.error({source.file, 1, 1}, source.problems.front().message);
    throw StatementRefused{};
}

/// Reads `--set NAME=VALUE`. If VALUE has errors, they are stored in SetStatement::problems instead of being reported,
/// since VALUE may be a text without quotes.
SetStatement read_override(const std::string& name, const std::string& value, Reporter& reporter) {
    static constexpr const char* blanks = " \t";
    std::shared_ptr<const SourceFile> source = source_of("--set", name + "=" + value, reporter);
    const std::size_t blank = std::min(value.find_first_not_of(blanks), value.size());
    SetStatement set;
    set.typed = boost::algorithm::trim_copy_if(value, boost::algorithm::is_any_of(blanks));
    set.value_at = {source, 1, name.size() + 1 + blank + 1};
    Reporter here;
    TokenStream tokens(source, "--set", here);
    Parser parser(tokens, here);
    attempt([&] { set.target = parser.parse_target(); });
    if (!here.failed()) {
        attempt([&] { set.value = parser.parse_whole_expression(); });
        set.problems = here.take();
        return set;
    }
    for (const Diagnostic& problem : here.take())
        reporter.error(problem.location, problem.message, problem.hint, problem.others);
    throw StatementRefused{};
}

std::size_t precision(const Statement& statement) { return std::get<SetStatement>(statement.form).precision(); }

} // namespace

Statements read_overrides(const Overrides& overrides, Reporter& reporter) {
    Statements statements;
    for (const auto& option : overrides)
        attempt([&] {
            SetStatement set = read_override(option.first, option.second, reporter);
            set.place = statements.size();
            statements.push_back({set.target.at, std::move(set)});
        });
    std::ranges::stable_sort(statements, std::ranges::greater{}, precision);
    return statements;
}

Statements read_faults(const std::vector<std::string>& texts, Reporter& reporter) {
    Statements statements;
    for (const std::string& text : texts)
        attempt([&] {
            TokenStream tokens(source_of("--fault", text, reporter), "--fault", reporter);
            statements.push_back(Parser(tokens, reporter).parse_fault_option());
        });
    return statements;
}

} // namespace placedpar
