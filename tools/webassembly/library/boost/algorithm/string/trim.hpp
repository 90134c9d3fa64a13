#pragma once

// Emscripten's std::string_view cannot be made from two iterators, as Boost's functions make it.
#include_next <boost/algorithm/string/trim.hpp>

#include <string_view>

namespace boost::algorithm {

inline std::string_view trim_copy(std::string_view text) {
    constexpr std::string_view blank = " \t\n\v\f\r";
    const std::size_t first = text.find_first_not_of(blank);
    return first == text.npos ? text.substr(0, 0) : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

} // namespace boost::algorithm
