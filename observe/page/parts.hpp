#pragma once

#include <string>

namespace placedpar::page {

// Files that a page is made of, embedded when the program is built: see CMakeLists.txt.

std::string frame_html(); ///< with @TITLE@, @STYLE@, @LIBRARY@, @DATA@, @STRETCHES@, @PROGRAM@ where the others go, and
                          ///< the pictures
std::string style_css();
std::string library_js(); ///< D3, of Debian's package node-d3
std::string program_js(); ///< all of ours

} // namespace placedpar::page
