// Tests the fields of a string in natural binary: equation 1.5 of the thesis.

#include "report/string_fields.hpp"

#include "gaprocs/representation/parameter_coding.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

/// A number in the range [-1, 3) in five bits, and an integer from 2 to 5 in two bits.
struct TwoFields {
    ParameterCoding coding() const {
        return ParameterCoding({{.low = -1, .high = 3, .bits = 5}, {.low = 2, .high = 6, .bits = 2, .whole = true}});
    }
    std::size_t bits() const { return 7; }
    std::size_t channels() const { return 1; }
    template <typename G>
    double error(const G& genome, std::span<const double> sample) const {
        return sample[0] - decode(genome)[0];
    }
    template <typename G>
    std::vector<double> decode(const G& genome) const {
        return coding().decode(genome);
    }
    std::vector<std::string> parameter_names() const { return {"gain", "delay"}; }
    std::vector<std::string> parameter_units() const { return {"V", ""}; }
};

} // namespace

TEST_CASE("a field's codes reach from the lower bound to one step below the upper bound") {
    for (Coding coding : {Coding::natural, Coding::gray}) { // all ones mean another number in Gray code
        const std::vector<StringField> fields = string_fields(*make_search_problem(TwoFields(), coding));
        REQUIRE(fields.size() == 2);
        CHECK(fields[0].name == "gain");
        CHECK(fields[0].unit == "V");
        CHECK(fields[0].least == -1);
        CHECK(fields[0].most == 3 - 4.0 / 32);
        CHECK(fields[0].step() == 4.0 / 32);
        CHECK(fields[1].bits == 2);
        CHECK(fields[1].least == 2);
        CHECK(fields[1].most == 5);
        CHECK(fields[1].step() == 1);
    }
}

TEST_CASE("fields that differ only in names are printed as one") {
    const StringField field{"x_1", "V", 5, -1, 3};
    CHECK(field.is_like({"x_2", "V", 5, -1, 3}));
    CHECK_FALSE(field.is_like({"x_1", "mV", 5, -1, 3}));
    CHECK_FALSE(field.is_like({"x_1", "V", 6, -1, 3}));
    CHECK_FALSE(field.is_like({"x_1", "V", 5, 0, 3}));
    CHECK_FALSE(field.is_like({"x_1", "V", 5, -1, 4}));
}
