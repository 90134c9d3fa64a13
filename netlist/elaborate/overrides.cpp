#include "netlist/elaborate/overrides.hpp"

#include "netlist/elaborate/elaborator.hpp"
#include "netlist/language/parser.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

struct ParsedOverride {
    ExpressionPointer value;
    Location at;
};

/// The text "NAME=VALUE" as a source of its own, so that messages can show it.
ParsedOverride parse_override(const std::string& name, const std::string& value, Reporter& reporter) {
    auto source = check_source("--set", name + "=" + value);
    Location at{source.file, 1, 1};
    for (const auto& problem : source.problems) {
        reporter.error(at, problem.message);
        throw StatementRefused{};
    }
    TokenStream tokens(source.file, "--set", reporter);
    auto first = tokens.take();
    auto second = tokens.take();
    if (first.kind != TokenKind::name || !second.is("=")) {
        reporter.error(at, "this sets no val", "--set NAME=VALUE");
        throw StatementRefused{};
    }
    return {Parser(tokens, reporter).parse_whole_expression(), at};
}

} // namespace

Constant Elaborator::overridden(const std::string& name, const Constant& original, const std::string& text) {
    auto parsed = parse_override(name, text, reporter_);
    auto value = evaluator_.evaluate(*parsed.value);
    if (value.value.index() != original.value.index() && !(value.integer() != nullptr && original.real() != nullptr))
        refuse(parsed.at, fmt::format("wrong type for the val \"{}\": {} is {}", name, shown(value), type_name(value)),
               fmt::format("the netlist gives it {}, {}", shown(original), type_name(original)));
    return value;
}

void Elaborator::check_overrides() {
    for (const auto& [name, text] : overrides_) {
        if (std::find(vals_seen_.begin(), vals_seen_.end(), name) != vals_seen_.end())
            continue;
        auto source = std::make_shared<SourceFile>("--set", name + "=" + text);
        auto hint = did_you_mean(name, vals_seen_);
        reporter_.error({source, 1, 1}, fmt::format("the netlist has no val \"{}\" outside of blocks", name),
                        vals_seen_.empty() ? "it has none at all" : hint);
    }
}

} // namespace placedpar
