#pragma once

#include "identification/on_line/record_diagnosis.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

/// Returns the heading for the lines of print_movement().
std::string movements_heading();
/// Returns text for people about one movement: its times, a line for each link, then the flags, the reasons why a
/// compliance may be wrong.
std::string print_movement(const identification::MovementFinding& movement);
/// Returns text for people: the verdict on each active link that has no fault, then the active alarms.
std::string print_verdicts(const identification::Diagnosis& diagnosis);

/// These two functions return the same content as JSON.
boost::json::object movement_json(const identification::MovementFinding& movement);
boost::json::object verdicts_json(const identification::Diagnosis& diagnosis);

} // namespace placedpar
