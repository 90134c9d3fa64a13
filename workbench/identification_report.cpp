#include "workbench/identification_report.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>

namespace placedpar {

using namespace hydraulics;
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

} // namespace

std::string print_identified(const Identified& identified, const ComplianceSearch& prepared,
                             const IdentificationWay& way) {
    std::string text =
        fmt::format("{} usable samples from {:.3f} to {:.3f} s; {} search{} of {} individuals, {} generations\n",
                    prepared.samples.size(), prepared.samples.front().time_s, prepared.samples.back().time_s,
                    way.searches, way.searches == 1 ? "" : "es", way.search.population, identified.generations);
    if (std::size_t frozen = frozen_samples(identified))
        text += fmt::format("frozen for want of excitation after {} of them\n", frozen);
    double offset = prepared.calibrations[index_of(hydraulics::Link::boom)].spool_offset_in;
    if (offset != 0)
        text += fmt::format("spool offset taken off the readings: {:+.5f} in\n", offset);
    text += "\nin^3/psi  median  searches: 5 %      95 %  std.error    optimum  codes off\n";
    for (const LinkIdentified& link : identified.links)
        text += print_link(link, way.searches);
    for (const LinkIdentified& link : identified.links)
        for (const std::string& flag : link.flags)
            text += fmt::format("! C_{}i: {}\n", symbol_of(link.link), flag);
    return text;
}

boost::json::object identified_json(const Identified& identified, const ComplianceSearch& prepared,
                                    const IdentificationWay& way) {
    boost::json::array links, estimates;
    for (const LinkIdentified& link : identified.links) {
        boost::json::object one{{"link", name_of(link.link)},
                                {"unit", "in^3/psi"},
                                {"compliance", link.compliance_in3_per_psi},
                                {"lowest", link.lowest},
                                {"highest", link.highest},
                                {"standard_error", nullptr},
                                {"optimum", nullptr},
                                {"codes_from_optimum", nullptr},
                                {"flags", boost::json::array(link.flags.begin(), link.flags.end())}};
        if (std::isfinite(link.standard_error))
            one["standard_error"] = link.standard_error;
        if (link.optimum) {
            one["optimum"] = *link.optimum;
            one["codes_from_optimum"] = *link.codes_from_optimum;
        }
        links.push_back(std::move(one));
    }
    for (const TransientEstimate& estimate : identified.estimates)
        estimates.push_back({{"sample", estimate.index},
                             {"time_s", estimate.time_s},
                             {"frozen", estimate.frozen},
                             {"error_in3_per_s", estimate.error_in3_per_s},
                             {"compliance", boost::json::array(estimate.compliance_in3_per_psi.begin(),
                                                               estimate.compliance_in3_per_psi.end())}});
    return {{"links", std::move(links)},
            {"spool_offset_in", prepared.calibrations[index_of(hydraulics::Link::boom)].spool_offset_in},
            {"searches", way.searches},
            {"generations", identified.generations},
            {"estimates", std::move(estimates)}};
}

} // namespace placedpar
