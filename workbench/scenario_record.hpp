#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/record_scenario.hpp"

#include <cstdint>

namespace placedpar {

/// The record, whose description says how to make it again: the command, with every parameter that is not the
/// program's own, and the true compliance. Throws UserError, naming the first instant and channel, where
/// parameters far from any machine's make a record that no sensor could have read.
hydraulics::Record scenario_record(const hydraulics::RecordScenario& scenario, const hydraulics::LinksInMotion& moving,
                                   const hydraulics::Parameters& parameters, std::uint64_t seed);

} // namespace placedpar
