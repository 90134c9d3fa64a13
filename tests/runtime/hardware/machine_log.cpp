#include "machine_log.hpp"

#include "runtime/channel.hpp"

#include <fmt/format.h>

namespace placedpar::test {

void MachineLog::communicated(const AnyChannel& channel, Time now) {
    note(now, "trace: communicated on " + channel.name(), 0);
}

void MachineLog::takes(const PlaceTaken& taken, Time now) {
    if (!taken.channel)
        return;
    links_.insert(taken.place);
    note(now, "trace: carries on " + taken.place, taken.since.count());
}

void MachineLog::leaves(const PlaceLeft& left, Time now) {
    if (links_.contains(left.place))
        note(now, fmt::format("trace: carried {} bytes on {}", left.bytes, left.place), left.until.count());
}

} // namespace placedpar::test
