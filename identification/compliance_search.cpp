#include "identification/compliance_search.hpp"

#include "hydraulics/plant/converter.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

std::string list(LinkSet links) {
    std::string names;
    for (Link link : all_links)
        if (links.contains(link))
            names += (names.empty() ? "" : ",") + std::string(name_of(link));
    return names;
}

void require_one_group(const Question& question) {
    for (LinkSet group : coupled_groups(question.configuration))
        if ((question.links & group) == question.links)
            return;
    throw UserError(fmt::format("{} are not hydraulically coupled in configuration {}: identify each link "
                                "separately",
                                list(question.links), name_of(question.configuration)));
}

void require_described(const Question& question) {
    if (question.side == Side::outlet && question.links != LinkSet{Link::boom})
        throw UserError(fmt::format("--side outlet does not work for {}: the machine's constants describe only the "
                                    "outlet side of the boom (boom.outlet_area, A.7 to A.9)",
                                    list(question.links)));
    if (question.side == Side::outlet && question.areas_from == AreasFrom::areas)
        throw UserError("--side outlet: no sensor reads the area of an outlet; compute it from the spool or the "
                        "servo-valve, with --areas-from spool or --areas-from servo");
}

} // namespace

double spool_sensor_step_in(const Parameters& machine) {
    return Converter{machine["sensors.spool_range"], bits_of(machine, "sensors.spool_bits")}.step();
}

ComplianceSearch prepare(const Record& record, const Parameters& machine, const Question& question,
                         const IdentificationWay& way) {
    require_one_group(question);
    require_described(question);
    const bool drain = question.side == Side::outlet;
    Circuit circuit = drain ? drain_circuit(Link::boom) : circuit_of(question.configuration, question.links);
    FlowConstants flow = flow_constants(machine);
    LinkCalibrations calibrations = drain ? drain_calibrations(machine) : link_calibrations(machine);
    calibrations[index_of(Link::boom)].spool_offset_in = question.spool_offset_in.value_or(0);
    for (LinkCalibration& calibration : calibrations)
        calibration.from = question.areas_from;
    auto samples = usable_samples(circuit_samples(record, circuit, calibrations), circuit, flow, way.usable);
    const InletFlow form = drain ? InletFlow::as_signed : printed_inlet_flow(circuit.size());
    return {CircuitProblem(circuit, flow, way.bits, form), flow, calibrations, std::move(samples)};
}

} // namespace placedpar::identification
