#include "explore/identify/question.hpp"

#include "explore/load.hpp"
#include "identification/compliance_search.hpp"
#include "identification/offset_calibration.hpp"
#include "identification/on_line/population_sets.hpp"
#include "text/number.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// Returns the names in a file with lines such as "boom.inlet_pressure = P_boom_in". Lines that start with '#' are
/// comments.
std::vector<ColumnName> names_in_file(const std::string& path) {
    const std::shared_ptr<const SourceFile> file = load_text(path);
    auto refuse = [&](std::size_t line, const std::string& why) {
        throw RefusedInput(fmt::format("{}:{}: error: {}\n", shown_input(path), line, why));
    };
    std::vector<ColumnName> names;
    const std::string& text = file->text();
    for (std::size_t number = 1, at = 0; at < text.size(); ++number) {
        std::string_view line = file->line(number);
        at = std::min(text.find('\n', at), text.size() - 1) + 1;
        if (line.find_first_not_of(" \t\r") == line.npos || line.starts_with('#'))
            continue;
        try {
            names.push_back(column_name(line));
        } catch (const UserError& wrong) {
            refuse(number, wrong.what());
        }
    }
    return names;
}

ColumnName name_typed(const std::string& typed) try { return column_name(typed); } catch (const UserError& wrong) {
    throw UserError(fmt::format("--column {}", wrong.what()));
}

/// Throws UserError if two channels have the same column, or if a channel has two columns.
void require_different(const std::vector<ColumnName>& names) {
    for (const ColumnName& name : names) {
        if (std::ranges::count(names, name.in_file, &ColumnName::in_file) > 1)
            throw UserError(
                fmt::format("the column \"{}\" is given to two channels; expected one channel", name.in_file));
        if (std::ranges::count(names, name.channel, &ColumnName::channel) > 1)
            throw UserError(fmt::format("\"{}\": the channel already has a column; expected one column", name.in_file));
    }
}

std::vector<ColumnName> column_names(const IdentifySettings& settings) {
    std::vector<ColumnName> names =
        settings.columns_from.empty() ? std::vector<ColumnName>{} : names_in_file(settings.columns_from);
    std::vector<ColumnName> typed;
    for (const std::string& each : settings.columns)
        typed.push_back(name_typed(each));
    for (const ColumnName& each : typed) // a typed name replaces the file's name of the same channel
        std::erase_if(names, [&](const ColumnName& name) { return name.channel == each.channel; });
    names.insert(names.end(), typed.begin(), typed.end());
    require_different(names);
    return names;
}

} // namespace

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
    return {needed, settings.missing == "skip", column_names(settings)};
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
