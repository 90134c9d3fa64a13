#include "workbench/identification_report.hpp"

#include "hydraulics/data/units.hpp"
#include "text/counted.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace placedpar {

using namespace identification;

namespace {

std::string print_link(const LinkIdentified& link) {
    static const double m3_per_pascal = hydraulics::unit_named("m^3/Pa")->factor; // in in^3/psi
    std::string name = fmt::format("C_{}i", symbol_of(link.link));
    std::string optimum = link.optimum ? fmt::format("{:9.5f} {:9.0f}", *link.optimum, *link.codes_from_optimum)
                                       : fmt::format("{:>9} {:>9}", "-", "-");
    return fmt::format("{:<7} {:9.5f}  {:9.5f}  {:9.3e}  {:9.1e}  {}\n", name, link.compliance_in3_per_psi,
                       link.standard_error, link.compliance_in3_per_psi / m3_per_pascal,
                       link.standard_error / m3_per_pascal, optimum);
}

std::size_t frozen_samples(const Identified& identified) {
    std::size_t frozen = 0;
    for (const TransientEstimate& estimate : identified.estimates)
        frozen += estimate.frozen;
    return frozen;
}

std::string print_flags(const LinkIdentified& link) {
    std::string text;
    for (const Flag& flag : link.flags)
        text += fmt::format("! C_{}i: {}\n", symbol_of(link.link), flag.text);
    return text;
}

boost::json::array flags_json(const LinkIdentified& link) {
    boost::json::array flags;
    for (const Flag& flag : link.flags)
        flags.push_back({{"kind", name_of(flag.kind)}, {"text", flag.text}});
    return flags;
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
            {"flags", flags_json(link)}};
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
    text += "\n         in^3/psi  std.error     m^3/Pa  std.error    optimum  codes off\n";
    for (const LinkIdentified& link : identified.links)
        text += print_link(link);
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
