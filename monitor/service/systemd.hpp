#pragma once

#include <string>
#include <string_view>

namespace placedpar::monitor {

/// Tells systemd how the service is ("READY=1", "STOPPING=1", "WATCHDOG=1"), as sd_notify(3) does, if it is systemd
/// that has started it: if the environment has NOTIFY_SOCKET. Gives what went wrong in a sentence; "" when nothing did.
std::string tell_systemd(std::string_view state);

} // namespace placedpar::monitor
