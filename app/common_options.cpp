#include "app/common_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>

namespace placedpar {

std::string not_a_whole_number(const std::string& text) {
    std::uint64_t number = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size())
        return "";
    return fmt::format("\"{}\" is no whole number from 0 to {}", text, std::numeric_limits<std::uint64_t>::max());
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
    command.add_option("--seed", seed, "of every random stream")
        ->type_name("N")
        ->check(not_a_whole_number)
        ->capture_default_str();
}

void add_output(CLI::App& command, const std::string& option, std::string& path, const std::string& about) {
    command.add_option(option, path, about)->type_name("FILE")->check([](const std::string& name) {
        return name.empty() ? "it takes the name of a file" : "";
    });
}

} // namespace placedpar
