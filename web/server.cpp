#include "web/server.hpp"

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

namespace placedpar::web {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;

namespace {

constexpr std::chrono::seconds most_patience{30}; ///< longest wait for a request or for the client to read an answer;
                                                  ///< our choice
constexpr std::uint32_t most_header_bytes = 8192;
constexpr std::uint64_t largest_unwanted_body_bytes = 8192; ///< our choice
constexpr const char* plain = "text/plain; charset=utf-8";

} // namespace

/// Serves one connection of a browser: one request after the other.
class Server::Session : public std::enable_shared_from_this<Session> {
public:
    Session(Server& server, Listener::Socket socket, Caller caller)
        : server_(&server), stream_(std::move(socket)), caller_(std::move(caller)) {}

    const Caller& caller() const { return caller_; }
    /// Returns the time at which the session began its present wait: for a request, or for the client to read an
    /// answer.
    std::chrono::steady_clock::time_point since() const { return since_; }

    void read() {
        state_ = State::reading;
        parser_.emplace();
        parser_->header_limit(most_header_bytes);
        parser_->body_limit(server_->settings_.most_body_bytes);
        since_ = std::chrono::steady_clock::now();
        stream_.expires_after(most_patience);
        http::async_read_header(stream_, buffer_, *parser_,
                                [self = shared_from_this()](const error_code& error, std::size_t) {
                                    if (error == http::error::body_limit && self->server_)
                                        self->refuse_body();
                                    else if (error)
                                        self->end();
                                    else
                                        self->take_header();
                                });
    }

    void end() {
        if (Server* server = std::exchange(server_, nullptr)) {
            error_code ignored;
            stream_.socket().close(ignored);
            if (Withdraw withdraw = std::exchange(withdraw_, {}))
                withdraw();
            server->sessions_.erase(shared_from_this());
        }
    }

private:
    enum class State {
        reading, ///< reads a request
        waiting, ///< waits for the handler's answer
        answering
    };

    /// Reads the body of the request. A large body is not read if the request is refused or comes without the token,
    /// since many such bodies would fill the memory. A small body is always read, since a client may send the whole
    /// body before it reads the answer.
    void take_header() {
        if (!server_)
            return;
        closes_ = has_large_body() && (!trusted() || refused());
        if (closes_)
            take();
        else
            read_body();
    }

    bool has_large_body() const {
        const auto length = parser_->content_length();
        return parser_->chunked() || (length && *length > largest_unwanted_body_bytes);
    }

    void read_body() {
        http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](const error_code& error, std::size_t) {
            if (error == http::error::body_limit && self->server_)
                self->refuse_body();
            else if (error)
                self->end();
            else
                self->take();
        });
    }

    /// Answers a request whose body is too large to be read.
    void refuse_body() {
        closes_ = true;
        std::optional<Answer> refusal = refused();
        answer(refusal ? std::move(*refusal)
                       : Answer{413, plain,
                                fmt::format("the body has more than {} bytes\n", server_->settings_.most_body_bytes)});
    }

    void take() {
        if (!server_)
            return;
        if (std::optional<Answer> refusal = refused())
            answer(std::move(*refusal));
        else
            hand_on();
    }

    void hand_on() {
        state_ = State::waiting;
        Withdraw withdraw = server_->handler_(request(), [self = shared_from_this()](Answer answer) {
            if (self->state_ == State::waiting)
                self->answer(std::move(answer));
        });
        if (state_ != State::waiting || !withdraw)
            return;
        withdraw_ = std::move(withdraw);
        watch();
    }

    std::optional<Answer> refused() const {
        std::optional<Answer> refusal = unwanted();
        return refusal ? refusal : foreign();
    }

    bool posts() const { return parser_->get().method() == http::verb::post; }

    /// Returns the refusal of a request that the service never accepts, otherwise nullopt.
    std::optional<Answer> unwanted() const {
        const auto& request = parser_->get();
        const bool takes_posts = server_->settings_.most_body_bytes > 0;
        if (takes_posts && posts() && !request[http::field::content_type].starts_with("application/json"))
            return Answer{415, plain, "the content type of a POST must be application/json\n"};
        if (request.method() == http::verb::get || request.method() == http::verb::head || (takes_posts && posts()))
            return std::nullopt;
        return Answer{405, plain,
                      takes_posts ? "only GET, HEAD and POST are allowed\n"
                                  : "only GET and HEAD are allowed: nothing can be changed over HTTP\n"};
    }

    /// Returns the refusal of a request that may come from the page of another web site, otherwise nullopt.
    std::optional<Answer> foreign() const {
        const auto& request = parser_->get();
        auto count = request.count(http::field::host);
        if (count == 0 && request.version() < 11)
            return std::nullopt; // HTTP/1.0 has no such field, and no browser uses that version
        const std::string_view field(request[http::field::host]);
        auto host = host_in(field);
        if (count != 1 || !host)
            return Answer{400, plain, "expected one Host field, with a name or an address\n"};
        if (!server_->settings_.names.has(*host, caller_.here))
            return Answer{421, plain,
                          "the Host field does not name this service; the option --host-name adds a name\n"};
        if (posts() && request.count(http::field::origin) > 0 && !is_of(request[http::field::origin], field))
            return Answer{403, plain, "the request comes from the page of another service\n"};
        return std::nullopt;
    }

    /// Returns whether a page's origin, such as "http://localhost:8080", is the host in this "Host" field.
    static bool is_of(std::string_view origin, std::string_view host) {
        const std::size_t scheme = origin.find("://");
        return scheme != origin.npos && beast::iequals(origin.substr(scheme + 3), host);
    }

    Request request() {
        const std::string target(parser_->get().target());
        const std::size_t mark = target.find('?');
        const std::string authorization(parser_->get()[http::field::authorization]);
        const bool is_trusted = trusted();
        if (!is_trusted && !authorization.empty()) {
            closes_ = true;
            server_->say_(fmt::format("{} sent a wrong token", caller_.name));
        }
        return {posts(),
                target.substr(0, mark),
                mark == target.npos ? "" : target.substr(mark + 1),
                std::move(parser_->get().body()),
                is_trusted,
                caller_.peer};
    }

    bool trusted() const { return server_->trusts(std::string(parser_->get()[http::field::authorization])); }

    /// While a request waits for its answer, ends the session if the client closes the connection or sends more bytes.
    /// Browsers send no bytes at this time, and unread bytes would hide the end of the connection.
    void watch() {
        if (buffer_.size() > 0)
            return end();
        stream_.expires_never();
        stream_.socket().async_wait(Listener::Socket::wait_read, [self = shared_from_this()](const error_code&) {
            if (self->state_ == State::waiting)
                self->end();
        });
    }

    void answer(Answer answer) {
        if (!server_)
            return;
        state_ = State::answering;
        withdraw_ = {};
        error_code ignored;
        stream_.socket().cancel(ignored); // this ends watch()
        const auto& request = parser_->get();
        response_ = {static_cast<http::status>(answer.status), request.version()};
        set_fields(answer.type);
        response_.keep_alive(request.keep_alive() && !closes_);
        response_.body() = std::move(answer.text);
        response_.prepare_payload();
        if (request.method() == http::verb::head)
            response_.body().clear(); // keeps the length that the answer to a GET would have
        write();
    }

    void set_fields(const std::string& type) {
        response_.set(http::field::content_type, type);
        response_.set(http::field::cache_control, "no-store");
        response_.set("Content-Security-Policy", server_->settings_.policy);
        response_.set("X-Content-Type-Options", "nosniff");
        if (response_.result() == http::status::unauthorized)
            response_.set(http::field::www_authenticate,
                          fmt::format("Basic realm=\"{}\", Bearer", server_->settings_.realm));
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

    Server* server_; ///< null: the server no longer exists
    beast::basic_stream<boost::asio::generic::stream_protocol> stream_;
    Caller caller_;
    std::chrono::steady_clock::time_point since_;
    bool closes_ = false; ///< whether to close the connection after this answer: a body was not read, or the token was
                          ///< wrong (each guess must cost a connection)
    State state_ = State::reading;
    Withdraw withdraw_; ///< set only while the session waits
    beast::flat_buffer buffer_{most_header_bytes};
    std::optional<http::request_parser<http::string_body>> parser_;
    http::response<http::string_body> response_;
};

void Server::welcome(Listener::Socket socket, const Caller& caller) {
    std::map<std::string, std::size_t> of_peers;
    for (const auto& each : sessions_)
        ++of_peers[each->caller().peer];
    if (of_peers[caller.peer] >= settings_.most_sessions_of_peer)
        make_place(caller.peer);
    else if (sessions_.size() >= settings_.most_sessions)
        make_place(std::ranges::max_element(of_peers, {}, [](const auto& each) { return each.second; })->first);
    auto session = std::make_shared<Session>(*this, std::move(socket), caller);
    sessions_.insert(session);
    session->read();
}

void Server::make_place(const std::string& peer) {
    std::shared_ptr<Session> oldest;
    for (const auto& each : sessions_)
        if (each->caller().peer == peer && (!oldest || each->since() < oldest->since()))
            oldest = each;
    oldest->end();
}

void Server::close() {
    while (!sessions_.empty())
        std::shared_ptr<Session>(*sessions_.begin())->end();
}

bool Server::trusts(const std::string& authorization) const {
    constexpr std::string_view bearer = "Bearer ", basic = "Basic ";
    if (!settings_.token.wanted())
        return true;
    std::string_view said = authorization;
    if (beast::iequals(said.substr(0, bearer.size()), bearer))
        return settings_.token.is(said.substr(bearer.size()));
    if (!beast::iequals(said.substr(0, basic.size()), basic))
        return false;
    std::string pair = from_base64(said.substr(basic.size()));
    std::size_t colon = pair.find(':');
    return colon != pair.npos && settings_.token.is(std::string_view(pair).substr(colon + 1));
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

} // namespace placedpar::web
