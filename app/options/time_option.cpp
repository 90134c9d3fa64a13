#include "app/options/time_option.hpp"

#include "text/user_error.hpp"

namespace placedpar {

CLI::Option* add_time(CLI::App& command, const std::string& option, Time& time, const std::string& about) {
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
            option, [&time](const std::string& text) { time = parse_time(text); }, about)
        ->type_name("TIME")
        ->check(check);
}

} // namespace placedpar
