// Tests the bytes of messages, which programs in a transputer's own code move.

#include "runtime/byte_form.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

using namespace placedpar;

namespace {

template <class T>
MessageBytes bytes_of(const T& message) {
    MessageBytes bytes;
    ByteForm<T>::write(message, bytes);
    return bytes;
}

/// Returns the message of the bytes, which must be complete and must have the parts of its form on a wire.
template <class T>
T message_of_bytes(const MessageBytes& bytes) {
    std::vector<std::uint32_t> parts;
    std::size_t taken = 0;
    while (const std::uint32_t next = ByteForm<T>::next_part(std::span(bytes).first(taken))) {
        parts.push_back(next);
        taken += next;
        REQUIRE_LE(taken, bytes.size());
    }
    CHECK_EQ(taken, bytes.size());
    const T message = ByteForm<T>::read(bytes);
    const WireForm form = wire_form(message);
    std::vector<std::uint32_t> wanted;
    for (std::size_t part = 0; part < form.parts(); ++part)
        if (form[part] > 0)
            wanted.push_back(form[part]);
    CHECK_EQ(parts, wanted);
    return message;
}

template <class T>
void check_bytes(const T& message, const MessageBytes& bytes) {
    CHECK_EQ(bytes_of(message), bytes);
    CHECK(message_of_bytes<T>(bytes) == message);
}

struct OnlyTag {
    bool operator==(const OnlyTag&) const = default;
};
using CaseMessage = std::variant<std::int32_t, OnlyTag, std::vector<std::uint8_t>>;

struct TwoNumbers {
    std::int32_t a, b;
};

} // namespace

TEST_CASE("messages are written as occam's protocols write them") {
    check_bytes(std::int32_t{-2}, {0xfe, 0xff, 0xff, 0xff});
    check_bytes(std::uint8_t{200}, {200});
    check_bytes(true, {1});
    check_bytes(false, {0});
    check_bytes(std::int16_t{0x1234}, {0x34, 0x12});
    check_bytes(std::int64_t{0x0102030405060708}, {8, 7, 6, 5, 4, 3, 2, 1});
    check_bytes(1.0F, {0, 0, 0x80, 0x3f});
    check_bytes(-2.0, {0, 0, 0, 0, 0, 0, 0, 0xc0});
    check_bytes(std::array<std::int16_t, 3>{1, 2, 3}, {1, 0, 2, 0, 3, 0});
    check_bytes(std::vector<std::uint8_t>{7, 8, 9}, {3, 0, 0, 0, 7, 8, 9});
    check_bytes(std::vector<std::int32_t>{-1}, {1, 0, 0, 0, 0xff, 0xff, 0xff, 0xff});
    check_bytes(std::vector<bool>{true, false}, {2, 0, 0, 0, 1, 0});
    check_bytes(std::vector<double>{}, {0, 0, 0, 0});
    check_bytes(CaseMessage(std::int32_t{5}), {0, 5, 0, 0, 0});
    check_bytes(CaseMessage(OnlyTag{}), {1});
    check_bytes(CaseMessage(std::vector<std::uint8_t>{6}), {2, 1, 0, 0, 0, 6});
    CHECK(message_of_bytes<bool>({2}));
}

TEST_CASE("types whose bytes mean nothing to another program have no byte form") {
    CHECK_FALSE(HasByteForm<TwoNumbers>);
    CHECK_FALSE(HasByteForm<long double>);
    CHECK_FALSE(HasByteForm<std::vector<TwoNumbers>>);
    CHECK_FALSE(HasByteForm<std::variant<int, TwoNumbers>>);
    CHECK_FALSE(HasByteForm<std::string>);
    CHECK_FALSE(HasByteForm<int*>);
}

TEST_CASE("bytes that are no message are refused before anything is stored") {
    const auto count = [](std::int32_t value) { return bytes_of(value); };
    CHECK_THROWS_WITH_AS(ByteForm<std::vector<std::uint8_t>>::next_part(count(-1)), "an array cannot have -1 elements",
                         NoMessage);
    CHECK_EQ(ByteForm<std::vector<std::uint8_t>>::next_part(count(std::numeric_limits<std::int32_t>::max())),
             0x7fffffff);
    CHECK_THROWS_AS(ByteForm<std::vector<double>>::next_part(count(0x20000000)), NoMessage);
    CHECK_THROWS_WITH_AS(ByteForm<CaseMessage>::next_part(MessageBytes{3}), "no alternative has the tag 3", NoMessage);
    CHECK_THROWS_AS(ByteForm<CaseMessage>::next_part(MessageBytes{2, 0xff, 0xff, 0xff, 0xff}), NoMessage);
}
