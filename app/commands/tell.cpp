#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "monitor/service/send_command.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

namespace json = boost::json;

struct TellOptions {
    monitor::ServicePlace place;
    std::vector<std::string> words;
    std::size_t for_s = 8 * 3600;
};

/// A command for the monitor, and the number of words that follow it.
struct Saying {
    const char* name;
    std::size_t least_words, most_words;
    const char* words;
};
constexpr Saying sayings[]{
    {"alarms", 0, 0, ""},
    {"load", 0, 0, ""},
    {"forget", 1, 1, " MACHINE"},
    {"acknowledge", 2, 6, " MACHINE ALARM [LINK...]"},
    {"shelve", 2, 6, " MACHINE ALARM [LINK...]"},
};

[[noreturn]] void refuse_words(const std::string& wrong) {
    std::string right;
    for (const Saying& each : sayings)
        right += fmt::format("{}{}{}", right.empty() ? "" : ", ", each.name, each.words);
    throw UserError(fmt::format("{}; expected one of: {}", wrong, right));
}

std::string message_of(const TellOptions& options) {
    const std::vector<std::string>& words = options.words;
    const auto* saying = std::ranges::find(sayings, words[0], &Saying::name);
    if (saying == std::end(sayings))
        refuse_words(fmt::format("\"{}\" is not a command for the monitor", words[0]));
    std::size_t more = words.size() - 1;
    if (more < saying->least_words || more > saying->most_words)
        refuse_words(fmt::format("the command {} has a wrong number of arguments: {}", words[0], more));
    json::object message{{"type", words[0]}};
    if (more >= 1)
        message["machine"] = words[1];
    if (more >= 2) {
        message["alarm"] = words[2];
        message["links"] = json::array(words.begin() + 3, words.end());
    }
    if (words[0] == "shelve")
        message["for_s"] = options.for_s;
    return json::serialize(message);
}

ExitCode tell(const Options& typed, const TellOptions& options) {
    if (typed.is_given("--for") && options.words[0] != "shelve")
        throw UserError("--for has no effect: it states how long the command shelve takes effect");
    std::string message = message_of(options);
    if (options.place.port == 0 && options.place.unix_path.empty())
        throw UserError("the monitor's address is missing: give --port N or --unix PATH");
    print_out(monitor::ask_service(options.place, message));
    return ExitCode::success;
}

Action declare_tell(Options& command, const std::string&) {
    auto options = std::make_shared<TellOptions>();
    command
        .add("WORDS", options->words,
             "the command: alarms, load, forget MACHINE, acknowledge MACHINE ALARM "
             "LINK... or shelve MACHINE ALARM LINK...")
        .required();
    command.add("--address", options->place.address, "host on which the monitor listens").show_default();
    add_number(command, "--port", options->place.port, 1, 65535, "port on which the monitor listens");
    add_file(command, "--unix", options->place.unix_path, "the monitor's socket file, instead of a port", "PATH");
    add_file(command, "--token-file", options->place.token_file, "file with the token that the monitor expects");
    add_number(command, "--for", options->for_s, 0, 30 * 86400,
               "shelve: seconds without notifications of the alarm; 0 ends the shelving; default: 28800");
    return [options, command] { return tell(command, *options); };
}

} // namespace

/// This command sends one message to a running monitor and prints the monitor's answer, a line of JSON.
extern const Command tell_command{
    .name = "tell",
    .about = "Sends a command to a running monitor: list alarms, acknowledge or shelve one, forget a machine",
    .place = 140,
    .declare = declare_tell,
};

} // namespace placedpar
