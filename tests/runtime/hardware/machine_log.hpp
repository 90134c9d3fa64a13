#pragma once

#include "runtime/time.hpp"
#include "runtime/trace.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace placedpar::test {

/// Logs the times of all events in a random machine: statistics of its links and processors, and trace events of
/// messages and links.
class MachineLog final : public TraceSink {
public:
    using Entry = std::tuple<std::int64_t, std::string, std::int64_t>; ///< picoseconds, event, value
    const std::vector<Entry>& entries() const { return entries_; }
    void note(Time now, std::string what, std::int64_t value) {
        entries_.emplace_back(now.count(), std::move(what), value);
    }

    void communicated(const AnyChannel&, Time now) override;
    void takes(const PlaceTaken&, Time now) override;
    void leaves(const PlaceLeft&, Time now) override;
    void over(Time now) override { note(now, "trace: over", 0); }
    void turns(const Process&, Activity, Time) override {}

private:
    std::vector<Entry> entries_;
    std::set<std::string> links_; ///< directions that have carried a byte
};

} // namespace placedpar::test
