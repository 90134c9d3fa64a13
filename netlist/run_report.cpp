#include "netlist/run_report.hpp"

#include "netlist/network/network.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace placedpar {

namespace {

void mix_text(Fingerprint& fingerprint, std::string_view text) {
    for (char c : text)
        fingerprint.mix(static_cast<unsigned char>(c));
}

void mix_measurement(Fingerprint& fingerprint, const Measurement& measurement) {
    mix_text(fingerprint, measurement.process);
    mix_text(fingerprint, measurement.name);
    if (const auto* number = std::get_if<double>(&measurement.value))
        fingerprint.mix(std::bit_cast<std::uint64_t>(*number));
    else
        mix_text(fingerprint, std::get<std::string>(measurement.value));
}

const Measurement& find_measurement(const RunReport& report, std::string_view process, std::string_view name) {
    auto found = std::ranges::find_if(report.measurements,
                                      [&](const Measurement& m) { return m.process == process && m.name == name; });
    if (found == report.measurements.end())
        throw UserError(fmt::format("process {} measured no {}", process, name));
    return *found;
}

} // namespace

std::uint64_t fingerprint_with(std::uint64_t events, const std::vector<Measurement>& measurements) {
    Fingerprint fingerprint;
    fingerprint.mix(events);
    for (const Measurement& measurement : measurements)
        mix_measurement(fingerprint, measurement);
    return fingerprint.value();
}

std::vector<Measurement> in_order_of_netlist(std::vector<Measurement> measurements, const Network& network) {
    std::unordered_map<std::string_view, std::size_t> places;
    for (const ProcessInstance& process : network.processes)
        places.emplace(process.name, places.size());
    std::ranges::stable_sort(measurements, {}, [&](const Measurement& each) { return places.at(each.process); });
    return measurements;
}

RunOutcome RunReport::outcome() const {
    if (result.ending == Ending::interrupted)
        return RunOutcome::interrupted;
    if (std::ranges::any_of(programs, &ProgramUse::halted))
        return RunOutcome::halted;
    if (result.ending == Ending::stuck)
        return RunOutcome::deadlock;
    if (std::ranges::any_of(programs, &ProgramUse::failed))
        return RunOutcome::failed;
    return result.ending == Ending::time_limit ? RunOutcome::time_limit : RunOutcome::completed;
}

std::optional<double> RunReport::share(Time part) const {
    if (result.ending == Ending::stuck)
        return std::nullopt;
    if (result.time == Time{0})
        return 0;
    return static_cast<double>(part.count()) / static_cast<double>(result.time.count());
}

double RunReport::measured(std::string_view process, std::string_view name) const {
    return std::get<double>(find_measurement(*this, process, name).value);
}

const std::string& RunReport::measured_text(std::string_view process, std::string_view name) const {
    return std::get<std::string>(find_measurement(*this, process, name).value);
}

} // namespace placedpar
