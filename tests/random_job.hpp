#pragma once

#include "hydraulics/plant/dig_job.hpp"
#include "hydraulics/plant/moving_machine.hpp"
#include "runtime/random.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace placedpar::hydraulics {

/// Returns a job of random moves that the arm reaches, and of random soil.
inline DigJob random_job(std::uint64_t seed, const MovingExcavator& machine, double seconds) {
    constexpr double rad = std::numbers::pi / 180;
    RandomStream random(seed, "job");
    auto between = [&](double least, double most) { return least + (most - least) * random.uniform(); };
    auto perhaps = [&](double chance, double most) {
        const double value = between(-most, most);
        return random.uniform() < chance ? value : 0;
    };
    auto feasible = [&](const DigJob& job) {
        if (unreachable_move(job, machine.arm, machine.joystick_lag_s, machine.control_period_s))
            return false;
        TipReference reference(job, machine.joystick_lag_s);
        for (double t = 0; t < job.duration_s(); t += machine.control_period_s)
            reference.advance(machine.control_period_s);
        return reference.pose().reach_in > 150 && std::abs(reference.pose().pitch_rad) < 2.2 &&
               std::abs(reference.pose().swing_rad) < 2;
    };
    DigJob job{"random", "", {between(240, 290), between(-50, 0), between(-75, -45) * rad, 0}, {{1, {}, 0}}};
    for (int i = 0; i < 400 && job.duration_s() < seconds; ++i) {
        JoystickMove move{std::round(between(0.6, 4) * 50) / 50, {}, 0};
        move.velocity = {perhaps(0.7, 30), perhaps(0.7, 25), perhaps(0.6, 45) * rad, perhaps(0.5, 50) * rad};
        move.soil_lbf = random.uniform() < 0.4 ? between(200, 2500) : 0;
        job.moves.push_back(move);
        if (!feasible(job))
            job.moves.pop_back();
    }
    return job;
}

} // namespace placedpar::hydraulics
