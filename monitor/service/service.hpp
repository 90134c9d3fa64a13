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
    std::uint16_t port = 0; ///< 0: any free
    std::string state;      ///< a file; empty: nothing is kept
    std::uint64_t seed = 1;
    double sync_s = 1; ///< from an append to the journal to its being on the disk
    ServiceLimits limits;
    identification::DiagnosisSettings diagnosis;
};

/// The on-line diagnosis as a service over TCP. One thread does everything; a second one only waits for the disk.
class Service {
public:
    /// Restores the state and listens. `say` gets sentences for the operator. Throws UserError when
    /// address, port or state file cannot be used, saying what is wrong.
    Service(const ServiceSettings& settings, std::function<void(const std::string&)> say);
    ~Service();

    std::uint16_t port() const;
    /// From now on SIGINT and SIGTERM call stop() instead of ending the program.
    void stop_at_signals();
    /// Serves until stop(), which may have been called before; then tells the clients and writes the state. Throws
    /// as StateStore::write().
    void run();
    /// From any thread.
    void stop();

private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

} // namespace placedpar::monitor
