#pragma once

#include "serve/runs.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace placedpar::serve {

struct ServiceSettings {
    std::string address = "127.0.0.1";
    std::uint16_t port = 8080; ///< 0: any free port
    std::string token_file;    ///< empty: no token is required
    /// Further host names, besides `address`, under which browsers may call the service.
    std::vector<std::string> host_names;
    std::string keep;               ///< folder in which the programs of runs are stored; empty: nothing is stored
    std::filesystem::path examples; ///< folder of the examples
    QueueLimits queue;
};

/// Serves the page on which users edit and run netlists and programs in occam.
class Service {
public:
    /// Listens. `say` receives messages for the operator. Throws UserError if the address, the port, the token or a
    /// folder cannot be used, or if other computers could connect without a token.
    Service(const ServiceSettings&, std::function<void(const std::string&)> say);
    ~Service();

    std::uint16_t port() const;
    /// Serves until SIGINT or SIGTERM arrives.
    void run();

private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

} // namespace placedpar::serve
