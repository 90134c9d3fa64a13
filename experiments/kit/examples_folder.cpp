#include "experiments/kit/examples_folder.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace placedpar {

std::filesystem::path examples_folder() {
    namespace fs = std::filesystem;
    std::vector<fs::path> places;
    if (const char* named = std::getenv("PLACEDPAR_EXAMPLES"))
        places.emplace_back(named);
    std::error_code error;
    fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error)
        places.push_back(program.parent_path().parent_path() / "share" / "placedpar" / "examples");
    places.emplace_back(PLACEDPAR_SOURCE_EXAMPLES);
    std::string looked;
    for (const fs::path& place : places) {
        if (fs::is_directory(place))
            return place;
        looked += "\n  " + place.string();
    }
    throw std::runtime_error(
        fmt::format("the examples are not to be found; looked in{}\nset PLACEDPAR_EXAMPLES to their folder", looked));
}

} // namespace placedpar
