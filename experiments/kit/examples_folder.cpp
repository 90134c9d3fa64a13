#include "experiments/kit/examples_folder.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace placedpar {

namespace {

namespace fs = std::filesystem;

/// Returns the first line of the file, or "" if the file does not exist.
std::string first_line(const fs::path& file) {
    std::string line;
    std::getline(std::ifstream(file), line);
    return line;
}

std::vector<fs::path> places_beside(const fs::path& program) {
    std::vector<fs::path> places{program.parent_path().parent_path() / "share" / "placedpar" / "examples"};
    if (std::string written_by_build = first_line(program.parent_path() / "examples-folder.txt");
        written_by_build != "")
        places.emplace_back(written_by_build);
    return places;
}

std::vector<fs::path> places_of_examples(const fs::path& program, const char* named) {
    std::vector<fs::path> places = program.empty() ? std::vector<fs::path>() : places_beside(program);
    if (named)
        places.insert(places.begin(), named);
    return places;
}

} // namespace

fs::path examples_folder() {
    std::error_code error; // set if the system does not have /proc/self/exe; the path of the program is then empty
    return examples_folder(fs::read_symlink("/proc/self/exe", error), std::getenv("PLACEDPAR_EXAMPLES"));
}

fs::path examples_folder(const fs::path& program, const char* named) {
    std::string looked;
    for (const fs::path& place : places_of_examples(program, named)) {
        if (fs::is_directory(place))
            return place;
        looked += "\n  " + place.string();
    }
    throw UserError(
        fmt::format("cannot find the folder of examples; looked in{}\nset PLACEDPAR_EXAMPLES to that folder", looked));
}

} // namespace placedpar
