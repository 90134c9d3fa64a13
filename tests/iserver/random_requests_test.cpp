#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include "tests/iserver/served_program.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace placedpar;
using iserver::Bytes;
using iserver::ByteView;
using test::Request;
using test::ScratchFolder;
using test::ServedProgram;
namespace fs = std::filesystem;

namespace {

/// Makes requests that are nearly right: a program that guesses what could do damage.
class Attacker {
public:
    explicit Attacker(std::uint64_t seed) : random_(seed) {}

    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

    Bytes request() {
        static constexpr std::uint8_t tags[] = {10, 10, 10, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                                                22, 22, 23, 24, 25, 31, 32, 33, 34, 40, 41, 42, 50, 255};
        Request request(tags[below(std::size(tags))]);
        for (std::uint32_t field = below(5); field-- > 0;)
            add_field(request);
        Bytes bytes = request.bytes();
        if (below(4) == 0)
            bytes[below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<std::uint8_t>(below(256));
        if (bytes[0] == 30 || bytes[0] == 35)
            bytes[0] = 31; // does not end the run
        return bytes;
    }

private:
    void add_field(Request& request) {
        static constexpr std::int64_t words[] = {0, 1, 2, 3, 4, 5, 6, 7, -1, 255, 256, 0x7fffffff, -0x80000000LL, 4095};
        switch (below(5)) {
        case 0: request.byte(static_cast<int>(below(8))); break;
        case 1: request.count(below(2) ? below(600) : below(65536)); break;
        case 2: request.word(words[below(std::size(words))]); break;
        case 3: request.text(name()).byte(static_cast<int>(1 + below(2))).byte(static_cast<int>(1 + below(6))); break;
        default: request.text(std::string(below(480), static_cast<char>(below(256))));
        }
    }

    std::string name() {
        static constexpr const char* parts[] = {"..", "link", "up",     "a",        "b",   "file",
                                                ".",  "",     "secret", "dangling", "pipe"};
        std::string name = below(8) == 0 ? "/" : "";
        for (std::uint32_t part = below(4); part-- > 0;)
            name += std::string(parts[below(std::size(parts))]) + "/";
        return name + parts[below(std::size(parts))];
    }

    std::mt19937_64 random_;
};

/// A folder with everything that could lead out of it.
void lay_traps(const ScratchFolder& folder) {
    fs::create_directories(folder.path() / "a/b");
    fs::create_symlink(folder.secret(), folder.path() / "link");
    fs::create_symlink("..", folder.path() / "a/up");
    fs::create_symlink("..", folder.path() / "up");
    fs::create_symlink("../made", folder.path() / "dangling");
    fs::create_symlink("../../secret", folder.path() / "a/secret");
}

std::string well_formed(const Bytes& reply) {
    if (reply.size() < 8 || reply.size() > 512 || reply.size() % 2 != 0)
        return "size " + std::to_string(reply.size());
    if (reply[0] + 256U * reply[1] + 2U != reply.size())
        return "a wrong length";
    return reply[2] == 0 || reply[2] == 1 || reply[2] == 129 ? "" : "result " + std::to_string(reply[2]);
}

} // namespace

TEST_CASE("megabytes of random requests get replies and reach nothing outside the folder") {
    for (std::uint64_t seed : test::seeds(8)) {
        INFO(test::replay(seed));
        ScratchFolder folder;
        lay_traps(folder);
        ServedProgram program({.host_folder = folder.path(), .write_limit_bytes = 200'000}, "some keys\nand lines\n");
        Attacker attacker(seed);
        std::size_t opened = 0;
        for (std::size_t bytes = 0; bytes < 1'000'000;) {
            const Bytes request = attacker.request();
            bytes += request.size();
            const iserver::Answer answer = program.server().answer(request, std::chrono::microseconds(bytes));
            if (answer.state == iserver::ServerState::waits_for_input)
                break; // the program has read too often beyond the end of its input
            REQUIRE(well_formed(answer.reply) == "");
            REQUIRE(std::string(answer.reply.begin(), answer.reply.end()).find("unseen") == std::string::npos);
            opened += request[0] == 10 && answer.reply[2] == 0 ? 1 : 0;
        }
        CHECK(opened > 0);
        CHECK(folder.content("../secret") == "unseen");
        CHECK(std::distance(fs::directory_iterator(folder.path().parent_path()), {}) == 2);
        CHECK(std::ranges::none_of(program.screen(), [](char c) { return c == '\0' || c == '\x7f'; }));
    }
}

TEST_CASE("random bytes of a link are requests or are refused, and every request gets a reply") {
    for (std::uint64_t seed : test::seeds(200)) {
        INFO(test::replay(seed));
        Attacker attacker(seed);
        ServedProgram program;
        iserver::PacketReader reader;
        Bytes sent;
        for (int packet = 0; packet < 20; ++packet) {
            Bytes request = attacker.request();
            request.resize(std::clamp<std::size_t>(request.size() + request.size() % 2, 6, 510));
            sent.push_back(static_cast<std::uint8_t>(request.size()));
            sent.push_back(static_cast<std::uint8_t>(request.size() >> 8));
            sent.insert(sent.end(), request.begin(), request.end());
        }
        if (seed % 2 == 1)
            sent[attacker.below(static_cast<std::uint32_t>(sent.size()))] ^=
                static_cast<std::uint8_t>(1 + attacker.below(255));
        ByteView rest = sent;
        while (!rest.empty() && reader.refusal().empty())
            if (const ByteView request = reader.take(rest); !request.empty())
                REQUIRE(well_formed(program.server().answer(request, {}).reply) == "");
        CHECK((seed % 2 == 1 || (reader.refusal().empty() && reader.held() == 0)));
    }
}
