#include "monitor/service/connection.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <fmt/format.h>

#include <utility>

namespace placedpar::monitor {

namespace asio = boost::asio;
using boost::system::error_code;

namespace {

double seconds(Connection::Clock::duration time) { return std::chrono::duration<double>(time).count(); }

} // namespace

Connection::Connection(Socket socket, const ServiceLimits& limits, Handlers handlers)
    : socket_(std::move(socket)), limits_(limits), handlers_(std::move(handlers)) {
    opened_ = last_line_ = line_begun_ = last_written_ = Clock::now();
}

void Connection::start() { read(); }

void Connection::read() {
    reading_ = true;
    socket_.async_read_some(
        asio::buffer(chunk_),
        [self = shared_from_this()](const error_code& error, std::size_t count) { self->received(error, count); });
}

void Connection::received(const error_code& error, std::size_t count) {
    reading_ = false;
    if (closed_)
        return;
    if (error && error != asio::error::eof) {
        close();
        return;
    }
    ended_ = error == asio::error::eof;
    if (finishing_) {
        go_on_finishing();
        return;
    }
    if (input_.empty())
        line_begun_ = Clock::now();
    input_.append(chunk_.data(), count);
    next_line();
}

void Connection::next_line() {
    if (closed_ || finishing_)
        return;
    if (queued_bytes() > limits_.queue_bytes / 4) {
        held_back_ = true;
        return;
    }
    std::size_t end = input_.find('\n', searched_);
    if (std::min(end, input_.size()) > limits_.line_bytes)
        refuse(fmt::format("the line has more than {} bytes", limits_.line_bytes),
               "one short JSON object in each line");
    else if (end != std::string::npos)
        hand_on(end);
    else if (ended_ && !input_.empty())
        hand_on(input_.size()); // the end of the stream ends its last line, too
    else if (ended_ && held_ > 0)
        held_back_ = true; // waits until the program has answered the line
    else if (ended_)
        finish();
    else {
        searched_ = input_.size();
        read();
    }
}

void Connection::hand_on(std::size_t end) {
    std::string line = input_.substr(0, end);
    input_.erase(0, end + 1);
    searched_ = 0;
    if (!line.empty() && line.back() == '\r')
        line.pop_back();
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // some programs begin every text with this mark
    if (++lines_ == 1 && line.starts_with(byte_order_mark))
        line.erase(0, byte_order_mark.size());
    last_line_ = line_begun_ = Clock::now();
    if (!line.empty())
        handlers_.line(*this, line);
    asio::post(socket_.get_executor(), [self = shared_from_this()] { self->next_line(); });
}

void Connection::send(std::string_view line) {
    if (closed_ || finishing_)
        return;
    if (queued_bytes() + line.size() > limits_.queue_bytes) {
        std::size_t lost = waiting_.size() + line.size();
        waiting_.clear(); // the text that is being written ends with a whole line
        refuse(
            fmt::format("the client reads too slowly: {} bytes were queued, {} dropped", queued_bytes() + lost, lost),
            "a client that reads answers as fast as it asks for them, or \"answers\":\"moved\"");
        return;
    }
    waiting_ += line;
    write();
}

void Connection::hold(std::ptrdiff_t bytes) {
    held_ += static_cast<std::size_t>(bytes);
    if (bytes < 0 && held_back_ && writing_.empty() && waiting_.empty())
        write();
}

void Connection::write() {
    if (closed_ || !writing_.empty())
        return;
    if (waiting_.empty()) {
        if (finishing_) {
            error_code ignored;
            socket_.shutdown(Socket::shutdown_send, ignored);
            go_on_finishing();
        } else if (std::exchange(held_back_, false))
            asio::post(socket_.get_executor(), [self = shared_from_this()] { self->next_line(); });
        return;
    }
    std::swap(writing_, waiting_);
    written_ = 0;
    last_written_ = Clock::now();
    socket_.async_write_some(
        asio::buffer(writing_),
        [self = shared_from_this()](const error_code& error, std::size_t count) { self->sent(error, count); });
}

void Connection::sent(const error_code& error, std::size_t count) {
    if (closed_)
        return;
    if (error) {
        close();
        return;
    }
    last_written_ = Clock::now();
    written_ += count;
    if (written_ < writing_.size()) {
        socket_.async_write_some(asio::buffer(writing_.data() + written_, writing_.size() - written_),
                                 [self = shared_from_this()](const error_code& e, std::size_t n) { self->sent(e, n); });
        return;
    }
    writing_.clear();
    write();
}

void Connection::refuse(const std::string& wrong, const std::string& right) {
    waiting_ += handlers_.refusal(wrong, right);
    finish();
}

void Connection::finish() {
    if (closed_ || finishing_)
        return;
    finishing_ = true;
    finishing_since_ = Clock::now();
    input_ = {};
    asio::post(socket_.get_executor(), [self = shared_from_this()] {
        self->write();
        self->go_on_finishing();
    });
}

void Connection::go_on_finishing() {
    if (closed_)
        return;
    // Closing with unread bytes would reset the connection, and the last message could be lost.
    if (!ended_ && !reading_)
        read();
    else if (ended_ && waiting_.empty() && writing_.empty())
        close();
}

void Connection::tick(Clock::time_point now) {
    if (closed_)
        return;
    if (finishing_) {
        if (seconds(now - finishing_since_) > limits_.closing_s)
            close();
        return;
    }
    if (!writing_.empty() && seconds(now - last_written_) > limits_.stall_s)
        close();
    else if (!greeted_ && seconds(now - opened_) > limits_.hello_s)
        refuse(fmt::format("no hello has arrived within {} s", limits_.hello_s),
               "{\"type\":\"hello\",\"version\":1,\"machine\":\"name\"}");
    else if (!input_.empty() && !held_back_ && seconds(now - line_begun_) > limits_.line_s)
        refuse(fmt::format("the line is still incomplete after {} s", limits_.line_s),
               "a whole line, ended by a newline");
    else if (seconds(now - last_line_) > limits_.idle_s)
        refuse(fmt::format("no line has arrived for {} s", limits_.idle_s), "{\"type\":\"ping\"} from time to time");
}

void Connection::close() {
    if (std::exchange(closed_, true))
        return;
    error_code ignored;
    socket_.close(ignored);
    handlers_.closed(*this);
}

} // namespace placedpar::monitor
