#include "monitor/service/send_command.hpp"

#include "text/user_error.hpp"
#include "web/token.hpp"

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <boost/json.hpp>
#include <fmt/format.h>

#include <chrono>

namespace placedpar::monitor {

namespace asio = boost::asio;
namespace json = boost::json;

namespace {

constexpr std::size_t most_answer_bytes = 64u << 20;
constexpr std::chrono::seconds patience{10};

std::string text_of(const json::value& answer, const char* name) {
    const json::value* text = answer.as_object().if_contains(name);
    return text && text->is_string() ? std::string(text->get_string()) : "";
}

std::string field_of(const json::value& answer) {
    std::string field = text_of(answer, "field");
    return field.empty() ? "" : field + ": ";
}

class CommandConnection {
public:
    explicit CommandConnection(const ServicePlace& place) : socket_(io_) {
        name_ = place.unix_path.empty() ? fmt::format("{} port {}", place.address, place.port) : place.unix_path;
        boost::system::error_code error;
        if (!place.unix_path.empty())
            socket_.connect(asio::local::stream_protocol::endpoint(place.unix_path), error);
        else if (auto address = asio::ip::make_address(place.address, error); !error)
            socket_.connect(asio::ip::tcp::endpoint(address, place.port), error);
        if (error)
            fail(error.message());
    }

    std::string ask(const std::string& message) {
        boost::system::error_code error = asio::error::timed_out;
        asio::write(socket_, asio::buffer(message + "\n"));
        asio::async_read_until(socket_, asio::dynamic_buffer(read_, most_answer_bytes), '\n',
                               [&](const boost::system::error_code& ended, std::size_t) { error = ended; });
        io_.restart();
        io_.run_for(patience);
        if (error)
            fail(error == asio::error::eof ? "the monitor closed the connection" : error.message());
        std::size_t end = read_.find('\n') + 1;
        std::string line = read_.substr(0, end);
        read_.erase(0, end);
        require_answer(name_, line);
        return line;
    }

private:
    [[noreturn]] void fail(const std::string& why) { throw UserError(fmt::format("{}: {}", name_, why)); }

    asio::io_context io_;
    asio::generic::stream_protocol::socket socket_;
    std::string name_, read_;
};

} // namespace

void require_answer(const std::string& name, const std::string& line) {
    boost::system::error_code error;
    json::value answer = json::parse(line, error);
    if (error || !answer.is_object() || !answer.as_object().contains("type"))
        throw UserError(fmt::format("{}: the program at this address is not a placedpar monitor", name));
    if (answer.at("type") == "error")
        throw UserError(fmt::format("{}: {}{}, expected {}", name, field_of(answer), text_of(answer, "wrong"),
                                    text_of(answer, "right")));
}

std::string ask_service(const ServicePlace& place, const std::string& message) try {
    CommandConnection errand(place);
    if (!place.token_file.empty())
        errand.ask(json::serialize(json::object{{"type", "token"}, {"token", web::Token(place.token_file).word()}}));
    return errand.ask(message);
} catch (const boost::system::system_error& error) {
    throw UserError(fmt::format("cannot send to the monitor: {}", error.code().message()));
}

} // namespace placedpar::monitor
