#include "experiments/kit/examples_folder.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string>

using namespace placedpar;
namespace fs = std::filesystem;

namespace {

/// A folder that is deleted afterwards.
struct Scratch {
    fs::path folder = fs::temp_directory_path() / ("placedpar-examples-" + std::to_string(::getpid()));

    Scratch() { fs::create_directories(folder); }
    ~Scratch() { fs::remove_all(folder); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    fs::path made(const char* name) const {
        fs::create_directories(folder / name);
        return folder / name;
    }
};

} // namespace

TEST_CASE("an installed program finds the examples beside it") {
    Scratch scratch;
    fs::path installed = scratch.made("share/placedpar/examples"), program = scratch.made("bin") / "placedpar";
    CHECK(examples_folder(program, nullptr) == installed);
    fs::path named = scratch.made("mine");
    CHECK(examples_folder(program, named.c_str()) == named);
    CHECK(examples_folder(program, (scratch.folder / "none").c_str()) == installed);
}

TEST_CASE("a program in its build folder finds the examples that the build names") {
    Scratch scratch;
    fs::path source = scratch.made("source/examples"), program = scratch.made("build/app") / "placedpar";
    std::ofstream(program.parent_path() / "examples-folder.txt") << source.string() << "\n";
    CHECK(examples_folder(program, nullptr) == source);
}

TEST_CASE("the message about missing examples names the folders that were searched") {
    Scratch scratch;
    fs::path program = scratch.folder / "bin" / "placedpar";
    std::string said = "cannot find the folder of examples; looked in\n  " + (scratch.folder / "mine").string() +
                       "\n  " + (scratch.folder / "share/placedpar/examples").string() +
                       "\nset PLACEDPAR_EXAMPLES to that folder";
    CHECK_THROWS_WITH_AS(examples_folder(program, (scratch.folder / "mine").c_str()), said.c_str(), std::runtime_error);
}
