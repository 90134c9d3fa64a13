#pragma once

#include "identification/on_line/settings.hpp"
#include "monitor/service/limits.hpp"
#include "monitor/service/log.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::monitor {

struct ServiceSettings {
    std::string address = "127.0.0.1";
    std::optional<std::uint16_t> port = 0;  ///< 0: any free; none: nobody comes in there
    std::string unix_path;                  ///< a socket in the file system; empty: none
    std::optional<std::uint16_t> http_port; ///< of the page; 0: any free; none: there is none
    std::vector<std::string> host_names;    ///< by which browsers come, besides those of the address
    std::string token_file;                 ///< empty: no token
    std::string state;                      ///< a file; empty: nothing is kept
    std::uint64_t seed = 1;
    ServiceLimits limits;
    identification::DiagnosisSettings diagnosis;
};

/// The on-line diagnosis as a service over TCP and sockets of this computer. One thread does everything; a second one
/// writes the state file.
class Service {
public:
    /// Restores the state and listens. The log gets sentences for the operator. REQUIRES: it outlives this. Throws
    /// UserError when address, port, path, token or state file cannot be used, or others than this computer could come
    /// in without a token, saying what is wrong.
    Service(const ServiceSettings& settings, Log& log);
    ~Service();

    /// 0 when there is none.
    std::uint16_t port() const;
    std::uint16_t http_port() const;
    /// From now on SIGINT and SIGTERM call stop() instead of ending the program, and SIGHUP opens the log anew, unless
    /// that is a terminal, which has hung up then.
    void heed_signals();
    /// Serves until stop(), which may have been called before; then tells the clients and writes the state. Throws
    /// UserError when that cannot be written.
    void run();
    /// From any thread.
    void stop();

private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

} // namespace placedpar::monitor
