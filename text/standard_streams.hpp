#pragma once

#include <filesystem>
#include <string>

namespace placedpar {

/// Returns whether the path is "-", by which a user means standard input or standard output. A file with the name "-"
/// has the path "./-".
bool is_standard_stream(const std::filesystem::path&);

/// Returns the name of an input file in messages: its path, or "<standard input>".
std::string shown_input(const std::filesystem::path&);
/// Returns the name of an output file in messages: its path, or "<standard output>".
std::string shown_output(const std::filesystem::path&);

/// Makes print_out() write to standard error from now on. Called if the user has chosen "-" for an output file, since
/// nothing but this file may then go to standard output.
void give_standard_output_to_a_file();
bool standard_output_takes_a_file();

/// Reserves the descriptors 0, 1 and 2 if the program was started with these standard streams closed. Otherwise a file
/// that is opened later could get such a descriptor, and printed text would go into this file. Reading from a reserved
/// stream, or writing to it, still fails.
void hold_closed_streams();

} // namespace placedpar
