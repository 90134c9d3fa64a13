#include "hydraulics/plant/link_valve.hpp"

#include <cmath>

namespace placedpar::hydraulics {

OrificeAreas areas_at(const TimedOrifices& valve, double time_s) {
    if (time_s < valve.step_time_s)
        return {0, valve.bypass_rest_in2, 0};
    double gone = std::exp(-valve.rate_per_s * (time_s - valve.step_time_s));
    return {valve.inlet_final_in2 * (1 - gone),
            (valve.bypass_rest_in2 - valve.bypass_final_in2) * gone + valve.bypass_final_in2,
            valve.outlet_final_in2 * (1 - gone)};
}

double desired_in(const SpoolOrifices& valve, double time_s) {
    double desired = valve.rest_in;
    for (const SpoolStep& step : valve.steps)
        if (time_s >= step.time_s + step.ramp_s)
            desired = step.desired_in;
        else if (time_s >= step.time_s)
            desired = std::lerp(desired, step.desired_in, (time_s - step.time_s) / step.ramp_s);
    return desired;
}

std::size_t begun_and_ended(const LinkValve& valve, double time_s) {
    if (const auto* timed = std::get_if<TimedOrifices>(&valve))
        return time_s >= timed->step_time_s ? 1 : 0;
    std::size_t count = 0;
    for (const SpoolStep& step : std::get<SpoolOrifices>(valve).steps)
        count += (time_s >= step.time_s) + (time_s >= step.time_s + step.ramp_s);
    return count;
}

} // namespace placedpar::hydraulics
