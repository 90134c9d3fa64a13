#pragma once

#include <filesystem>
#include <string>

namespace placedpar {

/// Returns whether the path is "-", which means standard input or standard output. "./-" is a file whose name is "-".
bool is_standard_stream(const std::filesystem::path&);

/// Returns the name of an input file in messages: its path, or "<standard input>".
std::string shown_input(const std::filesystem::path&);
/// Returns the name of an output file in messages: its path, or "<standard output>".
std::string shown_output(const std::filesystem::path&);

/// Makes print_out() write to standard error from now on, because standard output receives a file and nothing else.
void give_standard_output_to_a_file();
bool standard_output_takes_a_file();

/// Reserves the descriptors of standard input, output and error if they are closed. Otherwise a file opened later could
/// take such a descriptor and receive the printed text. Reading from a reserved stream, or writing to it, still fails.
void hold_closed_streams();

} // namespace placedpar
