// Compares the netlists that are made of configurations with known ones, and runs of configurations with those of their
// printed netlists.

#include "tests/occam/configuration/configured_text.hpp"
#include "tests/occam/language/read_text.hpp"
#include "tests/occam/network/network_text.hpp"

#include "netlist/print/print.hpp"
#include "tests/occam/language/print.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

namespace {

const char* const parts = R"(#INCLUDE "hostio.inc"
PROC sender (VAL INT number, CHAN OF INT out)
  out ! number
:
PROC printer (CHAN OF SP fs, ts, CHAN OF INT in)
  #USE "hostio.lib"
  INT x:
  SEQ
    in ? x
    so.write.int (fs, ts, x, 0)
    so.exit (fs, ts, sps.success)
:
)";

const char* const pair = R"(NODE a, b:
ARC hostlink:
NETWORK
  DO
    SET a (type, memsize := "T800", 65536)
    SET b (type, memsize := "T800", 65536)
    CONNECT a[link][0] TO HOST WITH hostlink
    CONNECT a[link][1] TO b[link][1]
:
#INCLUDE "hostio.inc"
#USE "parts.c8h"
CONFIG
  CHAN OF SP fs, ts:
  PLACE fs, ts ON hostlink:
  CHAN OF INT c:
  PAR
    PROCESSOR a
      printer (fs, ts, c)
    PROCESSOR b
      sender (42, c)
:
)";

} // namespace

TEST_CASE("configurations become the netlists that they describe") {
    for (const char* const name : {"network.pgm", "values.pgm", "classic.occ"}) {
        const auto file = test::occam_path("configuration/forms") / name;
        CAPTURE(name);
        const test::MadeText made = test::made_from(file);
        CHECK(made.messages == "");
        CHECK(made.netlist == test::whole_file(std::filesystem::path(file).replace_extension(".cfs")));
    }
}

TEST_CASE("a configuration is printed as it is read") {
    for (const char* const name : {"network.pgm", "values.pgm", "classic.occ"}) {
        const std::string text = test::whole_file(test::occam_path("configuration/forms") / name);
        const auto without_files = [](std::string all) {
            for (auto at = all.find("\n#"); at != all.npos; at = all.find("\n#"))
                all.erase(at, all.find('\n', at + 1) - at);
            return all;
        };
        const auto first = test::read_text(without_files("\n" + text), name);
        CHECK_FALSE(first.failed);
        const std::string printed = occam::print(*first.parsed.program);
        const auto second = test::read_text(printed, name);
        CHECK_FALSE(second.failed);
        CHECK(occam::print(*second.parsed.program) == printed);
        for (const char* const word : {"PLACED PAR", "CONNECT", "PRI HIGH", "PLACE c", "root :="})
            CHECK((text.find(word) == text.npos) == (printed.find(word) == printed.npos));
    }
}

TEST_CASE("a configuration runs, and its printed netlist runs the same") {
    const test::FilesOfNetwork files({{"parts.occ", parts}, {"pair.pgm", pair}});
    const Catalogue catalogue = test::occam_catalogue();
    const auto options = test::configuration_options();
    const test::RunOfNetwork run = test::run_network(files.path("pair.pgm"), catalogue, {}, options);
    CHECK(run.screen == "42");
    const ReadResult read = read_netlist(files.path("pair.pgm"), catalogue, {}, options);
    REQUIRE(read.network);
    files.write("pair.cfs", print_cfs(*read.network));
    const test::RunOfNetwork printed = test::run_network(files.path("pair.cfs"), catalogue);
    CHECK(printed.screen == "42");
    CHECK(printed.report.result.fingerprint == run.report.result.fingerprint);
    CHECK(read_netlist(files.path("pair.cfs"), catalogue).network->hash == read.network->hash);
    CHECK(read.network->included_paths == std::vector{files.path("parts.occ").string()});
}

TEST_CASE("parameters of the processes of a configuration can be set") {
    const test::FilesOfNetwork files({{"parts.occ", parts}, {"pair.pgm", pair}});
    const Catalogue catalogue = test::occam_catalogue();
    const auto options = test::configuration_options();
    CHECK(test::run_network(files.path("pair.pgm"), catalogue, {{"sender.number", "-3"}}, options).screen == "-3");
}

TEST_CASE("names that a netlist cannot have are changed") {
    std::string text = pair;
    for (const auto& [from, to] :
         {std::pair("NODE a, b", "NODE host, process.t"), std::pair("SET a", "SET host"),
          std::pair("SET b", "SET process.t"), std::pair("CONNECT a", "CONNECT host"),
          std::pair("CONNECT a", "CONNECT host"), std::pair("TO b", "TO process.t"),
          std::pair("PROCESSOR a", "PROCESSOR host"), std::pair("PROCESSOR b", "PROCESSOR process.t")})
        text.replace(text.find(from), std::string(from).size(), to);
    const test::FilesOfNetwork files({{"parts.occ", parts}, {"pair.pgm", text}});
    CHECK(test::made_from(files.path("pair.pgm"))
              .netlist.starts_with("T800 (memory = 64K) host_2;\n"
                                   "T800 (memory = 64K) process_t;\n"));
    const Catalogue catalogue = test::occam_catalogue();
    CHECK(test::run_network(files.path("pair.pgm"), catalogue, {}, test::configuration_options()).screen == "42");
}
