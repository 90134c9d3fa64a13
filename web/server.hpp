#pragma once

#include "web/host_names.hpp"
#include "web/listener.hpp"
#include "web/token.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <string>

namespace placedpar::web {

/// A request of a browser or another HTTP client, whose "Host" field names this service.
struct Request {
    bool posts = false; ///< true for POST; false for GET and HEAD
    std::string path;   ///< such as "/history"
    std::string query;  ///< the part after "?", such as "machine=digger-7"
    std::string body;   ///< the JSON text of a POST; "" for GET and HEAD
    bool trusted; ///< whether the client has sent the token, or no token is required; if false, `body` may be missing
    std::string peer; ///< Caller::peer of the client
};

struct Answer {
    unsigned status = 200;
    std::string type = "text/plain; charset=utf-8"; ///< content type
    std::string text;
};

struct ServerSettings {
    std::string realm; ///< the service's name in a browser's prompt for the token
    Token token;
    HostNames names;
    std::size_t most_body_bytes =
        0; ///< largest body of a POST; 0: POST is refused, so that no request can change anything
    std::size_t most_sessions = 256,
                most_sessions_of_peer =
                    64; ///< the greatest number of connections, in total and of one peer; this project's choice
    /// The content security policy. By default, content and requests come only from this service. Other pages must not
    /// embed the service's page.
    std::string policy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
                         "connect-src 'self'; img-src 'self' data:; frame-ancestors 'none'";
};

/// A function that sends the answer to a request. It may be called at most once. It has no effect if the client has
/// gone.
using Reply = std::function<void(Answer)>;
/// A function that the server calls if the client leaves before the answer is ready.
using Withdraw = std::function<void()>;

/// Serves browsers and other HTTP clients. A POST must carry JSON. A browser's POST must come from the service's own
/// page, so that other web pages cannot use the service. All functions are called from the event loop's only thread.
class Server {
public:
    /// Answers a request, immediately or later. Returns a function that withdraws the request, or an empty function.
    using Handler = std::function<Withdraw(const Request&, Reply)>;

    /// `say` receives messages for the operator.
    Server(ServerSettings settings, Handler handler, std::function<void(const std::string&)> say)
        : settings_(std::move(settings)), handler_(std::move(handler)), say_(std::move(say)) {}

    /// Accepts a connection. If there are too many connections, closes one: of the peer with the most connections, the
    /// connection that has waited longest.
    void welcome(Listener::Socket socket, const Caller& caller);
    void close();

private:
    class Session;
    friend class Session;

    /// Returns whether the field "Authorization" contains the token, either as a Bearer token or as the password of a
    /// Basic login with any user name. Browsers can prompt for such a login.
    bool trusts(const std::string& authorization) const;
    void make_place(const std::string& peer);

    ServerSettings settings_;
    Handler handler_;
    std::function<void(const std::string&)> say_;
    std::set<std::shared_ptr<Session>> sessions_;
};

/// Decodes base64 (RFC 4648) up to the first character that is not base64.
std::string from_base64(std::string_view text);

} // namespace placedpar::web
