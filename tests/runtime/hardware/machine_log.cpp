#include "machine_log.hpp"

#include "runtime/channel.hpp"

#include <fmt/format.h>

namespace placedpar::test {

void MachineLog::communicated(const AnyChannel& channel, Time now) {
    note(now, "trace: communicated on " + channel.name(), 0);
}

void MachineLog::carries(const std::string& direction, const AnyChannel&, Time now, Time since) {
    note(now, "trace: carries on " + direction, since.count());
}

void MachineLog::carried(const std::string& direction, std::uint64_t bytes, Time now, Time until) {
    note(now, fmt::format("trace: carried {} bytes on {}", bytes, direction), until.count());
}

} // namespace placedpar::test
