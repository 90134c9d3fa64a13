// Reads damaged programs: each reading must end, and what is read without an error must be printable.

#include "occam/language/print.hpp"
#include "tests/occam/language/read_text.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <cctype>
#include <random>

using namespace placedpar;

namespace {

/// Splits a text into words, blanks and single other characters.
std::vector<std::string> pieces_of(const std::string& text) {
    std::vector<std::string> pieces;
    const auto kind = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) ? 1 : c == ' ' ? 2 : 0; };
    for (const char c : text)
        if (!pieces.empty() && kind(c) != 0 && kind(c) == kind(pieces.back().back()))
            pieces.back() += c;
        else
            pieces.emplace_back(1, c);
    return pieces;
}

std::vector<std::string> text_lines_of(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char c : text) {
        lines.back() += c;
        if (c == '\n')
            lines.emplace_back();
    }
    return lines;
}

/// Deletes, doubles or exchanges pieces.
std::string damaged(std::vector<std::string> pieces, std::mt19937_64& random) {
    for (std::size_t times = 1 + random() % 3; times > 0; --times) {
        const std::size_t one = random() % pieces.size(), other = random() % pieces.size();
        switch (random() % 3) {
        case 0: pieces[one].clear(); break;
        case 1: pieces[one] += pieces[one]; break;
        default: std::swap(pieces[one], pieces[other]);
        }
    }
    std::string text;
    for (const std::string& each : pieces)
        text += each;
    return text;
}

std::string with_random_bytes(std::string text, std::mt19937_64& random) {
    for (std::size_t times = 1 + random() % 20; times > 0; --times)
        text[random() % text.size()] = static_cast<char>(random());
    return text;
}

/// Reads a text. If it is good, its printed form is good too, and is printed in the same way.
void read_and_print(const std::string& text) {
    const auto read = test::read_text(text);
    CHECK(read.failed == (read.messages.find("error:") != std::string::npos));
    if (read.failed)
        return;
    const std::string printed = occam::print(*read.parsed.program);
    const auto again = test::read_text(printed);
    REQUIRE_MESSAGE(!again.failed, again.messages << "\n" << text);
    CHECK(occam::print(*again.parsed.program) == printed);
}

} // namespace

TEST_CASE("damaged programs of occam are read or refused") {
    for (const auto& file : test::occam_programs()) {
        const std::string text = test::whole_file(file);
        for (const auto seed : test::seeds(150)) {
            INFO(test::replay(seed), " ", file.string());
            std::mt19937_64 random(seed);
            read_and_print(damaged(pieces_of(text), random));
            read_and_print(damaged(text_lines_of(text), random));
            read_and_print(with_random_bytes(text, random));
        }
    }
}

TEST_CASE("bytes at random are refused") {
    for (const auto seed : test::seeds(300)) {
        INFO(test::replay(seed));
        std::mt19937_64 random(seed);
        std::string text(1 + random() % 400, ' ');
        for (char& each : text)
            each = random() % 3 == 0 ? static_cast<char>(random()) : "\n  ([:=*\"'#,ai0VALSEQ"[random() % 21];
        read_and_print(text);
    }
}
