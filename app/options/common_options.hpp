#pragma once

#include "app/options.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace placedpar {

// Options that mean the same wherever they stand, and refuse the same.

// For Option::check(): what is wrong with a value; "" if nothing is.
std::string not_a_whole_number(const std::string& text);
std::string not_a_number_within(const std::string& text, std::uint64_t least, std::uint64_t most);
std::string not_at_least_one(const std::string& text); ///< of a whole number
std::string not_a_name(const std::string& text);       ///< a name cannot be ""

/// --seed, of every random stream unless `about` says of what.
void add_seed(Options& command, std::uint64_t& seed,
              const std::string& about = "what all random numbers are drawn from: the same seed, the same run");

/// An option that counts something: digits only, and a number that 64 bits hold. CLI11 itself takes -1 and what is too
/// large for the greatest such number, and 010 for eight, which is refused, too.
template <class Count>
Option add_count(Options& command, const std::string& option, Count& count, const std::string& about) {
    return command.add(option, count, about).type("N").check(not_a_whole_number);
}

/// --jobs: so many at once, each in a thread; `jobs` stays as it is where nothing is said.
void add_jobs(Options& command, std::size_t& jobs, const std::string& about);

/// An option that takes digits only, and a number from least to most.
template <class Number>
Option add_number(Options& command, const std::string& option, Number& value, std::uint64_t least, std::uint64_t most,
                  const std::string& about) {
    auto check = [least, most](const std::string& text) { return not_a_number_within(text, least, most); };
    return command.add(option, value, about).check(check).type(std::to_string(least) + ".." + std::to_string(most));
}

/// An option that names a file, or what else `type` says; it cannot be "".
Option add_file(Options& command, const std::string& option, std::string& path, const std::string& about,
                const std::string& type = "FILE");

} // namespace placedpar
