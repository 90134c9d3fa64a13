#pragma once

#include "monitor/memory/state_store.hpp"
#include "monitor/service/dispatcher.hpp"
#include "monitor/service/web.hpp"

#include <boost/asio/io_context.hpp>

#include <string>

namespace placedpar::monitor {

/// Answers the paths that browsers request: "/" is the page, "/snapshot" and "/history" are its data, "/metrics" is for
/// Prometheus. "/healthz" returns 200 if everything is stored, else 503; it alone needs no token.
class Site {
public:
    /// `store` may be null: then there is no history. REQUIRES: all references and `store` outlive this object.
    Site(boost::asio::io_context& io, Dispatcher& dispatcher, StateStore* store, Token token, HostNames names,
         std::function<void(const std::string&)> say);

    void welcome(Listener::Socket socket, const Caller& caller) { web_.welcome(std::move(socket), caller); }
    void close() { web_.close(); }

private:
    void answer(const std::string& path, const std::string& query, bool trusted, const Web::Reply& reply);
    WebAnswer health() const;
    void answer_history(const std::string& query, const Web::Reply& reply);

    boost::asio::io_context& io_;
    Dispatcher& dispatcher_;
    StateStore* store_;
    Web web_;
};

} // namespace placedpar::monitor
