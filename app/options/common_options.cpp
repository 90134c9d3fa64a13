#include "app/options/common_options.hpp"

#include "text/number.hpp"
#include "text/standard_streams.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>

namespace placedpar {

std::string not_a_whole_number(const std::string& text) {
    return not_a_number_within(text, 0, std::numeric_limits<std::uint64_t>::max());
}

std::string not_a_number_within(const std::string& text, std::uint64_t least, std::uint64_t most) {
    std::optional<std::uint64_t> number = parse_number<std::uint64_t>(text);
    bool octal = text.size() > 1 && text[0] == '0'; // CLI11 would read such a number as octal
    bool right = number && !octal && *number >= least && *number <= most;
    return right ? "" : fmt::format("\"{}\" is not a whole number from {} to {}", text, least, most);
}

std::string not_at_least_one(const std::string& text) { return text == "0" ? "expected at least 1" : ""; }

std::string not_a_name(const std::string& text) {
    return text.empty() ? "the name is empty; expected a file name" : "";
}

std::string not_a_named_file(const std::string& text) {
    return is_standard_stream(text) ? "this command does not read standard input; expected the name of a file"
                                    : not_a_name(text);
}

void add_seed(Options& command, std::uint64_t& seed, const std::string& about) {
    add_count(command, "--seed", seed, about).show_default();
}

void add_jobs(Options& command, std::size_t& jobs, const std::string& about) {
    constexpr std::uint64_t most = 1000; // few enough that all threads can be started
    add_number(command, "--jobs", jobs, 1, most, about);
}

Option add_file(Options& command, const std::string& option, std::string& path, const std::string& about,
                const std::string& type) {
    return command.add(option, path, about).type(type).check(not_a_name);
}

} // namespace placedpar
