#include "experiments/chapter_3/kit/pressure_check.hpp"

#include "hydraulics/circuit/replay_pressure.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "text/user_error.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

using namespace hydraulics;

namespace {

// In scenario A, the transient lasts from .18 to .66 s, and the first usable sample is at .20 s.
constexpr double before_s = 0.02, transient_s = 0.48;
constexpr double simulation_step_s = 0.001;

std::vector<ReplaySample> motion_of(const BoomData& data, const BoomModel& model,
                                    std::span<const CircuitSample> samples) {
    auto spool = spool_of(data, model);
    std::vector<ReplaySample> motion;
    for (const CircuitSample& sample : samples)
        motion.push_back(
            {sample.time_s, spool[sample.index], sample.links[0].piston_flow_in3_per_s / data.boom.inlet_area_in2});
    return motion;
}

void measure_transient(PressureCheck& check) {
    double squares = 0, lowest = 1e300, highest = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < check.time_s.size(); ++i) {
        if (check.time_s[i] < check.from_s - 1e-6 || check.time_s[i] > check.until_s + 1e-6)
            continue;
        double difference = check.simulated_psi[i] - check.measured_psi[i];
        squares += difference * difference;
        lowest = std::min(lowest, check.measured_psi[i]);
        highest = std::max(highest, check.measured_psi[i]);
        check.peak_psi = std::max(check.peak_psi, check.simulated_psi[i]);
        ++count;
    }
    check.rms_psi = std::sqrt(squares / static_cast<double>(count));
    check.rise_psi = highest - lowest;
}

} // namespace

PressureCheck check_pressure(const BoomData& data, const BoomModel& model, double compliance_in3_per_psi) {
    auto samples = samples_of(data, model);
    auto opened = usable_samples(samples, boom_circuit(), data.flow);
    if (opened.empty())
        throw UserError("the record has no transient in which the inlet opens");
    PressureCheck check{};
    for (const CircuitSample& sample : samples) {
        check.time_s.push_back(sample.time_s);
        check.measured_psi.push_back(sample.links[0].inlet_psi);
    }
    check.from_s = opened.front().time_s - before_s;
    check.until_s = check.from_s + transient_s;
    check.simulated_psi =
        replay_pressure(motion_of(data, model, samples), {data.flow, data.boom.inlet_area_in2, compliance_in3_per_psi},
                        check.measured_psi.front(), simulation_step_s);
    measure_transient(check);
    return check;
}

} // namespace placedpar
