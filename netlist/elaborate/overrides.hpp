#pragma once

#include "netlist/elaborate/constant.hpp"
#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// `--set NAME=VALUE`, by its NAME: a val outside of blocks, `PROCESS.PARAMETER`, `ELEMENT.ATTRIBUTE`, or an attribute
/// or a parameter of every element that has it. The value is an expression.
using Overrides = std::map<std::string, std::string>;

/// `--use PROGRAM=KIND`: the kinds that take the place of programs, by what `use` calls these.
using ProgramKinds = std::map<std::string, std::string>;

/// The value that an option gives. Where a text is wanted it needs no quotes, so what is no expression is not refused
/// before it is known what takes it.
struct OverrideValue {
    std::string typed;
    Location at;
    std::optional<Constant> constant = {};
    std::vector<Diagnostic> problems = {}; ///< why there is no constant

    /// Throws StatementRefused after having reported why there is no value, and what would be right: "it takes an
    /// integer".
    Constant take(bool text_wanted, const std::string& what_it_takes, Reporter&) const;
};

/// One option, read. What it names and what the value is come out when the netlist is known.
struct Override {
    Reference target;
    ExpressionPointer expression; ///< of no use where the value has problems
    OverrideValue value;
};

/// Does what may refuse a text, and reports why then.
template <class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const StatementRefused&) { // and reported
    } catch (const GiveUp&) {
    }
}

/// Throws StatementRefused after having reported a name that can be none.
Override read_override(const std::string& name, const std::string& value, Reporter&);

} // namespace placedpar
