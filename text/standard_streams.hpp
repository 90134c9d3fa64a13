#pragma once

#include <filesystem>
#include <string>

namespace placedpar {

/// "-" in the place of a file's name: standard input where a file is read, standard output where one is written. A file
/// that is really called so is "./-".
bool is_standard_stream(const std::filesystem::path&);

/// What messages call a file that is read: its path, or "<standard input>".
std::string shown_input(const std::filesystem::path&);
/// What messages call a file that is written: its path, or "<standard output>".
std::string shown_output(const std::filesystem::path&);

/// From now on print_out() writes to standard error, because a file is written to standard output,
/// which must hold nothing else.
void give_standard_output_to_a_file();
bool standard_output_takes_a_file();

/// Takes the places of standard input, output and error where they are closed, so that no file that is opened later
/// gets what is printed. Reading and writing there goes wrong as before.
void hold_closed_streams();

} // namespace placedpar
