#include "workbench/identification_report.hpp"

#include "text/counted.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace placedpar {

using namespace identification;

namespace {

/// One search has no spread of its own.
std::string print_spread(const LinkIdentified& link, std::size_t searches) {
    return searches > 1 ? fmt::format("{:9.5f} {:9.5f}", link.lowest, link.highest)
                        : fmt::format("{:>9} {:>9}", "-", "-");
}

std::string print_link(const LinkIdentified& link, std::size_t searches) {
    std::string name = fmt::format("C_{}i", symbol_of(link.link));
    std::string optimum = link.optimum ? fmt::format("{:9.5f} {:9.0f}", *link.optimum, *link.codes_from_optimum)
                                       : fmt::format("{:>9} {:>9}", "-", "-");
    return fmt::format("{:<7} {:9.5f}  {} {:9.5f}  {}\n", name, link.compliance_in3_per_psi,
                       print_spread(link, searches), link.standard_error, optimum);
}

std::size_t frozen_samples(const Identified& identified) {
    std::size_t frozen = 0;
    for (const TransientEstimate& estimate : identified.estimates)
        frozen += estimate.frozen;
    return frozen;
}

std::string print_flags(const LinkIdentified& link) {
    std::string text;
    for (const std::string& flag : link.flags)
        text += fmt::format("! C_{}i: {}\n", symbol_of(link.link), flag);
    return text;
}

std::string print_search(const Identified& identified, const ComplianceSearch& prepared, const IdentificationWay& way) {
    return fmt::format("{} from {:.3f} to {:.3f} s; {} of {}, {}\n", counted(prepared.samples.size(), "usable sample"),
                       prepared.samples.front().time_s, prepared.samples.back().time_s,
                       counted(way.searches, "search", "searches"), counted(way.search.population, "individual"),
                       counted(identified.generations, "generation"));
}

double spool_offset_in(const ComplianceSearch& prepared) {
    return prepared.calibrations[index_of(hydraulics::Link::boom)].spool_offset_in;
}

/// Null where there is none, or it is not finite.
boost::json::value or_null(std::optional<double> number) {
    return number && std::isfinite(*number) ? boost::json::value(*number) : nullptr;
}

boost::json::object link_json(const LinkIdentified& link) {
    return {{"link", name_of(link.link)},
            {"unit", "in^3/psi"},
            {"compliance", link.compliance_in3_per_psi},
            {"lowest", link.lowest},
            {"highest", link.highest},
            {"standard_error", or_null(link.standard_error)},
            {"optimum", or_null(link.optimum)},
            {"codes_from_optimum", or_null(link.codes_from_optimum)},
            {"flags", boost::json::array(link.flags.begin(), link.flags.end())}};
}

boost::json::object estimate_json(const TransientEstimate& estimate) {
    return {{"sample", estimate.index},
            {"time_s", estimate.time_s},
            {"frozen", estimate.frozen},
            {"error_in3_per_s", estimate.error_in3_per_s},
            {"compliance",
             boost::json::array(estimate.compliance_in3_per_psi.begin(), estimate.compliance_in3_per_psi.end())}};
}

} // namespace

std::string print_identified(const Identified& identified, const ComplianceSearch& prepared,
                             const IdentificationWay& way) {
    std::string text = print_search(identified, prepared, way);
    if (std::size_t frozen = frozen_samples(identified))
        text += fmt::format("frozen for want of excitation after {} of them\n", frozen);
    if (double offset = spool_offset_in(prepared); offset != 0)
        text += fmt::format("spool offset taken off the readings: {:+.5f} in\n", offset);
    text += "\nin^3/psi  median  searches: 5 %      95 %  std.error    optimum  codes off\n";
    for (const LinkIdentified& link : identified.links)
        text += print_link(link, way.searches);
    for (const LinkIdentified& link : identified.links)
        text += print_flags(link);
    return text;
}

boost::json::object identified_json(const Identified& identified, const ComplianceSearch& prepared,
                                    const IdentificationWay& way) {
    boost::json::array links, estimates;
    for (const LinkIdentified& link : identified.links)
        links.push_back(link_json(link));
    for (const TransientEstimate& estimate : identified.estimates)
        estimates.push_back(estimate_json(estimate));
    return {{"links", std::move(links)},
            {"spool_offset_in", spool_offset_in(prepared)},
            {"searches", way.searches},
            {"generations", identified.generations},
            {"estimates", std::move(estimates)}};
}

} // namespace placedpar
