// Tests the kinds that are made of files in occam.

#include "occam/network/file_kinds.hpp"
#include "tests/occam/network/network_text.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <string>

using namespace placedpar;

namespace {

/// Returns the kind of a file in the folder.
const ProcessKind* kind_of_file(FileKinds& files, const test::FilesOfNetwork& folder, const std::string& name,
                                Reporter& reporter) {
    return files.find(files.read(folder.path(name).string(), {}, {}, reporter));
}

} // namespace

TEST_CASE("a kind has the ports and parameters of the last PROC, or of a named one") {
    const std::map<std::string, std::string> all = {{"all.occ", R"(
#INCLUDE "hostio.inc"
PROTOCOL P
  CASE
    stop
    go; INT; [4]BYTE
:
PROC first (CHAN OF INT c)
  c ! 1
:
PROC last (CHAN OF SP fs, ts, CHAN OF INT::[]BYTE to.right, [3]CHAN OF P in, []CHAN BYTE out!, VAL INT n.max, VAL REAL32 r,
           VAL BOOL on, VAL []BYTE name, CHAN OF BYTE screen)
  INT length:
  [10]BYTE some:
  SEQ
    to.right ! 3::"abc"
    in[0] ? CASE
      stop
        SKIP
      go; length; [some FOR 4]
        SKIP
:
)"}};
    const test::FilesOfNetwork folder(all);
    const auto files = occam::make_file_kinds();
    Reporter reporter;
    const ProcessKind* kind = kind_of_file(*files, folder, "all.occ", reporter);
    INFO(render(reporter.take()));
    REQUIRE(kind);
    CHECK(kind->is_code);
    REQUIRE(kind->ports.size() == 6);
    CHECK(kind->ports[0].to_host);
    CHECK(kind->ports[0].direction == Direction::input);
    CHECK(kind->ports[1].direction == Direction::output);
    CHECK(kind->ports[2].name == "to_right");
    CHECK(kind->ports[2].direction == Direction::output);
    CHECK(kind->ports[2].protocol == "INT::[]BYTE");
    CHECK_FALSE(kind->ports[2].optional);
    CHECK(kind->ports[3].direction == Direction::input);
    CHECK(kind->ports[3].elements == 3);
    CHECK(kind->ports[3].protocol == "P CASE stop, go; INT; [4]BYTE");
    CHECK(kind->ports[4].direction == Direction::output);
    CHECK(kind->ports[4].elements == 0);
    CHECK(kind->ports[5].to_host);
    REQUIRE(kind->parameters.size() == 4);
    CHECK(kind->parameters[0].name == "n_max");
    CHECK(*kind->parameters[0].least == -2147483648.0);
    CHECK(kind->parameters[1].type == ParameterType::real);
    CHECK(*kind->parameters[2].most == 1);
    CHECK(kind->parameters[3].type == ParameterType::text);
    const ProcessKind* first = kind_of_file(*files, folder, "all.occ#first", reporter);
    REQUIRE(first);
    CHECK(first->ports.size() == 1);
    CHECK(kind_of_file(*files, folder, "all.occ", reporter) == kind); // the file is read once
}

TEST_CASE("a file is found beside the netlist first, then in the folders") {
    const test::FilesOfNetwork beside({{"a.occ", "PROC beside (CHAN OF INT c)\n  c ! 1\n:\n"}, {"a.cfs", ""}});
    const test::FilesOfNetwork other(
        {{"a.occ", "PROC other (CHAN OF INT d)\n  d ! 1\n:\n"}, {"b.occ", "PROC other (CHAN OF INT e)\n  e ! 1\n:\n"}});
    const auto files = occam::make_file_kinds();
    Reporter reporter;
    const Location named{std::make_shared<const SourceFile>(beside.path("a.cfs").string(), ""), 1, 1};
    const auto port = [&](const std::string& name) {
        const ProcessKind* kind = files->find(files->read(name, named, {other.path("")}, reporter));
        return kind ? kind->ports.front().name : "";
    };
    CHECK(port("a.occ") == "c");
    CHECK(port("b.occ") == "e");
    CHECK_FALSE(reporter.failed());
    CHECK(port("c.occ").empty());
    CHECK(reporter.failed());
}
