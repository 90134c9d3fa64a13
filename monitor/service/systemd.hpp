#pragma once

#include <string>
#include <string_view>

namespace placedpar::monitor {

/// Reports a state ("READY=1", "STOPPING=1", "WATCHDOG=1") to systemd as sd_notify(3) does. Does nothing if systemd did
/// not start the service, that is, if NOTIFY_SOCKET is not in the environment. Returns a message about what went wrong,
/// or "".
std::string tell_systemd(std::string_view state);

} // namespace placedpar::monitor
