#pragma once

#include <string>

namespace placedpar::occam::embedded {

/// Each function returns the text of a library or include file in this folder, such as convert.occ for convert_occ().
/// The build makes the definitions (occam/CMakeLists.txt), so that the program needs no files.
std::string convert_occ();
std::string course_occ();
std::string dblmath_occ();
std::string hostio_inc();
std::string hostio_occ();
std::string linkaddr_inc();
std::string mathvals_inc();
std::string predef_occ();
std::string snglmath_occ();
std::string streamio_inc();
std::string streamio_occ();
std::string string_occ();
std::string terminal_occ();

} // namespace placedpar::occam::embedded
