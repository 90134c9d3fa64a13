#include "occam/library/library.hpp"

#include "occam/library/embedded.hpp"

#include <array>
#include <utility>

namespace placedpar::occam {
namespace {

struct LibraryFile {
    std::string_view name;
    std::string (*text)();
};

constexpr std::array library_files{
    LibraryFile{"convert.lib", embedded::convert_occ},   LibraryFile{"course.lib", embedded::course_occ},
    LibraryFile{"dblmath.lib", embedded::dblmath_occ},   LibraryFile{"hostio.inc", embedded::hostio_inc},
    LibraryFile{"hostio.lib", embedded::hostio_occ},     LibraryFile{"linkaddr.inc", embedded::linkaddr_inc},
    LibraryFile{"mathvals.inc", embedded::mathvals_inc}, LibraryFile{"snglmath.lib", embedded::snglmath_occ},
    LibraryFile{"predef.lib", embedded::predef_occ},     LibraryFile{"streamio.inc", embedded::streamio_inc},
    LibraryFile{"streamio.lib", embedded::streamio_occ}, LibraryFile{"string.lib", embedded::string_occ},
    LibraryFile{"terminal.lib", embedded::terminal_occ},
};

} // namespace

std::optional<std::string> library_text(std::string_view name) {
    std::string_view stem = name.substr(0, name.rfind('.'));
    bool constants = name.ends_with(".inc");
    for (const LibraryFile& each : library_files)
        if (each.name.ends_with(".inc") == constants && each.name.substr(0, each.name.rfind('.')) == stem)
            return each.text();
    return std::nullopt;
}

std::vector<std::string> library_names() {
    std::vector<std::string> names;
    for (const LibraryFile& each : library_files)
        names.emplace_back(each.name);
    return names;
}

} // namespace placedpar::occam
