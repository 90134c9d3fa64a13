// Checks small programs, each about one rule. The files say whether they are accepted: "== accepted: name". INMOS's
// compiler of 1991 decides in the same way, but for programs that are accepted or refused "here"; tests/app compares.

#include "tests/occam/check/check_text.hpp"
#include "tests/occam/language/read_text.hpp"

#include <doctest/doctest.h>

#include <sstream>

using namespace placedpar;

namespace {

struct VerdictCase {
    std::string verdict, name, text;
};

std::vector<VerdictCase> verdict_cases(const std::string& file) {
    std::vector<VerdictCase> cases;
    std::istringstream in(test::whole_file(file));
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("== ")) {
            const std::size_t colon = line.find(": ");
            cases.push_back({line.substr(3, colon - 3), line.substr(colon + 2), ""});
        } else {
            cases.back().text += line + "\n";
        }
    }
    return cases;
}

} // namespace

TEST_CASE("small programs are accepted or refused as the language says") {
    std::size_t count = 0;
    for (const auto& file : test::occam_files(test::occam_path("check/verdicts"), ".txt")) {
        for (const VerdictCase& each : verdict_cases(file)) {
            const test::CheckedText checked = test::check_text(each.text);
            INFO(each.name << ":\n" << each.text << checked.messages);
            CHECK(checked.failed == each.verdict.starts_with("refused"));
            CHECK(checked.errors <= 3);
            ++count;
        }
    }
    CHECK(count > 250);
}

TEST_CASE("the usage and the alias check can be switched off") {
    const std::string parallel = "PROC p ()\n  INT x:\n  PAR\n    x := 1\n    x := 2\n:\n";
    const std::string alias = "PROC p ()\n  INT x:\n  y IS x:\n  x := 2\n:\n";
    CHECK(test::check_text(parallel).failed);
    CHECK(!test::check_text("#OPTION \"N\"\n" + parallel).failed);
    CHECK(test::check_text(alias).failed);
    CHECK(!test::check_text("#OPTION \"A\"\n" + alias).failed);
}
