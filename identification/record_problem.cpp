#include "identification/record_problem.hpp"

#include "hydraulics/plant/converter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace placedpar {

using namespace hydraulics;

namespace {

std::string list(LinkSet links) {
    std::string names;
    for (hydraulics::Link link : all_links)
        if (links.contains(link))
            names += (names.empty() ? "" : ",") + std::string(name_of(link));
    return names;
}

void require_one_group(const Question& question) {
    for (LinkSet group : coupled_groups(question.configuration))
        if ((question.links & group) == question.links)
            return;
    throw std::invalid_argument(
        fmt::format("{} are not coupled with each other in configuration {}: identify them one by one",
                    list(question.links), name_of(question.configuration)));
}

} // namespace

LinkReadings link_readings(const Parameters& machine) {
    LinkReadings readings;
    for (hydraulics::Link link : all_links) {
        auto value = [&](std::string_view what) { return machine[fmt::format("{}.{}", name_of(link), what)]; };
        LinkReading& reading = readings[index_of(link)];
        reading.piston_flow_in3_per_deg = value("inlet_area") * value("moment_arm") * std::numbers::pi / 180;
        reading.spool_lag_per_s = value("spool_lag");
    }
    return readings;
}

double spool_sensor_step_in(const Parameters& machine) {
    return Converter{machine["sensors.spool_range"], bits_of(machine, "sensors.spool_bits")}.step();
}

RecordProblem prepare(const Record& record, const Parameters& machine, const Question& question,
                      const IdentificationWay& way) {
    require_one_group(question);
    Circuit circuit = circuit_of(question.configuration, question.links);
    FlowConstants flow = flow_constants(machine);
    LinkReadings readings = link_readings(machine);
    readings[index_of(hydraulics::Link::boom)].spool_offset_in = question.spool_offset_in.value_or(0);
    for (LinkReading& reading : readings)
        reading.from = question.areas_from;
    auto samples = usable_samples(circuit_samples(record, circuit, readings), circuit, flow, way.usable);
    return {CircuitProblem(circuit, flow, way.bits), flow, readings, std::move(samples)};
}

} // namespace placedpar
