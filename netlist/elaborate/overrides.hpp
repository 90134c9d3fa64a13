#pragma once

#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <map>
#include <string>
#include <vector>

namespace placedpar {

/// `--set NAME=VALUE`, by its NAME: a val outside of blocks, `PROCESS.PARAMETER`, `ELEMENT.ATTRIBUTE`, or an attribute
/// or a parameter of every element that has it. The value is an expression.
using Overrides = std::map<std::string, std::string>;

/// `--use PROGRAM=KIND`: the kinds that take the place of programs, by what `use` calls these.
using ProgramKinds = std::map<std::string, std::string>;

/// Does what may refuse a text, and reports why then.
template <class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const StatementRefused&) { // and reported
    } catch (const GiveUp&) {
    }
}

/// Reads overrides as statements that come behind those of the netlist, the most precise first. Each is a source of its
/// own that messages can show.
Statements read_overrides(const Overrides&, Reporter&);
/// Reads what `--fault` says likewise.
Statements read_faults(const std::vector<std::string>&, Reporter&);

} // namespace placedpar
