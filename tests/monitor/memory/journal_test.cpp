#include "monitor/memory/journal.hpp"
#include "scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::monitor;

TEST_CASE("CRC-32 as everybody else counts it") {
    Scratch scratch;
    Journal journal(scratch / "j");
    journal.begin(1);
    journal.append("123456789");
    CHECK(scratch.read("j").find("\ncbf43926 123456789\n") != std::string::npos); // the check value of CRC-32
}

TEST_CASE("records come back in order, after their epoch") {
    Scratch scratch;
    {
        Journal journal(scratch / "j");
        CHECK(journal.read().records.empty());
        journal.begin(7);
        journal.append("one");
        journal.append("two words");
        journal.append("");
        CHECK(journal.bytes() == scratch.read("j").size());
    }
    JournalContent content = Journal(scratch / "j").read();
    CHECK(content.epoch == 7);
    CHECK(content.records == std::vector<std::string>{"one", "two words", ""});
    CHECK(content.damaged_bytes == 0);
}

TEST_CASE("a journal cut anywhere keeps every whole record and no other") {
    Scratch scratch;
    std::string whole;
    {
        Journal journal(scratch / "j");
        journal.begin(3);
        for (const char* record : {"first", "second", "third"})
            journal.append(record);
        whole = scratch.read("j");
    }
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        scratch.write("j", whole.substr(0, size));
        JournalContent content = Journal(scratch / "j").read();
        std::size_t lines = static_cast<std::size_t>(
            std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size), '\n'));
        CAPTURE(size);
        CHECK(content.records.size() == (lines > 0 ? lines - 1 : 0));
        CHECK(content.good_bytes + content.damaged_bytes == size);
        CHECK(content.epoch == (lines > 0 ? 3 : 0));
    }
}

TEST_CASE("any flipped bit is seen, and what follows it is left out") {
    Scratch scratch;
    std::string whole;
    {
        Journal journal(scratch / "j");
        journal.begin(3);
        journal.append("first");
        journal.append("second");
        whole = scratch.read("j");
    }
    for (std::size_t bit = 0; bit < whole.size() * 8; bit += 5) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        scratch.write("j", flipped);
        JournalContent content = Journal(scratch / "j").read();
        CAPTURE(bit);
        CHECK(content.records.size() < 2);
        CHECK(content.damaged_bytes > 0);
    }
}

TEST_CASE("a cut journal can be gone on with") {
    Scratch scratch;
    {
        Journal journal(scratch / "j");
        journal.begin(1);
        journal.append("kept");
    }
    std::string whole = scratch.read("j");
    scratch.write("j", whole + "0123");
    Journal journal(scratch / "j");
    journal.truncate(journal.read().good_bytes);
    journal.append("next");
    CHECK(journal.read().records == std::vector<std::string>{"kept", "next"});
    CHECK(journal.read().damaged_bytes == 0);
}

TEST_CASE("one at a time") {
    Scratch scratch;
    Journal journal(scratch / "j");
    CHECK_THROWS_WITH_AS(Journal(scratch / "j"), doctest::Contains("another placedpar monitor"), UserError);
    CHECK_THROWS_WITH_AS(Journal(scratch / "none" / "j"), doctest::Contains("cannot be opened"), UserError);
}
