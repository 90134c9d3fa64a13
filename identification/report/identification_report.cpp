#include "identification/report/identification_report.hpp"

#include "identification/report/compliance_text.hpp"
#include "text/counted.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace placedpar {

using namespace identification;

namespace {

std::string print_link(const LinkIdentified& link, const hydraulics::Junction& junction) {
    std::string optimum = link.optimum ? fmt::format("{:9.5f} {:9.0f}", *link.optimum, *link.codes_from_optimum)
                                       : fmt::format("{:>9} {:>9}", "-", "-");
    return fmt::format("{}  {}\n",
                       print_compliance(compliance_name(junction), link.compliance_in3_per_psi, link.standard_error),
                       optimum);
}

std::string print_search(const Identified& identified, const ComplianceSearch& prepared, const IdentificationWay& way) {
    return fmt::format("{} from {:.3f} to {:.3f} s; 1 search with {}, {}\n",
                       counted(prepared.samples.size(), "usable sample"), prepared.samples.front().time_s,
                       prepared.samples.back().time_s, counted(way.search.population, "individual"),
                       counted(identified.generations, "generation"));
}

double spool_offset_in(const ComplianceSearch& prepared) {
    return prepared.calibrations[index_of(hydraulics::Link::boom)].spool_offset_in;
}

boost::json::object link_json(const LinkIdentified& link) {
    boost::json::object json{{"link", name_of(link.link)},
                             {"unit", "in^3/psi"},
                             {"compliance", link.compliance_in3_per_psi},
                             {"standard_error", or_null(link.standard_error)},
                             {"optimum", or_null(link.optimum)},
                             {"codes_from_optimum", or_null(link.codes_from_optimum)},
                             {"flags", flags_json(link.flags)}};
    if (link.of_all_samples)
        json["least_squares"] = {{"compliance", or_null(link.of_all_samples->compliance_in3_per_psi)},
                                 {"standard_error", or_null(link.of_all_samples->standard_error)}};
    return json;
}

boost::json::object estimate_json(const TransientEstimate& estimate) {
    return {{"sample", estimate.index},
            {"time_s", estimate.time_s},
            {"error_in3_per_s", estimate.error_in3_per_s},
            {"compliance",
             boost::json::array(estimate.compliance_in3_per_psi.begin(), estimate.compliance_in3_per_psi.end())}};
}

} // namespace

std::string print_identified(const Identified& identified, const ComplianceSearch& prepared,
                             const IdentificationWay& way) {
    std::string text = print_search(identified, prepared, way);
    if (double offset = spool_offset_in(prepared); offset != 0)
        text += fmt::format("spool offset subtracted from the readings: {:+.5f} in\n", offset);
    text += fmt::format("\n{}    optimum  codes off\n", compliance_heading());
    for (std::size_t j = 0; j < identified.links.size(); ++j)
        text += print_link(identified.links[j], identified.circuit[j]);
    for (std::size_t j = 0; j < identified.links.size(); ++j)
        text += print_flags(compliance_name(identified.circuit[j]), identified.links[j].flags);
    return text;
}

boost::json::object identified_json(const Identified& identified, const ComplianceSearch& prepared) {
    boost::json::array links, estimates;
    for (std::size_t j = 0; j < identified.links.size(); ++j) {
        links.push_back(link_json(identified.links[j]));
        links.back().as_object()["name"] = compliance_name(identified.circuit[j]);
    }
    for (const TransientEstimate& estimate : identified.estimates)
        estimates.push_back(estimate_json(estimate));
    return {{"links", std::move(links)},
            {"spool_offset_in", spool_offset_in(prepared)},
            {"generations", identified.generations},
            {"estimates", std::move(estimates)}};
}

} // namespace placedpar
