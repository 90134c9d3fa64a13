#pragma once

#include "occam/language/parse.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar::test {

/// Returns the folder of these tests, or a file in it.
std::filesystem::path occam_path(const std::string& name = "");
/// Returns the files of a folder with this extension, in order of their names.
std::vector<std::filesystem::path> occam_files(const std::filesystem::path& folder, const std::string& extension);
/// Returns good programs: those of these tests, and the examples that are compared with INMOS's code.
std::vector<std::filesystem::path> occam_programs();
std::string whole_file(const std::filesystem::path&);

/// The result of reading a text.
struct ReadText {
    occam::Parsed parsed;
    std::string messages; ///< as printed
    bool failed = false;
};
/// Reads a text. Files whose names begin with "known" or "hostio" are empty; with `all_are_known`, so is every file
/// that is not found.
ReadText read_text(const std::string& text, const std::string& shown_path = "text.occ",
                   const std::vector<std::string>& defined = {}, bool all_are_known = false);

} // namespace placedpar::test
