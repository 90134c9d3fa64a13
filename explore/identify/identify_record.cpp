#include "explore/identify/identify_record.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <initializer_list>

namespace placedpar {

namespace {

/// A setting that has no effect with the chosen way of identification (--way).
struct Lacking {
    const char* name;
    bool is_given;
    const char* ways = "thesis"; ///< the ways in which the setting has an effect
};

/// Throws UserError if the user gave one of these settings. The message names the first of them.
void require_lacking(std::initializer_list<Lacking> settings, const std::string& why) {
    for (const Lacking& each : settings)
        if (each.is_given)
            throw UserError(fmt::format("{} works only with --way {}; {}", each.name, each.ways, why));
}

void require_in_range(const IdentifySettings& settings) {
    using Given = IdentifySettings;
    struct Limits {
        const char* name;
        std::optional<std::size_t> given;
        std::size_t least, most;
    };
    for (const Limits& each : {Limits{"--bits", settings.bits, Given::least_bits, Given::most_bits},
                               {"--elite", settings.elite, 0, Given::a_million},
                               {"--population", settings.population, 2, Given::a_million},
                               {"--trials", settings.trials, 1, Given::a_million},
                               {"--window", settings.window, 1, Given::most_window},
                               {"--samples", settings.samples, 1, Given::a_million}})
        if (each.given && (*each.given < each.least || *each.given > each.most))
            throw UserError(fmt::format("{} {}: expected {} to {}", each.name, *each.given, each.least, each.most));
}

} // namespace

std::string shown_way(const IdentifySettings& settings) {
    return fmt::format("--way {}{}", settings.way,
                       !settings.has_default_way   ? ""
                       : settings.side == "outlet" ? " (the default with --side outlet)"
                                                   : " (the default)");
}

void settle_way(IdentifySettings& settings) {
    require_in_range(settings);
    if (settings.side == "outlet" && settings.way == "service")
        throw UserError("--side outlet works only with --way thesis or whole; --way service identifies inlet sides");
    settings.has_default_way = settings.way.empty();
    if (settings.way.empty())
        settings.way = settings.side == "outlet" ? "whole" : "service";
    if (settings.way != "service" && settings.configuration.empty())
        settings.configuration = "a";
    if (settings.way == "whole")
        require_lacking({{"--rising", settings.rising}, {"--window", settings.window.has_value()}},
                        shown_way(settings) + " uses all samples at once");
    if (settings.way == "service")
        require_lacking({{"--samples", settings.samples.has_value(), "thesis or whole"},
                         {"--rising", settings.rising},
                         {"--coding", !settings.coding.empty(), "thesis or whole"},
                         {"--offset auto", settings.offset == "auto"}},
                        shown_way(settings) + " identifies as placedpar monitor does, which has no such setting");
}

IdentifyEnd identify_record(const IdentifySettings& settings, const RecordInput& input, const IdentifyOutput& output) {
    if (settings.way == "service")
        return identify_as_service(settings, input, output);
    if (settings.way == "whole")
        return identify_over_whole(settings, input, output);
    const ThesisAnswer answer = identify_by_thesis(settings, input, output);
    output.print(answer.text);
    return answer.identified.flagged() ? IdentifyEnd::doubtful : IdentifyEnd::sound;
}

} // namespace placedpar
