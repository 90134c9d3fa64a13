#include "observe/page/encoding.hpp"

#include <doctest/doctest.h>
#include <zlib.h>

using namespace placedpar;
using namespace std::string_literals;

namespace {

std::string number_as_bytes(std::uint64_t number) {
    std::string bytes;
    page::append_number(bytes, number);
    return bytes;
}

} // namespace

TEST_CASE("a number takes the fewest bytes") {
    CHECK(number_as_bytes(0) == "\0"s);
    CHECK(number_as_bytes(127) == "\x7f");
    CHECK(number_as_bytes(128) == "\x80\x01");
    CHECK(number_as_bytes(300) == "\xac\x02");
    CHECK(number_as_bytes(1ull << 62).size() == 9);
}

TEST_CASE("bytes are encoded as text") { // RFC 4648, section 10
    CHECK(page::base64("").empty());
    CHECK(page::base64("f") == "Zg==");
    CHECK(page::base64("fo") == "Zm8=");
    CHECK(page::base64("foo") == "Zm9v");
    CHECK(page::base64("foobar") == "Zm9vYmFy");
    CHECK(page::base64("\xff\xfe\0"s) == "//4A");
}

TEST_CASE("compressed data are smaller and can be restored") {
    std::string bytes(10'000, 'a'), packed = page::deflated(bytes), back(bytes.size(), '\0');
    CHECK(packed.size() < 100);
    uLongf size = back.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(back.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                       packed.size()) == Z_OK);
    CHECK(back == bytes);
}
