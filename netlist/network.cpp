#include "netlist/network.hpp"

#include <charconv>

namespace placedpar {

std::string_view base_name(std::string_view name) { return name.substr(0, name.find('[')); }

std::vector<std::int64_t> subscripts_of(std::string_view name) {
    std::vector<std::int64_t> result;
    for (auto open = name.find('['); open != std::string_view::npos; open = name.find('[', open + 1)) {
        std::int64_t value = 0;
        std::from_chars(name.data() + open + 1, name.data() + name.size(), value);
        result.push_back(value);
    }
    return result;
}

} // namespace placedpar
