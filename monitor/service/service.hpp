#pragma once

#include "identification/on_line/settings.hpp"
#include "monitor/service/dispatcher.hpp"
#include "monitor/service/limits.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace placedpar::monitor {

struct ServiceSettings {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0; // 0: any free
    std::string state;      // a file; empty: nothing is kept
    std::uint64_t seed = 1;
    double sync_s = 1; // from an append to the journal to its being on the disk
    ServiceLimits limits;
    DiagnosisSettings diagnosis;
};

/// The on-line diagnosis as a service over TCP. One thread does everything but waiting for the disk.
class Service {
public:
    /// Restores the state and listens. `say` is given sentences for the operator. Throws std::runtime_error or
    /// std::invalid_argument, saying what is wrong.
    Service(const ServiceSettings& settings, std::function<void(const std::string&)> say);
    ~Service();

    std::uint16_t port() const;
    /// From now on SIGINT and SIGTERM do not end the program, but stop().
    void stop_at_signals();
    /// Until stop(), which may have come before: then the clients are told, and the state is written. Throws
    /// std::runtime_error when that fails.
    void run();
    /// From any thread.
    void stop();

private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

} // namespace placedpar::monitor
