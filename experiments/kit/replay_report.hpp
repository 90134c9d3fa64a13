#pragma once

#include "experiments/kit/experiment.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// For people: every comparison, what the constants are, and whether the experiment is within its tolerances.
std::string print_replay(const Replay&);
/// The same for machines, with what is needed to run it again. `command`: as it was typed.
boost::json::object replay_json(const Replay&, std::string_view experiment, std::uint64_t seed,
                                const std::string& command);

} // namespace placedpar
