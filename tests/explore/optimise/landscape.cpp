#include "tests/explore/optimise/landscape.hpp"

#include "explore/study/sweep.hpp"
#include "runtime/random.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>

namespace placedpar {

namespace {

std::string table(RandomStream& random, std::size_t entries) {
    std::vector<std::uint32_t> numbers(entries);
    for (std::uint32_t& number : numbers)
        number = random.below(1000);
    return fmt::format("{{{}}}", fmt::join(numbers, ", "));
}

} // namespace

std::string Landscape::netlist() const {
    RandomStream random(seed, "landscape");
    std::string text, sum = "1";
    for (std::size_t i = 0; i < vals; ++i)
        text += fmt::format("val v{} 0;\nval table{} {};\n", i, i, table(random, values * values));
    for (std::size_t i = 0; i < vals; ++i)
        sum += fmt::format(" + table{}[{} * v{} + v{}]", i, values, i, (i + 1) % vals);
    text += fmt::format("T800 t;\nprocess source, sink;\nuse \"csp.producer\" for source;\n"
                        "use \"csp.consumer\" for sink;\nsource (count = 1, cycles = {});\nsink (count = 1);\n"
                        "place source on t;\nplace sink on t;\nconnect source.out to sink.in;\n",
                        sum);
    if (four_links)
        text += "if v0 + v1 > 0 {\n    T800 far;\n    rep i = 0 for v0 + v1\n        connect t.link[i] to "
                "far.link[i];\n}\n";
    return text;
}

LandscapeSearch::LandscapeSearch(const std::string& folder, const Landscape& landscape, const StudySearch& search,
                                 const std::string& where, std::size_t workers) {
    study_.netlist = folder + "/landscape.cfs";
    std::ofstream(study_.netlist) << landscape.netlist();
    study_.products.emplace_back();
    for (std::size_t i = 0; i < landscape.vals; ++i)
        study_.products[0].axes.push_back(read_axis(fmt::format("v{}=0..{}", i, landscape.values - 1)));
    study_.products[0].where = StudyExpression(where);
    study_.search = search;
    space_.emplace(study_);
    results_.emplace(folder + "/landscape.sqlite", source_of(study_, readable_network(study_)));
    trials_.emplace(study_, *space_, *results_, workers, interruption_);
}

} // namespace placedpar
