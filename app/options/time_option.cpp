#include "app/options/time_option.hpp"

#include "text/user_error.hpp"

#include <functional>

namespace placedpar {

namespace {

CLI::Option* add_time_for(CLI::App& command, const std::string& option, const std::function<void(Time)>& take,
                          const std::string& about) {
    auto check = [](const std::string& text) -> std::string {
        try {
            parse_time(text);
            return "";
        } catch (const UserError& refused) {
            return refused.what();
        }
    };
    return command
        .add_option_function<std::string>(
            option, [take](const std::string& text) { take(parse_time(text)); }, about)
        ->type_name("TIME")
        ->check(check);
}

} // namespace

CLI::Option* add_time(CLI::App& command, const std::string& option, Time& time, const std::string& about) {
    return add_time_for(
        command, option, [&time](Time given) { time = given; }, about);
}

CLI::Option* add_time(CLI::App& command, const std::string& option, std::optional<Time>& time,
                      const std::string& about) {
    return add_time_for(
        command, option, [&time](Time given) { time = given; }, about);
}

} // namespace placedpar
