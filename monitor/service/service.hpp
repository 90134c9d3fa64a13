#pragma once

#include "identification/on_line/settings.hpp"
#include "monitor/service/limits.hpp"
#include "monitor/service/log.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::identification {
struct AnswerInTime;     // identification/transient_search.hpp
struct ComplianceSearch; // identification/compliance_search.hpp
} // namespace placedpar::identification

namespace placedpar::monitor {

struct ServiceSettings {
    std::string address = "127.0.0.1";
    std::optional<std::uint16_t> port = 0;  ///< 0: any free port; nullopt: no TCP port
    std::string unix_path;                  ///< a socket in the file system; empty: none
    std::optional<std::uint16_t> http_port; ///< port of the web page; 0: any free port; nullopt: no page
    std::vector<std::string> host_names;    ///< host names that browsers may use, besides the names of `address`
    std::string token_file;                 ///< empty: no token is required
    std::string state;                      ///< path of the state file; empty: nothing is stored
    std::uint64_t seed = 1;
    ServiceLimits limits;
    identification::DiagnosisSettings diagnosis;
    /// Runs simulated transputers, described by a netlist, that find the compliances of a movement. If this function is
    /// empty, the service runs no netlist.
    std::function<identification::AnswerInTime(identification::ComplianceSearch, double period_s)> netlist;
};

/// The on-line diagnosis of excavators as a service over TCP and Unix-domain sockets: the monitor. One thread serves
/// all clients and makes all diagnoses. A second thread writes the state file, and a third thread runs simulated
/// transputers.
class Service {
public:
    /// Restores the diagnoses from the state file, and listens for clients. The log receives messages for the operator.
    /// REQUIRES: the log outlives this object. Throws UserError if the address, a port, the path, the token or the
    /// state file cannot be used, or if other computers could connect without a token.
    Service(const ServiceSettings& settings, Log& log);
    ~Service();

    /// Returns the port for clients, and http_port() the port of the web page. The result is 0 if the service has no
    /// such port.
    std::uint16_t port() const;
    std::uint16_t http_port() const;
    /// Handles signals from now on. SIGINT and SIGTERM call stop() instead of ending the program. If the log is a file,
    /// SIGHUP reopens it. If the log is a terminal, SIGHUP ends the program, because the terminal has hung up.
    void heed_signals();
    /// Serves clients until stop() is called, or returns soon if stop() was called before. Then tells the clients that
    /// the service ends, and writes the state. Throws UserError if the state cannot be written.
    void run();
    /// Makes run() return. May be called from any thread.
    void stop();

private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

} // namespace placedpar::monitor
