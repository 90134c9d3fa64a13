#pragma once

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace placedpar {

// Options that mean the same wherever they stand, and refuse the same.

/// For CLI::Option::check: what is wrong with it; "" if nothing is.
std::string not_a_whole_number(const std::string& text);
std::string not_a_number_within(const std::string& text, std::uint64_t least, std::uint64_t most);

/// --seed, of every random stream unless `about` says of what.
void add_seed(CLI::App&, std::uint64_t& seed,
              const std::string& about = "what all random numbers are drawn from: the same seed, the same run");

/// An option that counts something: digits only, and a number that 64 bits hold. CLI11 itself takes -1 and what is too
/// large for the greatest such number, and 010 for eight, which is refused, too.
CLI::Option* add_count(CLI::App&, const std::string& option, std::size_t& count, const std::string& about,
                       const std::string& unit = "N");

/// --jobs: so many at once, each in a thread; `jobs` stays as it is where nothing is said.
void add_jobs(CLI::App&, std::size_t& jobs, const std::string& about);

/// An option that takes digits only, and a number from least to most.
template <class Number>
CLI::Option* add_number(CLI::App& command, const std::string& option, Number& value, std::uint64_t least,
                        std::uint64_t most, const std::string& about) {
    auto check = [least, most](const std::string& text) { return not_a_number_within(text, least, most); };
    return command.add_option(option, value, about)
        ->check(CLI::Validator(check, ""))
        ->type_name(std::to_string(least) + ".." + std::to_string(most));
}

/// An option that names a file, or what else `type` says; it cannot be "".
CLI::Option* add_file(CLI::App&, const std::string& option, std::string& path, const std::string& about,
                      const std::string& type = "FILE");

/// For CLI::Option::check, of a name that cannot be "".
std::string not_a_name(const std::string& text);

} // namespace placedpar
