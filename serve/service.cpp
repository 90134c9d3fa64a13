#include "serve/service.hpp"

#include "serve/site.hpp"
#include "text/user_error.hpp"
#include "web/server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <fmt/format.h>

#include <csignal>
#include <utility>

namespace placedpar::serve {

namespace asio = boost::asio;

namespace {

constexpr std::size_t largest_job_bytes = 256u << 10, most_sessions = 1000, most_sessions_of_peer = 600; ///< our choice

web::Token token_for(const ServiceSettings& settings) {
    if (!settings.token_file.empty())
        return web::Token(settings.token_file);
    if (!web::is_loopback(settings.address))
        throw UserError(fmt::format("--address {}: anyone who can reach this address could run programs on this "
                                    "computer; add --token-file FILE, or use an address of this computer only, such as "
                                    "127.0.0.1",
                                    settings.address));
    return {};
}

web::ServerSettings web_settings(const ServiceSettings& settings) {
    return {.realm = "placedpar serve",
            .token = token_for(settings),
            .names = web::HostNames(settings.address, settings.host_names),
            .most_body_bytes = largest_job_bytes,
            .most_sessions = most_sessions,
            .most_sessions_of_peer = most_sessions_of_peer};
}

} // namespace

class Service::Loop {
public:
    Loop(const ServiceSettings& settings, std::function<void(const std::string&)> say)
        : server_(
              web_settings(settings),
              [this](const web::Request& request, const web::Reply& reply) { return site_.answer(request, reply); },
              std::move(say)),
          runs_(io_, settings.queue), site_(runs_, read_examples(settings.examples), settings.keep),
          door_(web::Listener::at_port(io_, settings.address, settings.port, "--port")),
          signals_(io_, SIGINT, SIGTERM) {}

    std::uint16_t port() const { return door_.port(); }

    void run() {
        signals_.async_wait([this](const boost::system::error_code&, int) {
            door_.close();
            server_.close();
            io_.stop();
        });
        door_.open([this](web::Listener::Socket socket, const web::Caller& caller) {
            server_.welcome(std::move(socket), caller);
        });
        io_.run();
    }

private:
    asio::io_context io_{1};
    web::Server server_;
    Runs runs_;
    Site site_;
    web::Listener door_;
    asio::signal_set signals_;
};

Service::Service(const ServiceSettings& settings, std::function<void(const std::string&)> say)
    : loop_(std::make_unique<Loop>(settings, std::move(say))) {}

Service::~Service() = default;

std::uint16_t Service::port() const { return loop_->port(); }

void Service::run() { loop_->run(); }

} // namespace placedpar::serve
