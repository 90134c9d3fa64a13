#pragma once

#include "experiments/kit/experiment.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// Returns the replay as text: every comparison, the constants, and whether the experiment is within its tolerances.
std::string print_replay(const Replay&);
/// Returns the replay as JSON, with everything needed to repeat it. `command` is the command line as typed.
boost::json::object replay_json(const Replay&, std::string_view experiment, std::uint64_t seed,
                                const std::string& command);

} // namespace placedpar
