#pragma once

#include "runtime/time.hpp"
#include "runtime/trace.hpp"

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace placedpar::test {

/// When everything happened in a random machine, what its links and processors said of themselves, and what a trace was
/// told of messages and links.
class MachineLog final : public TraceSink {
public:
    using Entry = std::tuple<std::int64_t, std::string, std::int64_t>; ///< picoseconds, what, of what value
    const std::vector<Entry>& entries() const { return entries_; }
    void note(Time now, std::string what, std::int64_t value) {
        entries_.emplace_back(now.count(), std::move(what), value);
    }

    void communicated(const AnyChannel&, Time now) override;
    void carries(const std::string& direction, const AnyChannel&, Time now, Time since) override;
    void carried(const std::string& direction, std::uint64_t bytes, Time now, Time until) override;
    void over(Time now) override { note(now, "trace: over", 0); }
    void began(const Process&, Time) override {}
    void waits(const Process&, Time) override {}
    void goes_on(const Process&, Time) override {}
    void computes(const Process&, Time) override {}
    void stops_computing(const Process&, Time) override {}
    void ended(const Process&, Time) override {}
    void occupied(const std::string&, const std::string&, Time) override {}
    void vacated(const std::string&, Time) override {}

private:
    std::vector<Entry> entries_;
};

} // namespace placedpar::test
