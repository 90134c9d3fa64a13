#pragma once

#include "iserver/server.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace placedpar::test {

/// A folder for one test, with a secret file beside it that no program may reach.
class ScratchFolder {
public:
    ScratchFolder()
        : top_(std::filesystem::temp_directory_path() / ("placedpar-iserver-" + std::to_string(::getpid()))),
          path_(top_ / "host") {
        std::filesystem::remove_all(top_);
        std::filesystem::create_directories(path_);
        std::ofstream(secret()) << "unseen";
    }
    ~ScratchFolder() { std::filesystem::remove_all(top_); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path secret() const { return top_ / "secret"; }
    void write(const std::string& name, std::string_view content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
    }
    std::string content(const std::filesystem::path& name) const {
        std::ifstream file(path_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

private:
    std::filesystem::path top_, path_;
};

/// A request that is put together by hand.
class Request {
public:
    explicit Request(std::uint8_t tag) { byte(tag); }
    Request& byte(int value) {
        bytes_.push_back(static_cast<std::uint8_t>(value));
        return *this;
    }
    Request& count(std::size_t value) { return byte(static_cast<int>(value & 255)).byte(static_cast<int>(value >> 8)); }
    Request& word(std::int64_t value) {
        const auto bits = static_cast<std::uint32_t>(value);
        return count(bits & 0xffff).count(bits >> 16);
    }
    Request& text(std::string_view text) {
        count(text.size());
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        return *this;
    }
    const iserver::Bytes& bytes() const { return bytes_; }

private:
    iserver::Bytes bytes_;
};

/// Returns a reply's text, which follows its result.
inline std::string text_of(const iserver::Bytes& reply) {
    REQUIRE(reply.size() >= 5);
    const std::size_t size = reply[3] + 256U * reply[4];
    REQUIRE(reply.size() >= 5 + size);
    return {reply.begin() + 5, reply.begin() + 5 + static_cast<std::ptrdiff_t>(size)};
}

/// Returns the number at a byte of a reply.
inline std::int64_t word_of(const iserver::Bytes& reply, std::size_t at = 3) {
    REQUIRE(reply.size() >= at + 4);
    std::uint32_t bits = 0;
    for (std::size_t byte = 4; byte-- > 0;)
        bits = bits << 8 | reply[at + byte];
    return static_cast<std::int32_t>(bits);
}

/// A program whose requests are made by a test, with its server.
class ServedProgram {
public:
    explicit ServedProgram(iserver::ServerOptions options = {}, std::string keys = "")
        : terminal_(std::move(keys), [this](std::string_view text) { screen_ += text; }),
          server_(std::move(options), terminal_) {}

    iserver::Answer answer(const Request& request, std::chrono::microseconds time = {}) {
        return server_.answer(request.bytes(), time);
    }
    iserver::Bytes reply(const Request& request) { return answer(request).reply; }
    /// Returns whether the request succeeded.
    bool succeeds(const Request& request) { return reply(request).at(2) == 0; }

    /// Opens a file and returns its stream; -1 if this failed.
    std::int64_t open(std::string_view name, int mode, int type = 1) {
        const iserver::Bytes opened = reply(Request(10).text(name).byte(type).byte(mode));
        return opened.at(2) == 0 ? word_of(opened) : -1;
    }
    std::string read(std::int64_t stream, std::size_t most) {
        return text_of(reply(Request(12).word(stream).count(most)));
    }
    std::size_t write(std::int64_t stream, std::string_view text) {
        const iserver::Bytes written = reply(Request(13).word(stream).text(text));
        return written.at(2) == 0 ? written.at(3) + 256U * written.at(4) : 0;
    }

    iserver::Server& server() { return server_; }
    const std::string& screen() const { return screen_; }

private:
    std::string screen_;
    iserver::ScriptedTerminal terminal_;
    iserver::Server server_;
};

} // namespace placedpar::test
