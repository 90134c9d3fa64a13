// Tests files from DOS, their included files, and the search for included files.

#include "netlist/read.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace placedpar;

namespace {

std::filesystem::path file(const std::string& name) { return netlist_folder() + "/files/" + name; }

/// Returns the memory of the only node, which the included file states.
std::int64_t memory_of(const ReadResult& result) {
    INFO(render(result));
    REQUIRE(result.network);
    REQUIRE(result.network->nodes.size() == 1);
    return result.network->nodes[0].integer("memory");
}

/// A folder for one test, deleted at the end.
struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "placedpar_files_test";
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }

    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path / name).parent_path());
        std::ofstream(path / name, std::ios::binary) << text;
    }
    ReadResult read(const std::vector<std::filesystem::path>& include_folders = {}) const {
        return read_netlist(path / "main.cfs", small_catalogue(), {}, {.include_folders = include_folders});
    }
};

constexpr const char* main_text = "#include \"size.inc\"\nT800 (memory = size) a;\n";

} // namespace

TEST_CASE("files from DOS are read: capital letters, backslashes, carriage returns, text after Ctrl-Z") {
    auto result = read_netlist(file("FROMDOS.CFS"), small_catalogue());
    CHECK(memory_of(result) == 2 * 1024 * 1024);
    CHECK(result.network->processes[0].stand_in);
    CHECK(result.network->processes[0].kind == "MASTER.LKU");
    REQUIRE(result.network->included_paths.size() == 2);
    CHECK(result.network->included_paths[1].ends_with("dos/SUB/SIZE.INC"));
}

TEST_CASE("an included file is searched for beside the including file, then along the include path in order") {
    CHECK_FALSE(read_netlist(file("on_the_path.cfs"), small_catalogue()).network);
    auto along = read_netlist(file("on_the_path.cfs"), small_catalogue(), {},
                              {.include_folders = {file("dos"), file("dos/SUB")}});
    CHECK(memory_of(along) == 2 * 1024 * 1024);
    Folder folder;
    folder.write("main.cfs", main_text);
    folder.write("one/size.inc", "val size 1M;");
    folder.write("two/size.inc", "val size 2M;");
    CHECK(memory_of(folder.read({folder.path / "one", folder.path / "two"})) == 1024 * 1024);
    CHECK(memory_of(folder.read({folder.path / "none", folder.path / "two"})) == 2 * 1024 * 1024);
    folder.write("size.inc", "val size 4M;");
    CHECK(memory_of(folder.read({folder.path / "one"})) == 4 * 1024 * 1024);
}

TEST_CASE("if file names differ only in case, the exact name is preferred, then the first name in order") {
    Folder folder;
    folder.write("main.cfs", main_text);
    folder.write("size.INC", "val size 2M;");
    folder.write("SIZE.inc", "val size 1M;");
    CHECK(memory_of(folder.read()) == 1024 * 1024);
    folder.write("size.inc", "val size 4M;");
    CHECK(memory_of(folder.read()) == 4 * 1024 * 1024);
}

TEST_CASE("the message about a missing include names the folders that were searched") {
    Folder folder;
    folder.write("main.cfs", main_text);
    auto result = folder.read({"one", "two/three"});
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].hint == "looked in the folder of the including file and in one, two/three");
}

TEST_CASE("the toolset's own includes may be missing, but existing files are read") {
    Folder folder;
    folder.write("main.cfs", "#include \"SETCONF.INC\"\n#include \"c:\\icc\\boards.inc\"\n#include <trams.inc>\n"
                             "T800 (memory = 1M) a;\n");
    CHECK_FALSE(folder.read().network);
    folder.write("main.cfs", "#include \"SETCONF.INC\"\n#include \"c:\\icc\\boards.inc\"\nT800 (memory = 1M) a;\n");
    CHECK(memory_of(folder.read()) == 1024 * 1024);
    folder.write("setconf.inc", "define T800 (memory = 4M) B777;");
    folder.write("main.cfs", "#include \"setconf.inc\"\nB777 a;\n");
    CHECK(memory_of(folder.read()) == 4 * 1024 * 1024);
}

TEST_CASE("every suffix of a program file is accepted, in either case, and so is a name without suffix") {
    for (const char* name : {"p.lku", "P.LKU", "p.c8x", "p.c8h", "P.C4H", "p.c0", "p.tco", "p.lah", "p", "PROGRAM"}) {
        auto text = std::string("T800 a; process p; use \"") + name + "\" for p; place p on a;";
        CAPTURE(name);
        CHECK(read_netlist_text(text, small_catalogue()).network);
    }
    for (const char* name : {"p.exe", "ga.mastr", "pmup", "p.q8h"}) {
        auto text = std::string("T800 a; process p; use \"") + name + "\" for p; place p on a;";
        CAPTURE(name);
        CHECK_FALSE(read_netlist_text(text, small_catalogue()).network);
    }
}

TEST_CASE("--use runs kinds instead of programs") {
    std::string text = "T800 a; process p, q; use \"PUMP.LKU\" for p; use \"sink.lku\" for process;\n"
                       "place p on a; place q on a; connect p.out to q.in;";
    CHECK(render(read_netlist_text(text, small_catalogue())).find("has no channel") != std::string::npos);
    ProgramKinds kinds{{"PUMP.LKU", "pump"}, {"sink.lku", "sink"}};
    auto result = read_netlist_text(text, small_catalogue(), {}, "n.cfs", {.include_folders = {}, .programs = kinds});
    INFO(render(result));
    REQUIRE(result.network);
    CHECK(result.network->processes[0].kind == "pump");
    CHECK(result.network->processes[1].kind == "sink");
    CHECK_FALSE(result.network->processes[1].stand_in);
}

TEST_CASE("an unused program and an unknown kind are refused with the existing names") {
    auto said = [](const ProgramKinds& kinds) {
        auto text =
            "T800 a; process p, q; use \"pump.lku\" for p; use \"other.lku\" for q; place p on a; place q on a;";
        return render(
            read_netlist_text(text, small_catalogue(), {}, "n.cfs", {.include_folders = {}, .programs = kinds}));
    };
    CHECK(said({}).empty());
    CHECK(said({{"rst", "sink"}}) == "--use:1:1: error: the netlist uses no program \"rst\"\n"
                                     "    rst=sink\n"
                                     "    ^\n"
                                     "hint: the kinds are other.lku, pump.lku\n");
    CHECK(said({{"PUMP.LKU", "sink"}}).find("hint: did you mean \"pump.lku\"?\n") != std::string::npos);
    CHECK(said({{"pump.lku", "master"}}) == "--use:1:10: error: unknown process kind \"master\"\n"
                                            "    pump.lku=master\n"
                                            "             ^\n"
                                            "hint: did you mean \"ga.master\"?\n");
    CHECK(said({{"pump.lku", "fountain"}})
              .ends_with(
                  "hint: the kinds are csp.switch_logic, csp.switching_producer, ga.master, ga.slave, pump, sink\n"));
    CHECK(said({{"pump.lku", "pumb"}}).find("error: ") == said({{"pump.lku", "pumb"}}).rfind("error: "));
    CHECK(said({{"pump.lku", "pumb"}}).find("hint: did you mean \"pump\"?\n") != std::string::npos);
}
