// Reads mutated netlists: each reading must end, in a network or in an error.

#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/numbers.hpp"
#include "tests/netlist/small_catalogue.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the netlists sorted by file name, whatever their folders.
std::vector<std::filesystem::path> netlists_below(const std::string& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (auto extension = entry.path().extension(); extension == ".cfs" || extension == ".CFS")
            paths.push_back(entry.path());
    std::ranges::sort(paths, {}, [](const auto& path) { return path.filename(); });
    return paths;
}

constexpr std::size_t good_seeds = 7;

/// Returns the tests' netlists, the good netlists first.
std::vector<std::string> seeds() {
    auto paths = netlists_below(netlist_folder() + "/good");
    for (const char* others : {"/refusals", "/files"})
        std::ranges::move(netlists_below(netlist_folder() + others), std::back_inserter(paths));
    std::vector<std::string> texts;
    for (const auto& path : paths) {
        std::ifstream in(path, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return texts;
}

/// Splits a text into words and single other characters, for moving them about.
std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> result;
    for (char c : text) {
        bool joins = !result.empty() && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') &&
                     std::isalnum(static_cast<unsigned char>(result.back().back())) != 0;
        if (joins)
            result.back() += c;
        else
            result.emplace_back(1, c);
    }
    return result;
}

std::string mutate(const std::string& text, const std::vector<std::string>& others, Numbers& numbers) {
    static const std::vector<std::string> spice{"0",
                                                "-1",
                                                "9223372036854775807",
                                                "1M",
                                                "2.5",
                                                "\"x\"",
                                                "{",
                                                "}",
                                                "(",
                                                ")",
                                                "[",
                                                "]",
                                                ";",
                                                ",",
                                                ".",
                                                "rep i = 0 for 3 ",
                                                "if ",
                                                "{1,2}",
                                                "host",
                                                "sw",
                                                "#include \"x\"\n",
                                                "/*",
                                                "'",
                                                "\xff",
                                                "\xe2\x80\x93",
                                                "\x1a",
                                                "\r\n",
                                                "\n",
                                                "#INCLUDE \"..\\X\"\n",
                                                "\nPLACED PAR\n",
                                                "procces ",
                                                "T800",
                                                " / 0",
                                                "highprocess",
                                                "define process (priority = 0) ",
                                                "node (element = \"process\")",
                                                "PROCESSOR (type = \"b404\")",
                                                "rep i = 0 to 2 ",
                                                "1 ? 2 : ",
                                                "size(",
                                                "~",
                                                " << 3",
                                                " & 6 ^ 1 | ",
                                                "017",
                                                "09",
                                                "char n[2][3]",
                                                "{{\"a\", \"b\"}}",
                                                "interface (short s, input in)"};
    auto pieces = words(text);
    for (auto changes = 1 + numbers.below(3); changes > 0 && !pieces.empty(); --changes) {
        auto at = numbers.below(pieces.size());
        auto place = pieces.begin() + static_cast<std::ptrdiff_t>(at);
        switch (numbers.below(5)) {
        case 0: pieces.erase(place); break;
        case 1: pieces.insert(place, pieces[numbers.below(pieces.size())]); break;
        case 2: *place = spice[numbers.below(spice.size())]; break;
        case 3: std::swap(*place, pieces[numbers.below(pieces.size())]); break;
        default: {
            auto foreign = words(others[numbers.below(others.size())]);
            if (!foreign.empty())
                *place = foreign[numbers.below(foreign.size())];
        }
        }
    }
    std::string result;
    for (const auto& piece : pieces)
        result += piece;
    return result;
}

} // namespace

TEST_CASE("reading a mutated netlist ends") {
    const auto texts = seeds();
    REQUIRE(texts.size() > 60);
    constexpr int mutations = 10000;
    int networks = 0;
    for (std::uint64_t number : test::seeds(mutations)) {
        INFO(test::replay(number));
        Numbers numbers(number);
        const auto& seed = texts[numbers.below(2) == 0 ? numbers.below(good_seeds) : numbers.below(texts.size())];
        auto text = mutate(seed, texts, numbers);
        auto result = read_netlist_text(text, small_catalogue());
        auto errors = std::count_if(result.diagnostics.begin(), result.diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::error; });
        if (result.network.has_value() != (errors == 0) || errors > 20)
            FAIL(text);
        auto rendered = render(result.diagnostics);
        if (errors > 0 && rendered.find("error: ") == std::string::npos)
            FAIL("says nothing:\n" << text);
        if (!result.network)
            continue;
        ++networks;
        auto printed = print_cfs(*result.network);
        auto again = read_netlist_text(printed, small_catalogue());
        if (!again.network || print_cfs(*again.network) != printed)
            FAIL("does not load again:\n" << text << "\nprinted:\n" << printed << render(again.diagnostics));
        print_dot(*result.network);
        boost::json::parse(print_json(*result.network)); // throws if it is not JSON
    }
    if (test::all_seeds())
        CHECK(networks > mutations / 40); // otherwise the mutations are too wild to reach the printers
}
