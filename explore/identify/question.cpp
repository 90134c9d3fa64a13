#include "explore/identify/question.hpp"

#include "identification/compliance_search.hpp"
#include "identification/offset_calibration.hpp"
#include "identification/on_line/population_sets.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

LinkSet links_of(const std::string& text) {
    LinkSet links;
    for (std::size_t start = 0, end = 0; end != std::string::npos; start = end + 1) {
        end = text.find(',', start);
        std::string name = text.substr(start, end - start);
        auto link = link_named(name);
        if (!link)
            throw UserError(
                fmt::format("--link {}: unknown link \"{}\"; the links are bucket, boom, stick and swing", text, name));
        if (links.contains(*link))
            throw UserError(fmt::format("--link {}: {} is named twice", text, name_of(*link)));
        links.insert(*link);
    }
    return links;
}

std::optional<AreasFrom> areas_asked(const IdentifySettings& settings) {
    if (settings.areas.empty())
        return std::nullopt;
    return settings.areas == "spool"   ? AreasFrom::spool
           : settings.areas == "servo" ? AreasFrom::servo
                                       : AreasFrom::areas;
}

Side side_asked(const IdentifySettings& settings) { return settings.side == "outlet" ? Side::outlet : Side::inlet; }

double offset_asked(const std::string& text) {
    std::optional<double> inches = parse_number<double>(text);
    if (!inches || !(std::abs(*inches) <= greatest_spool_offset_in))
        throw UserError(fmt::format("--offset {}: expected auto, none, or a number of inches from -{} to {}", text,
                                    greatest_spool_offset_in, greatest_spool_offset_in));
    return *inches;
}

RecordNeeds needs_of(const IdentifySettings& settings, std::function<LinkSet(const ChannelSet&)> links) {
    auto needed = [asked = areas_asked(settings), side = side_asked(settings),
                   links = std::move(links)](const ChannelSet& there) {
        ChannelSet needed;
        for (Link link : links_of(links(there)))
            for (const ChannelSet of_link = channels_needed(link, areas_from(there, link, asked, side), side);
                 Sensor sensor : all_sensors)
                if (of_link.contains(link, sensor))
                    needed.insert(link, sensor);
        return needed;
    };
    return {needed, settings.missing == "skip"};
}

boost::json::object sampling_json(const Sampling& sampling) {
    return {
        {"reading_s", sampling.reading_s}, {"readings_a_sample", sampling.readings}, {"sample_s", sampling.period_s()}};
}

boost::json::array warnings_json(const std::vector<Diagnostic>& warnings) {
    boost::json::array array;
    for (const Diagnostic& warning : warnings)
        array.push_back({{"line", warning.location.line},
                         {"column", warning.location.column},
                         {"message", warning.message},
                         {"hint", warning.hint}});
    return array;
}

} // namespace placedpar
