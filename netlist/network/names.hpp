#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// These functions handle the names of arrays and their elements in netlists. Elements are ordered so that the last
/// subscript varies fastest.

/// Returns "out" for "out[2]"; returns a name without a subscript unchanged.
std::string_view base_name(std::string_view name);
/// Returns the subscripts of a name: {2} for "out[2]", {0, 1} for "t[0][1]", none for "t".
std::vector<std::int64_t> subscripts_of(std::string_view name);
/// Returns "name[1][2]".
std::string element_name(const std::string& name, const std::vector<std::int64_t>& subscripts);
/// Returns the number of elements of an array; 1 if there are no dimensions.
std::size_t element_count(const std::vector<std::int64_t>& dimensions);
/// Returns the subscripts of the element at this position in its array, counted from 0.
std::vector<std::int64_t> element_subscripts(std::size_t position, const std::vector<std::int64_t>& dimensions);

/// Returns the member `name` of each thing.
template <class Things>
std::vector<std::string> names_in(const Things& things) {
    std::vector<std::string> names;
    std::ranges::transform(things, std::back_inserter(names), [](const auto& thing) { return thing.name; });
    return names;
}

/// Returns the thing with this name; null if there is none.
template <class Things>
auto find_named(Things& things, std::string_view name) -> decltype(&*things.begin()) {
    auto found = std::ranges::find_if(things, [&](const auto& thing) { return thing.name == name; });
    return found == things.end() ? nullptr : &*found;
}

} // namespace placedpar
