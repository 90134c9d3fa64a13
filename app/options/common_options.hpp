#pragma once

#include "app/options.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace placedpar {

// These options have the same meaning and the same checks in every command.

// These functions are for Option::check(). Each returns a description of what is wrong with a value, or "".
std::string not_a_whole_number(const std::string& text);
std::string not_a_number_within(const std::string& text, std::uint64_t least, std::uint64_t most);
std::string not_at_least_one(const std::string& text); ///< checks a whole number
std::string not_a_name(const std::string& text);       ///< checks a name, which cannot be ""
/// Does what not_a_name() does, and refuses "-", too: for commands that do not read standard input.
std::string not_a_named_file(const std::string& text);

/// Declares --seed, with `about` as its text in help.
void add_seed(Options& command, std::uint64_t& seed,
              const std::string& about = "seed of all random numbers: equal seeds give equal runs");

/// Declares an option whose value is a count: digits only, for a number of at most 64 bits. CLI11, the library that
/// parses options, is less strict. It would read -1 or a number that is too large as the greatest number, and 010 as
/// eight.
template <class Count>
Option add_count(Options& command, const std::string& option, Count& count, const std::string& about) {
    return command.add(option, count, about).type("N").check(not_a_whole_number);
}

/// Declares --jobs, the number of parallel threads. If the option is not typed, `jobs` stays unchanged.
void add_jobs(Options& command, std::size_t& jobs, const std::string& about);

/// Declares an option that accepts digits only, for a number from `least` to `most`.
template <class Number>
Option add_number(Options& command, const std::string& option, Number& value, std::uint64_t least, std::uint64_t most,
                  const std::string& about) {
    auto check = [least, most](const std::string& text) { return not_a_number_within(text, least, most); };
    return command.add(option, value, about).check(check).type(std::to_string(least) + ".." + std::to_string(most));
}

/// Declares an option that takes the name of a file, or another name, which help calls `type`. The name cannot be "".
Option add_file(Options& command, const std::string& option, std::string& path, const std::string& about,
                const std::string& type = "FILE");

} // namespace placedpar
