#include "text/counted.hpp"

#include <fmt/format.h>

namespace placedpar {

std::string counted(std::size_t count, std::string_view one, std::string_view more) {
    return fmt::format("{} {}{}", count, count == 1 || more.empty() ? one : more,
                       count == 1 || !more.empty() ? "" : "s");
}

} // namespace placedpar
