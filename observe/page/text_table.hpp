#pragma once

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace placedpar::page {

/// Numbers texts in the order of their first use; the empty text is 0.
class TextTable {
public:
    TextTable() { number_of(""); }

    std::uint32_t number_of(const std::string& text) {
        auto [found, is_new] = numbers_.emplace(text, static_cast<std::uint32_t>(texts_.size()));
        if (is_new)
            texts_.push_back(text);
        return found->second;
    }
    boost::json::array json() const;

private:
    std::unordered_map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> texts_;
};

} // namespace placedpar::page
