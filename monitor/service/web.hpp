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

/// What a browser is sent.
struct WebAnswer {
    unsigned status = 200;
    std::string type = "text/plain; charset=utf-8"; ///< of the content
    std::string text;
};

/// Serves pages to browsers and other programs that speak HTTP: nothing but GET and HEAD, so that nobody changes
/// anything. All functions are called from the loop's one thread.
class Web {
public:
    using Reply = std::function<void(WebAnswer)>;
    /// Is given a path and its query, "/history", "machine=digger-7", and replies at once or later. `trusted`: who asks
    /// knows the token, or there is none.
    using Handler = std::function<void(const std::string& path, const std::string& query, bool trusted, Reply reply)>;

    /// `say` is given sentences for the operator.
    Web(Token token, HostNames names, Handler handler, std::function<void(const std::string&)> say)
        : token_(std::move(token)), names_(std::move(names)), handler_(std::move(handler)), say_(std::move(say)) {}

    /// Where there are too many, the peer with most of them loses the one that has been waiting the longest.
    void welcome(Listener::Socket socket, const Caller& caller);
    /// Closes all connections.
    void close();

private:
    class Session;
    friend class Session;

    /// "Authorization": the token itself (Bearer), or as the password of anybody (Basic), as browsers ask for it.
    bool trusts(const std::string& authorization) const;
    void make_place(const std::string& peer);

    static constexpr std::size_t most_sessions = 256, most_sessions_of_peer = 64; ///< ours
    Token token_;
    HostNames names_;
    Handler handler_;
    std::function<void(const std::string&)> say_;
    std::set<std::shared_ptr<Session>> sessions_;
};

/// Of text in base64 (RFC 4648); what follows the first other character is left out.
std::string from_base64(std::string_view text);

} // namespace placedpar::monitor
