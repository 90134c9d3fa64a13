#pragma once

#include <functional>
#include <span>
#include <string>

namespace placedpar::fuzz {

/// A reader of ours as a fuzzer calls it. It may throw a UserError; anything else that it throws is a defect, as is a
/// crash, a hang or a report of the sanitizers.
struct Reader {
    const char* name;
    std::function<void(const std::string&)> read;
};

/// Returns the readers of the program that this is linked into: lower_rooms.cpp or upper_rooms.cpp.
std::span<const Reader> readers();

/// Throws std::logic_error where a claim about what was read does not hold.
void require(bool holds, const char* claim);

} // namespace placedpar::fuzz
