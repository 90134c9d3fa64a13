#include "explore/identify/ways.hpp"

#include "explore/identify/identifying.hpp"
#include "explore/identify/question.hpp"
#include "identification/on_line/moving_identification.hpp"
#include "identification/on_line/population_sets.hpp"
#include "identification/report/compliance_text.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

std::string print_recognition(const Recognition& found) {
    std::string text;
    for (Configuration each : all_configurations)
        if (std::size_t samples = found.samples[static_cast<std::size_t>(each)])
            text += fmt::format("{}{} in {}", text.empty() ? "configuration recognised: " : ", ", name_of(each),
                                counted(samples, "sample"));
    if (found.judged > 0)
        text +=
            fmt::format("\nagrees with the record's column in {:.2f} % of {}; {} of {} recognised within two samples",
                        100 * static_cast<double>(found.right) / static_cast<double>(found.judged),
                        counted(found.judged, "sample"), found.soon, counted(found.changes, "change"));
    return text + "\n";
}

std::string print_compliance_of(const LinkIdentified& link) {
    return print_compliance(compliance_name({link.link, 0, Through::tank}), link.compliance_in3_per_psi,
                            link.standard_error);
}

std::string print_flags_of(const LinkIdentified& link, std::string_view where) {
    return print_flags(fmt::format("{}{}", compliance_name({link.link, 0, Through::tank}), where), link.flags);
}

std::string print_sets(const std::vector<SetAnswer>& sets) {
    std::string text = fmt::format("\nset  config.  samples  {}\n", compliance_heading()), flags;
    for (const SetAnswer& answer : sets)
        for (const LinkIdentified& link : answer.links) {
            text += &link == &answer.links.front() ? fmt::format("{:<4} {:<7} {:8}  ", name_of_set(answer.set),
                                                                 answer.configurations, answer.samples)
                                                   : std::string(23, ' ');
            text += print_compliance_of(link) + "\n";
            flags += print_flags_of(link, fmt::format(" in {}", name_of_set(answer.set)));
        }
    return text + flags;
}

std::string print_links(const std::vector<LinkIdentified>& links, LinkSet wanted) {
    std::string text = "\nall sets combined:\n" + compliance_heading() + "\n", flags;
    for (Link link : all_links) {
        const auto found = std::ranges::find(links, link, &LinkIdentified::link);
        if (!wanted.contains(link))
            continue;
        if (found == links.end()) {
            text += fmt::format("! {}: no answer: the link moves too little, or all its sets are doubtful\n",
                                name_of(link));
            continue;
        }
        text += print_compliance_of(*found) + "\n";
        flags += print_flags_of(*found, "");
    }
    return text + flags;
}

boost::json::object link_json(const LinkIdentified& link) {
    return {{"link", name_of(link.link)},
            {"unit", "in^3/psi"},
            {"compliance", link.compliance_in3_per_psi},
            {"standard_error", or_null(link.standard_error)},
            {"flags", flags_json(link.flags)}};
}

boost::json::array links_json(const std::vector<LinkIdentified>& links) {
    boost::json::array all;
    for (const LinkIdentified& link : links)
        all.push_back(link_json(link));
    return all;
}

void add_json(const std::vector<SetAnswer>& sets, const std::vector<LinkIdentified>& links, const Recognition& found,
              boost::json::object& json) {
    boost::json::array all;
    for (const SetAnswer& answer : sets)
        all.push_back({{"set", name_of_set(answer.set)},
                       {"configurations", answer.configurations},
                       {"samples", answer.samples},
                       {"generations", answer.generations},
                       {"links", links_json(answer.links)}});
    json["sets"] = std::move(all);
    json["links"] = links_json(links);
    json["configuration"] = {{"judged", found.judged},
                             {"right", found.right},
                             {"changes", found.changes},
                             {"within_two_samples", found.soon}};
}

} // namespace

WholeWay moving_way(const IdentifySettings& settings, std::size_t links) {
    WholeWay whole = whole_way(links);
    change_way(whole.way, settings); // there is no window to be changed: see require_no_fixed_settings()
    whole.way.search.validate();
    return whole;
}

void require_no_fixed_settings(const IdentifySettings& settings) {
    if (settings.window || !settings.areas.empty() || !settings.offset.empty())
        throw UserError("--window, --areas-from and --offset need --configuration: without it, the valve's areas "
                        "are used as read, and a search uses all samples in which its links move together");
}

LinkSet links_that_move(const IdentifySettings& settings) {
    return settings.links.empty() ? LinkSet::all() : links_of(settings.links);
}

IdentifyEnd identify_moving(const IdentifySettings& settings, Record first, RecordStream& pieces,
                            const IdentifyOutput& output) {
    require_no_fixed_settings(settings);
    PerLink<double> healthy;
    const LinkSet wanted = links_that_move(settings);
    MovingIdentification moving(
        load_machine(settings.machine, output.warn),
        [&settings](std::size_t links) { return moving_way(settings, links); }, settings.seed);
    for (std::optional<Record> piece = std::move(first); piece; piece = pieces.next())
        moving.take(*piece);
    for (Link link : all_links)
        healthy[index_of(link)] = moving.healthy_in3_per_psi(link);
    const std::vector<SetAnswer> sets = moving.sets();
    if (sets.empty())
        throw UnfitRecord(
            fmt::format("no link moves forward for long enough; a search needs at least {}, each of 0.16 s; if one "
                        "configuration of the main valve holds for the whole record, name it by --configuration",
                        counted(SetSearch::fewest_samples, "sample")));
    const std::vector<LinkIdentified> links = combined_links(sets);
    output.print(print_recognition(moving.recognition()) + print_sets(sets) + print_links(links, wanted) +
                 "\ncross-check 2: " + locate_faults(links, healthy));
    output.json["warnings"] = warnings_json(pieces.warnings());
    add_json(sets, links, moving.recognition(), output.json);
    if (pieces.stopped())
        return IdentifyEnd::interrupted;
    const bool doubted = std::ranges::any_of(all_links, [&](Link link) {
        const auto found = std::ranges::find(links, link, &LinkIdentified::link);
        return wanted.contains(link) && (found == links.end() || !found->flags.empty());
    });
    return doubted ? IdentifyEnd::doubtful : IdentifyEnd::sound;
}

} // namespace placedpar
