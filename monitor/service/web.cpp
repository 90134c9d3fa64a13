#include "monitor/service/web.hpp"

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/beast/core/basic_stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

namespace placedpar::monitor {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;

namespace {

constexpr std::chrono::seconds most_patience{30}; ///< longest wait for a request to arrive or its answer to be read;
                                                  ///< our choice
constexpr std::uint32_t most_header_bytes = 8192;

/// Allows content and requests from this service only, and forbids other pages to embed it.
constexpr const char* policy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
                               "connect-src 'self'; img-src 'self' data:; frame-ancestors 'none'";

} // namespace

/// One connection of a browser.
class Web::Session : public std::enable_shared_from_this<Session> {
public:
    Session(Web& web, Listener::Socket socket, Caller caller)
        : web_(&web), stream_(std::move(socket)), caller_(std::move(caller)) {}

    const Caller& caller() const { return caller_; }
    /// Returns when the session began to wait for a request or for its answer to be read.
    std::chrono::steady_clock::time_point since() const { return since_; }

    void read() {
        parser_.emplace();
        parser_->header_limit(most_header_bytes);
        parser_->body_limit(0);
        since_ = std::chrono::steady_clock::now();
        stream_.expires_after(most_patience);
        http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](const error_code& error, std::size_t) {
            if (error)
                self->end();
            else
                self->take();
        });
    }

    void end() {
        if (Web* web = std::exchange(web_, nullptr)) {
            error_code ignored;
            stream_.socket().close(ignored);
            web->sessions_.erase(shared_from_this());
        }
    }

private:
    void take() {
        const auto& request = parser_->get();
        if (!web_)
            return;
        if (request.method() != http::verb::get && request.method() != http::verb::head) {
            answer({405, "text/plain; charset=utf-8",
                    "only GET and HEAD are allowed: nothing can be changed over HTTP\n"});
            return;
        }
        if (std::optional<WebAnswer> refusal = foreign()) {
            answer(std::move(*refusal));
            return;
        }
        std::string target(request.target());
        std::size_t mark = target.find('?');
        std::string authorization(request[http::field::authorization]);
        bool trusted = web_->trusts(authorization);
        guessed_ = !trusted && !authorization.empty();
        if (guessed_)
            web_->say_(fmt::format("{} sent a wrong token", caller_.name));
        web_->handler_(target.substr(0, mark), mark == target.npos ? "" : target.substr(mark + 1), trusted,
                       [self = shared_from_this()](WebAnswer answer) { self->answer(std::move(answer)); });
    }

    /// Returns the refusal of a request that is not certainly meant for this service, or nullopt.
    std::optional<WebAnswer> foreign() const {
        constexpr const char* plain = "text/plain; charset=utf-8";
        const auto& request = parser_->get();
        auto count = request.count(http::field::host);
        if (count == 0 && request.version() < 11)
            return std::nullopt; // HTTP/1.0 has no such field, and no browser uses that version
        auto host = host_in(std::string_view(request[http::field::host]));
        if (count != 1 || !host)
            return WebAnswer{400, plain, "expected one Host field, with a name or an address\n"};
        if (!web_->names_.has(*host, caller_.here))
            return WebAnswer{421, plain, "the Host field does not name the monitor; --host-name adds a name\n"};
        return std::nullopt;
    }

    void answer(WebAnswer answer) {
        if (!web_)
            return;
        const auto& request = parser_->get();
        response_ = {static_cast<http::status>(answer.status), request.version()};
        response_.set(http::field::content_type, answer.type);
        response_.set(http::field::cache_control, "no-store");
        response_.set("Content-Security-Policy", policy);
        response_.set("X-Content-Type-Options", "nosniff");
        if (answer.status == 401)
            response_.set(http::field::www_authenticate, "Basic realm=\"placedpar monitor\", Bearer");
        response_.keep_alive(request.keep_alive() && !guessed_);
        response_.body() = std::move(answer.text);
        response_.prepare_payload();
        if (request.method() == http::verb::head)
            response_.body().clear(); // keeps the length of what GET would return
        write();
    }

    void write() {
        stream_.expires_after(most_patience);
        http::async_write(stream_, response_, [self = shared_from_this()](const error_code& error, std::size_t) {
            if (error || !self->response_.keep_alive())
                self->end();
            else
                self->read();
        });
    }

    Web* web_; ///< null: the Web object no longer exists
    beast::basic_stream<boost::asio::generic::stream_protocol> stream_;
    Caller caller_;
    std::chrono::steady_clock::time_point since_;
    bool guessed_ = false; ///< the client has sent a wrong token; each guess costs a connection
    beast::flat_buffer buffer_{most_header_bytes};
    std::optional<http::request_parser<http::empty_body>> parser_;
    http::response<http::string_body> response_;
};

void Web::welcome(Listener::Socket socket, const Caller& caller) {
    std::map<std::string, std::size_t> of_peers;
    for (const auto& each : sessions_)
        ++of_peers[each->caller().peer];
    if (of_peers[caller.peer] >= most_sessions_of_peer)
        make_place(caller.peer);
    else if (sessions_.size() >= most_sessions)
        make_place(std::ranges::max_element(of_peers, {}, [](const auto& each) { return each.second; })->first);
    auto session = std::make_shared<Session>(*this, std::move(socket), caller);
    sessions_.insert(session);
    session->read();
}

void Web::make_place(const std::string& peer) {
    std::shared_ptr<Session> oldest;
    for (const auto& each : sessions_)
        if (each->caller().peer == peer && (!oldest || each->since() < oldest->since()))
            oldest = each;
    oldest->end();
}

void Web::close() {
    while (!sessions_.empty())
        std::shared_ptr<Session>(*sessions_.begin())->end();
}

bool Web::trusts(const std::string& authorization) const {
    constexpr std::string_view bearer = "Bearer ", basic = "Basic ";
    if (!token_.wanted())
        return true;
    std::string_view said = authorization;
    if (beast::iequals(said.substr(0, bearer.size()), bearer))
        return token_.is(said.substr(bearer.size()));
    if (!beast::iequals(said.substr(0, basic.size()), basic))
        return false;
    std::string pair = from_base64(said.substr(basic.size()));
    std::size_t colon = pair.find(':');
    return colon != pair.npos && token_.is(std::string_view(pair).substr(colon + 1));
}

std::string from_base64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (char c : text) {
        std::size_t digit = digits.find(c);
        if (digit == digits.npos)
            break;
        bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xffffff;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 0xff);
        }
    }
    return bytes;
}

} // namespace placedpar::monitor
