#include "iserver/packet.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;
using iserver::Bytes;
using iserver::ByteView;
using iserver::PacketReader;

namespace {

/// Returns the requests among bytes that come in parts of the given size.
std::vector<Bytes> requests_among(const Bytes& bytes, std::size_t part) {
    PacketReader reader;
    std::vector<Bytes> requests;
    for (std::size_t at = 0; at < bytes.size(); at += part) {
        ByteView rest = ByteView(bytes).subspan(at).first(std::min(part, bytes.size() - at));
        while (!rest.empty())
            if (ByteView request = reader.take(rest); !request.empty())
                requests.emplace_back(request.begin(), request.end());
    }
    CHECK(reader.refusal() == "");
    CHECK(reader.held() == 0);
    return requests;
}

std::string refusal_of(const Bytes& bytes) {
    PacketReader reader;
    ByteView rest = bytes;
    while (!rest.empty() && reader.wanted() > 0)
        reader.take(rest);
    const std::size_t left = rest.size();
    CHECK(reader.take(rest).empty());
    CHECK(rest.size() == left);
    return reader.refusal();
}

/// Returns the bytes of two requests: one of the longest, one of the shortest.
Bytes two_requests() {
    Bytes bytes{254, 1};
    for (std::size_t byte = 0; byte < 510; ++byte)
        bytes.push_back(static_cast<std::uint8_t>(byte));
    for (int byte : {6, 0, 30, 0, 0, 0, 0, 0})
        bytes.push_back(static_cast<std::uint8_t>(byte));
    return bytes;
}

} // namespace

TEST_CASE("requests are found wherever the bytes of a link are split") {
    const Bytes bytes = two_requests();
    for (std::size_t part = 1; part <= bytes.size(); ++part) {
        INFO("parts of " << part << " bytes");
        const std::vector<Bytes> requests = requests_among(bytes, part);
        REQUIRE(requests.size() == 2);
        CHECK(requests[0] == Bytes(bytes.begin() + 2, bytes.begin() + 512));
        CHECK(requests[1] == Bytes{30, 0, 0, 0, 0, 0});
    }
}

TEST_CASE("the reader says how many bytes it needs and takes no byte of the next request") {
    PacketReader reader;
    CHECK(reader.wanted() == 2);
    const Bytes bytes{8, 0, 11, 3};
    ByteView rest = ByteView(bytes).first(1);
    CHECK(reader.take(rest).empty());
    CHECK(reader.wanted() == 1);
    rest = ByteView(bytes).subspan(1);
    CHECK(reader.take(rest).empty());
    CHECK(reader.wanted() == 6);
    CHECK(reader.held() == 4);
    const Bytes end{0, 0, 0, 0, 0, 0, 6, 0};
    rest = end;
    CHECK(reader.take(rest).size() == 8);
    CHECK(rest.size() == 2);
    CHECK(reader.wanted() == 2);
}

TEST_CASE("a length that no packet has is refused") {
    for (std::size_t length = 0; length < 65536; ++length) {
        const Bytes bytes{static_cast<std::uint8_t>(length), static_cast<std::uint8_t>(length >> 8), 1, 2};
        const bool good = length % 2 == 0 && length >= 6 && length <= 510;
        if (refusal_of(bytes).empty() != good)
            FAIL("length " << length << ": " << refusal_of(bytes));
    }
    CHECK(refusal_of({7, 0}) == "request 1 to the host has the length 7; a length must be even, and from 6 to 510");
    CHECK(refusal_of({0, 2}) ==
          "request 1 to the host has the length 512; a length must be even, and from 6 to 510: the host "
          "serves version 1.0 of the protocol, which has no requests of this length");
    CHECK(refusal_of({0, 4}) == "request 1 to the host has the length 1024; a length must be even, and from 6 to 510");
    CHECK(refusal_of({6, 0, 1, 2, 3, 4, 5, 6, 4, 0, 9}) ==
          "request 2 to the host has the length 4; a length must be even, and from 6 to 510");
}

TEST_CASE("the first request of an AFserver program is refused by name") {
    CHECK(
        refusal_of({4, 0, 0, 0, 34, 0, 0, 0}) ==
        "the program's first request is of the older AFserver (alien file server) protocol; only programs for iserver "
        "can be served");
}

TEST_CASE("a reply is filled up to six bytes and an even length") {
    using iserver::Reply;
    using iserver::Result;
    CHECK(Reply(Result::failed).packet() == Bytes{6, 0, 129, 0, 0, 0, 0, 0});
    CHECK(Reply(Result::success).word(-2).packet() == Bytes{6, 0, 0, 0xfe, 0xff, 0xff, 0xff, 0});
    CHECK(Reply(Result::success).text("abcd").packet() == Bytes{8, 0, 0, 4, 0, 'a', 'b', 'c', 'd', 0});
    const Bytes longest = Reply(Result::success).text(std::string(iserver::longest_reply_text, 'x')).packet();
    CHECK(longest.size() == 512);
    CHECK(longest[0] == 254);
    CHECK(longest[1] == 1);
}

TEST_CASE("a field beyond the end of a request reads as nothing") {
    const Bytes request{10, 5, 0, 'a', 'b'};
    iserver::RequestFields fields(request);
    CHECK(fields.byte() == 10);
    CHECK(fields.good());
    CHECK(fields.text() == "");
    CHECK_FALSE(fields.good());
}
