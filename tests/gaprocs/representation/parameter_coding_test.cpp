#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/parameter_coding.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

using namespace placedpar;

TEST_CASE("a field of bits is decoded to low + (high - low) n / 2^bits") {
    ParameterField field{-1, 3, 4}; // eq. 1.5: steps of a quarter
    CHECK(field.value(0) == -1);
    CHECK(field.value(1) == -0.75);
    CHECK(field.value(8) == 1);
    CHECK(field.value(15) == 2.75); // the range excludes its upper end
    CHECK(field.codes() == 16);
    CHECK(field.resolution() == 0.25);
}

TEST_CASE("fields of different lengths are decoded one after another") {
    ParameterCoding coding({{0, 8, 3}, {-1, 1, 1}, {0, 0.1, 12}});
    CHECK(coding.parameters() == 3);
    CHECK(coding.bits() == 16);
    Genome genome = Genome::from_string("101"
                                        "1"
                                        "100000000000");
    CHECK(coding.value(genome, 0) == 5);
    CHECK(coding.value(genome, 1) == 0);
    CHECK(coding.value(genome, 2) == 0.05);
    CHECK(coding.decode(genome) == std::vector<double>{5, 0, 0.05});
}

TEST_CASE("four compliances of 20 bits are decoded across words") {
    ParameterCoding coding(4, {0, 1, 20});
    CHECK(coding.bits() == 80);
    Genome genome(80);
    genome.set_field(60, 20, 1u << 19);
    CHECK(coding.decode(genome) == std::vector<double>{0, 0, 0, 0.5});
    genome.set_field(0, 20, (1u << 20) - 1);
    CHECK(coding.value(genome, 0) == 1 - 0x1p-20);
}

TEST_CASE("neighbouring codes of the longest field have different values") {
    ParameterField field{0, 1, ParameterCoding::most_bits};
    auto last = (std::uint64_t{1} << ParameterCoding::most_bits) - 1;
    CHECK(field.value(last) < 1);
    CHECK(field.value(last - 1) < field.value(last));
}

TEST_CASE("impossible codings are refused with the number of the parameter") {
    auto refused = [](std::vector<ParameterField> fields, const char* message) {
        CHECK_THROWS_WITH_AS(ParameterCoding(std::move(fields)), message, std::invalid_argument);
    };
    refused({}, "a binary string must code at least one parameter");
    refused({{0, 1, 10}, {0, 1, 0}}, "parameter 1: 0 bits, expected 1 to 52");
    refused({{0, 1, 53}}, "parameter 0: 53 bits, expected 1 to 52");
    refused({{1, 1, 10}}, "parameter 0: the range is 1 to 1, expected two finite numbers, the lower number first");
    refused({{0, std::numeric_limits<double>::infinity(), 10}},
            "parameter 0: the range is 0 to inf, expected two finite numbers, the lower number first");
    refused({{std::numeric_limits<double>::quiet_NaN(), 1, 10}},
            "parameter 0: the range is nan to 1, expected two finite numbers, the lower number first");
    refused({{-1.5e308, 1.5e308, 10}},
            "parameter 0: the width of the range -1.5e+308 to 1.5e+308 is beyond the range of a double");
}
