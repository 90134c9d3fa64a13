#pragma once

#include "hydraulics/plant/dig_job.hpp"
#include "hydraulics/plant/moving_excavator.hpp"

#include <string>

namespace placedpar {

/// Reads an excavator operator's moves of the joysticks, for the simulation of a digging machine, from a TOML file:
///
///     about = "a trench"
///     repeat = 3                                                          # how often the moves are made; 1 if not
///     given start = {reach = 300, height = -20, pitch = -60, swing = 0}         # in, in, deg, deg
///
///     [[move]]
///     seconds = 4
///     reach = -25                                                         # in/s; 0 if not given
///     pitch = -4                                                          # deg/s
///     soil = 1500                                                         # lbf
///
/// Throws RefusedInput, with lines, for a wrong key or value, for moves of more than ten minutes in total, and for a
/// move that leaves the arm's reach.
hydraulics::DigJob load_dig_job(const std::string& path, const hydraulics::MovingExcavator&);

} // namespace placedpar
