#pragma once

#include "app/exit_code.hpp"
#include "app/monitor/service.hpp"

namespace CLI {
class App;
}

namespace placedpar {

/// Declares the options of `placedpar monitor`.
void add_monitor_options(CLI::App& command, ServiceSettings& settings);

/// Serves until SIGINT or SIGTERM. Prints where it listens, and on standard error what the operator should know.
ExitCode monitor(const ServiceSettings& settings);

} // namespace placedpar
