#pragma once

#include <map>
#include <string>

namespace placedpar {

/// Holds the options `--set NAME=VALUE`, by NAME. NAME is a val outside of blocks, `PROCESS.PARAMETER`,
/// `ELEMENT.ATTRIBUTE`, or an attribute or parameter to be set in every element that has it. VALUE is an expression.
using Overrides = std::map<std::string, std::string>;

/// Holds the options `--use PROGRAM=KIND`, by PROGRAM, which is the program's name in a `use` statement. The kind
/// replaces the program.
using ProgramKinds = std::map<std::string, std::string>;

} // namespace placedpar
