#pragma once

#include "monitor/memory/state_store.hpp"
#include "monitor/service/dispatcher.hpp"
#include "web/server.hpp"

#include <boost/asio/io_context.hpp>

#include <string>

namespace placedpar::monitor {

/// The web site of the monitor. "/" is its page, "/snapshot" and "/history" are the page's data, and "/metrics" is for
/// Prometheus. "/healthz" returns the status 200 if everything is stored, else 503. "/healthz" needs no token; all
/// other paths do.
class Site {
public:
    /// If `store` is null, the page has no history. REQUIRES: all references and `store` outlive this object.
    Site(boost::asio::io_context& io, Dispatcher& dispatcher, StateStore* store, web::Token token, web::HostNames names,
         std::function<void(const std::string&)> say);

    void welcome(web::Listener::Socket socket, const web::Caller& caller) {
        server_.welcome(std::move(socket), caller);
    }
    void close() { server_.close(); }

private:
    void answer(const web::Request& request, const web::Reply& reply);
    web::Answer health() const;
    void answer_history(const std::string& query, const web::Reply& reply);

    boost::asio::io_context& io_;
    Dispatcher& dispatcher_;
    StateStore* store_;
    web::Server server_;
};

} // namespace placedpar::monitor
