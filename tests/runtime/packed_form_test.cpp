// Tests how messages travel to another copy of the program.

#include "runtime/channel.hpp"
#include "runtime/packed_form.hpp"
#include "runtime/time.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

using namespace placedpar;

namespace {

struct PackedLetter {
    std::vector<std::string> lines;
    std::optional<double> weight;
    std::variant<int, std::vector<bool>> content;
    std::shared_ptr<const std::vector<int>> enclosed;
    bool is_urgent = false;
    WireForm wire_form() const { return WireForm(1); }
};

struct Unstated {
    std::vector<int> numbers;
    WireForm wire_form() const { return WireForm(1); }
};

struct Plain {
    char letter = 'a';
    std::array<int, 3> numbers{};
    bool operator==(const Plain&) const = default;
};

template <class T>
MessageBytes packed_bytes(const T& value) {
    MessageBytes bytes;
    pack(value, bytes);
    return bytes;
}

template <class T>
bool comes_back(const T& value) {
    return unpack<T>(packed_bytes(value)) == value;
}

} // namespace

namespace placedpar {
template <>
struct PackedForm<PackedLetter>
    : PackedMembers<PackedLetter, &PackedLetter::lines, &PackedLetter::weight, &PackedLetter::content,
                    &PackedLetter::enclosed, &PackedLetter::is_urgent> {};
} // namespace placedpar

TEST_CASE("values come back as they were packed") {
    CHECK(comes_back(-5));
    CHECK(comes_back(2.5));
    CHECK(comes_back(true));
    CHECK(comes_back(Time(7)));
    CHECK(comes_back(Plain{'x', {1, 2, 3}}));
    CHECK(comes_back(std::vector<double>{}));
    CHECK(comes_back(std::vector<std::vector<short>>{{1, 2}, {}, {3}}));
    CHECK(comes_back(std::vector<bool>{true, false, true}));
    CHECK(comes_back(std::string("a line\0with a zero", 18)));
    CHECK(comes_back(std::optional<std::string>("there")));
    CHECK(comes_back(std::optional<std::string>()));
    CHECK(comes_back(std::variant<int, std::string, Plain>(Plain{'y', {4, 5, 6}})));
}

TEST_CASE("a structure packs the members that it names") {
    PackedLetter letter;
    letter.lines = {"Dear reader,", ""};
    letter.weight = 0.25;
    letter.content = std::vector<bool>{false, true};
    letter.enclosed = std::make_shared<const std::vector<int>>(std::vector<int>{9, 8});
    letter.is_urgent = true;
    const PackedLetter read = unpack<PackedLetter>(packed_bytes(letter));
    CHECK(read.lines == letter.lines);
    CHECK(read.weight == letter.weight);
    CHECK(read.content == letter.content);
    CHECK(*read.enclosed == *letter.enclosed);
    CHECK(read.is_urgent);
    CHECK(unpack<PackedLetter>(packed_bytes(PackedLetter())).enclosed == nullptr);
}

TEST_CASE("bytes that are no message are refused") {
    const MessageBytes whole = packed_bytes(PackedLetter{{"one", "two"}, 1.5, 3, nullptr, true});
    for (std::size_t length = 0; length < whole.size(); ++length)
        CHECK_THROWS_AS(unpack<PackedLetter>(std::span(whole).first(length)), NoMessage);
    MessageBytes longer = whole;
    longer.push_back(0);
    CHECK_THROWS_WITH_AS(unpack<PackedLetter>(longer), "further bytes follow the end of the message", NoMessage);
    CHECK_THROWS_WITH_AS(unpack<std::vector<int>>(MessageBytes{255, 255, 255, 255, 255, 255, 255, 255}),
                         "an array of 18446744073709551615 elements is longer than the message", NoMessage);
    using Either = std::variant<int, std::string>;
    CHECK_THROWS_AS(unpack<Either>(MessageBytes{2, 0, 0, 0, 0}), NoMessage);
}

TEST_CASE("a type that does not state how it is packed cannot travel") {
    CHECK(Packable<PackedLetter>);
    CHECK_FALSE(Packable<Unstated>);
    CHECK_FALSE(Packable<std::vector<Unstated>>);
    CHECK_FALSE(Packable<int*>);
    const Channel<PackedLetter> letters("letters");
    const Channel<Unstated> others("others");
    for (const AnyChannel* channel :
         {static_cast<const AnyChannel*>(&letters), static_cast<const AnyChannel*>(&others)})
        CHECK((channel->packed_form() != nullptr) == (channel == &letters));
}
