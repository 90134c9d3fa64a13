#pragma once

#include <map>
#include <string>

namespace placedpar {

/// The options `--set NAME=VALUE`, by which a user changes values of a netlist. The key of the map is NAME. NAME is a
/// constant
/// (`val`) outside of blocks, `PROCESS.PARAMETER`, or `ELEMENT.ATTRIBUTE`, where an element is a node, connection or
/// process. NAME can also be an attribute or parameter alone, which is then set in every element that has it. VALUE is
/// an expression.
using Overrides = std::map<std::string, std::string>;

/// Holds the options `--use PROGRAM=KIND` by PROGRAM, a name in a `use` statement. Processes then have this kind in
/// place of the program.
using ProgramKinds = std::map<std::string, std::string>;

} // namespace placedpar
