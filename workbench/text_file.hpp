#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "text/table.hpp"

#include <filesystem>
#include <vector>

namespace placedpar {

/// Reads a record of measurement. Warnings go to standard error, and to `warnings` if it is given. Throws
/// std::runtime_error whose text is all that is wrong, each with file, line, column and a caret.
hydraulics::Record load_record(const std::filesystem::path& path, std::vector<Diagnostic>* warnings = nullptr);

/// The excavator's constants, with those of the file in place of those of the same name; no file when the path
/// is empty. Throws as load_record().
hydraulics::Parameters load_machine(const std::filesystem::path& path);

} // namespace placedpar
