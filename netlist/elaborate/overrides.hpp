#pragma once

#include <map>
#include <string>

namespace placedpar {

/// The options `--set NAME=VALUE`, by NAME. NAME is a val outside of blocks, `PROCESS.PARAMETER`, `ELEMENT.ATTRIBUTE`,
/// or an attribute or parameter to be set in every element that has it. VALUE is an expression.
using Overrides = std::map<std::string, std::string>;

/// The options `--use PROGRAM=KIND`, by PROGRAM, the program's name in `use`. The kind replaces the program.
using ProgramKinds = std::map<std::string, std::string>;

} // namespace placedpar
