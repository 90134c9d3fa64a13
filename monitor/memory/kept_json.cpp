#include "monitor/memory/kept_json.hpp"

#include <fmt/format.h>

namespace placedpar::monitor {

hydraulics::LinkSet KeptJson::links_in(std::string_view words) {
    hydraulics::LinkSet links;
    for (hydraulics::Link link : hydraulics::all_links)
        if (words.find(symbol_of(link)) != words.npos)
            links.insert(link);
    if (words_of(links) != words)
        throw std::runtime_error(fmt::format("\"{}\" is not a list of links such as \"BU BO\"", words));
    return links;
}

void KeptJson::require_count(std::size_t found, const char* what, std::size_t expected) {
    if (found != expected)
        throw std::runtime_error(fmt::format("{} {}, expected {}", found, what, expected));
}

void KeptJson::throw_no_name(const std::string& text) {
    throw std::runtime_error(fmt::format("\"{}\" is not a known name", text.c_str()));
}

} // namespace placedpar::monitor
