#pragma once

#include <map>
#include <string>

namespace placedpar {

/// `--set NAME=VALUE`, by its NAME: a val outside of blocks, `PROCESS.PARAMETER`, `ELEMENT.ATTRIBUTE`, or the name of
/// an attribute or a parameter, which is then set in every element that has it. The value is an expression.
using Overrides = std::map<std::string, std::string>;

/// `--use PROGRAM=KIND`: kinds that replace programs, by the program's name in `use`.
using ProgramKinds = std::map<std::string, std::string>;

} // namespace placedpar
