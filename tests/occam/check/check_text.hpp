#pragma once

#include "occam/check/check.hpp"

#include <string>

namespace placedpar::test {

/// The result of reading and checking a text.
struct CheckedText {
    occam::Parsed parsed;
    std::string messages; ///< as printed
    bool failed = false;
    std::size_t errors = 0; ///< number of printed errors
};
CheckedText check_text(const std::string& text, const std::string& shown_path = "text.occ");

/// Returns the declaration of the main file with this name. REQUIRES: there is one.
const occam::Declaration& declared(const CheckedText&, const std::string& name);

} // namespace placedpar::test
