#pragma once

#include <string>

namespace placedpar::page {

// These functions return the files of which the HTML page of a run is made. The build embeds these files in the
// program: see CMakeLists.txt.

std::string frame_html(); ///< has placeholders: @TITLE@, @STYLE@, @LIBRARY@, @DATA@, @STRETCHES@, @PROGRAM@, and one
                          ///< for each picture
std::string style_css();
std::string library_js(); ///< D3, of Debian's package node-d3
std::string program_js(); ///< the page's own JavaScript

} // namespace placedpar::page
