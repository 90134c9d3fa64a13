#pragma once

#include <functional>
#include <span>
#include <string>

namespace placedpar::fuzz {

/// A reader in the form in which a fuzzer calls it. It may throw a UserError. Any other exception is a defect, as is a
/// crash, a hang or a sanitizer report.
struct Reader {
    const char* name;
    std::function<void(const std::string&)> read;
};

/// Returns the readers that this program is linked with: those of lower_rooms.cpp or those of upper_rooms.cpp.
std::span<const Reader> readers();

/// Boots transputers with these bytes (booted.cpp).
void boot_transputers(const std::string& bytes);

/// Compiles a program of occam and runs it (occam.cpp).
void compile_occam(const std::string& input);

/// Reads a configuration in occam as a network (occam.cpp).
void configure_occam(const std::string& input);

/// Throws std::logic_error if the claim about the read data does not hold.
void require(bool holds, const char* claim);

} // namespace placedpar::fuzz
