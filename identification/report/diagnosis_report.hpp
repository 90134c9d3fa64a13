#pragma once

#include "identification/on_line/record_diagnosis.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

/// Returns the heading of the movements.
std::string movements_heading();
/// Returns text for people: the time, a line for each link, then the flags.
std::string print_movement(const identification::MovementFinding& movement);
/// Returns text for people: the verdict on each active link after all movements.
std::string print_verdicts(const identification::Diagnosis& diagnosis);

/// These two functions return the same content as JSON.
boost::json::object movement_json(const identification::MovementFinding& movement);
boost::json::object verdicts_json(const identification::Diagnosis& diagnosis);

} // namespace placedpar
