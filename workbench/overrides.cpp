#include "workbench/overrides.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

Overrides overrides_of(std::span<const std::string> settings) {
    Overrides overrides;
    for (const std::string& each : settings) {
        std::size_t equals = each.find('=');
        if (equals == std::string::npos || equals == 0)
            throw std::runtime_error(fmt::format("--set {}: it takes NAME=VALUE, such as --set slaves=3", each));
        if (!overrides.emplace(each.substr(0, equals), each.substr(equals + 1)).second)
            throw std::runtime_error(fmt::format("--set {}: {} is set twice", each, each.substr(0, equals)));
    }
    return overrides;
}

} // namespace placedpar
