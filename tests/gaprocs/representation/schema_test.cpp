#include "gaprocs/representation/schema.hpp"

#include <doctest/doctest.h>

#include <set>
#include <stdexcept>

using namespace placedpar;

TEST_CASE("the schema of equation 6.1 matches the thesis's strings and has its order and length") {
    Schema common = Schema::from_string("11****11");
    for (const char* text : {"11100011", "11011011", "11011111"})
        CHECK(common.matches(Genome::from_string(text)));
    CHECK_FALSE(common.matches(Genome::from_string("11100001")));
    CHECK(common.defining_length() == 7);
    CHECK(common.order() == 4);
    CHECK(Schema::from_string("10*11**1").defining_length() == 7);
    CHECK(common.to_string() == "11****11");
}

TEST_CASE("schemata may have no fixed position, one, or more positions than a word") {
    Schema all = Schema::from_string("***");
    CHECK(all.order() == 0);
    CHECK(all.defining_length() == 0);
    CHECK(all.matches(Genome::from_string("010")));
    CHECK(Schema::from_string("*1*").defining_length() == 0);
    Schema longer = Schema::from_string("0" + std::string(98, '*') + "1");
    CHECK(longer.defining_length() == 99);
    Genome string(100);
    CHECK_FALSE(longer.matches(string));
    string.flip(99);
    CHECK(longer.matches(string));
    CHECK_THROWS_AS(Schema::from_string("01x"), std::invalid_argument);
    CHECK_THROWS_AS(Schema::from_string(""), std::invalid_argument);
}

TEST_CASE("there are C(l, o) 2^o schemata of order o, and every string matches C(l, o) of them") {
    const std::size_t chosen[]{1, 4, 6, 4, 1};
    Genome string = Genome::from_string("0110");
    for (std::size_t order = 0; order <= 4; ++order) {
        auto schemata = schemata_of_order(4, order);
        CHECK(schemata.size() == chosen[order] << order);
        std::size_t had = 0;
        for (const Schema& schema : schemata) {
            CHECK(schema.order() == order);
            had += count_matches(schema, {&string, 1});
        }
        CHECK(had == chosen[order]);
    }
}
