#pragma once

#include "experiments/kit/experiment.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// Returns the result of an experiment as text: every table, the constants, and whether the figures are within their
/// tolerances.
std::string print_replay(const Replay&);
/// Returns the result of an experiment as JSON, with everything needed to repeat the experiment. `command` is the
/// command line as typed.
boost::json::object replay_json(const Replay&, std::string_view experiment, std::uint64_t seed,
                                const std::string& command);

} // namespace placedpar
