#include "text/repeated_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

/// Returns the message with "#" in place of each number. Digits within a name such as "P1" are kept.
std::string without_numbers(std::string_view message) {
    auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    std::string kind;
    for (std::size_t i = 0; i < message.size(); ++i) {
        const bool number =
            is_digit(message[i]) && (i == 0 || !(is_letter(message[i - 1]) || is_digit(message[i - 1])));
        kind += number ? '#' : message[i];
        if (number)
            i = std::min(message.find_first_not_of("0123456789.e+-", i), message.size()) - 1;
    }
    return kind;
}

} // namespace

std::vector<Diagnostic> RepeatedFaults::take(std::vector<Diagnostic> faults) {
    std::vector<Diagnostic> firsts;
    std::vector<std::string> kinds; // messages of the first faults, without numbers
    for (Diagnostic& fault : faults) {
        std::string kind = without_numbers(fault.message);
        const auto [found, is_new] = kinds_.try_emplace(kind, Kind{fault.message, fault.location.line});
        if (is_new || fault.location.line == found->second.line) {
            firsts.push_back(std::move(fault));
            kinds.push_back(is_new ? std::move(kind) : "");
        } else {
            if (fault.location.line != found->second.last)
                ++found->second.more;
            found->second.last = fault.location.line;
        }
    }
    for (std::size_t i = 0; i < firsts.size(); ++i)
        if (const auto found = kinds_.find(kinds[i]); found != kinds_.end() && found->second.more > 0) {
            const std::size_t more = std::exchange(found->second.more, 0);
            firsts[i].message +=
                more == 1 ? fmt::format(" (and line {})", found->second.last)
                          : fmt::format(" (and {} more lines, the last is line {})", more, found->second.last);
        }
    return firsts;
}

std::string RepeatedFaults::later() const {
    std::string text;
    for (const auto& [kind, each] : kinds_)
        if (each.more > 0)
            text += fmt::format("... {} more {} like \"{}\", the last is line {}\n", each.more,
                                each.more == 1 ? "line" : "lines", each.message, each.last);
    return text;
}

} // namespace placedpar
