#pragma once

#include "monitor/service/host_names.hpp"
#include "monitor/service/listener.hpp"
#include "monitor/service/token.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <string>

namespace placedpar::monitor {

/// The answer to a request of a browser.
struct WebAnswer {
    unsigned status = 200;
    std::string type = "text/plain; charset=utf-8"; ///< content type
    std::string text;
};

/// Serves browsers and other HTTP clients. Only GET and HEAD are accepted, so no request can change anything. All
/// functions are called from the loop's only thread.
class Web {
public:
    using Reply = std::function<void(WebAnswer)>;
    /// Receives a path and its query, such as "/history" and "machine=digger-7", and replies immediately or later.
    /// `trusted` states that the client has sent the token or that none is required.
    using Handler = std::function<void(const std::string& path, const std::string& query, bool trusted, Reply reply)>;

    /// `say` receives messages for the operator.
    Web(Token token, HostNames names, Handler handler, std::function<void(const std::string&)> say)
        : token_(std::move(token)), names_(std::move(names)), handler_(std::move(handler)), say_(std::move(say)) {}

    /// Accepts a connection. If there are too many connections, the peer with the most connections loses the connection
    /// that has waited longest.
    void welcome(Listener::Socket socket, const Caller& caller);
    void close();

private:
    class Session;
    friend class Session;

    /// Returns whether the field "Authorization" contains the token, either as a Bearer token or as the password of a
    /// Basic login with any user name. Browsers can prompt for such a login.
    bool trusts(const std::string& authorization) const;
    void make_place(const std::string& peer);

    static constexpr std::size_t most_sessions = 256, most_sessions_of_peer = 64; ///< values of our choice
    Token token_;
    HostNames names_;
    Handler handler_;
    std::function<void(const std::string&)> say_;
    std::set<std::shared_ptr<Session>> sessions_;
};

/// Decodes base64 (RFC 4648) up to the first character that is not base64.
std::string from_base64(std::string_view text);

} // namespace placedpar::monitor
