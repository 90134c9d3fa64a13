#include "netlist/network/names.hpp"

#include <fmt/format.h>

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

std::string element_name(const std::string& name, const std::vector<std::int64_t>& subscripts) {
    auto result = name;
    for (auto subscript : subscripts)
        result += fmt::format("[{}]", subscript);
    return result;
}

std::size_t element_count(const std::vector<std::int64_t>& dimensions) {
    std::size_t count = 1;
    for (auto size : dimensions)
        count *= static_cast<std::size_t>(size);
    return count;
}

std::vector<std::int64_t> element_subscripts(std::size_t position, const std::vector<std::int64_t>& dimensions) {
    std::vector<std::int64_t> result(dimensions.size());
    for (auto i = dimensions.size(); i-- > 0;) {
        auto size = static_cast<std::size_t>(dimensions[i]);
        result[i] = static_cast<std::int64_t>(position % size);
        position /= size;
    }
    return result;
}

} // namespace placedpar
