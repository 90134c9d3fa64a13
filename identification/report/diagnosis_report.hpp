#pragma once

#include "identification/on_line/record_diagnosis.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

/// What stands above the movements.
std::string movements_heading();
/// For people: when it was, a line for each link, then what is flagged.
std::string print_movement(const identification::MovementFinding& movement);
/// For people: what is said of each active link after all movements.
std::string print_verdicts(const identification::Diagnosis& diagnosis);

/// For machines: the same.
boost::json::object movement_json(const identification::MovementFinding& movement);
boost::json::object verdicts_json(const identification::Diagnosis& diagnosis);

} // namespace placedpar
