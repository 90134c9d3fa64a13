#pragma once

#include <map>
#include <string>

namespace placedpar {

/// `--set NAME=VALUE`: the val NAME takes the value of the expression VALUE. Only vals outside of blocks.
using Overrides = std::map<std::string, std::string>;

/// `--use PROGRAM=KIND`: the kinds that take the place of programs, by what `use` calls these.
using ProgramKinds = std::map<std::string, std::string>;

} // namespace placedpar
