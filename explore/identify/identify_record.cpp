#include "explore/identify/identify_record.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace placedpar {

namespace {

/// Throws UserError for the first setting that was given although the way lacks it.
template <std::size_t n>
void require_lacking(const std::array<std::pair<const char*, bool>, n>& settings, const char* why) {
    for (const auto& [name, given] : settings)
        if (given)
            throw UserError(fmt::format("{} works only with --way thesis{}", name, why));
}

} // namespace

void settle_way(IdentifySettings& settings) {
    if (settings.side == "outlet" && settings.way == "service")
        throw UserError("--side outlet works only with --way thesis or whole; --way service identifies inlet sides");
    if (settings.way.empty())
        settings.way = settings.side == "outlet" ? "whole" : "service";
    if (settings.way != "service" && settings.configuration.empty())
        settings.configuration = "a";
    if (settings.way == "whole")
        require_lacking<2>({{{"--rising", settings.rising}, {"--window", settings.window.has_value()}}},
                           "; --way whole uses all samples at once");
    if (settings.way == "service")
        require_lacking<4>({{{"--samples", settings.samples.has_value()},
                             {"--rising", settings.rising},
                             {"--coding", !settings.coding.empty()},
                             {"--offset auto", settings.offset == "auto"}}},
                           ", which searches the first transient; --way service uses all movements in order");
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
