#pragma once

#include <string>

namespace placedpar::serve {

// These functions return parts of the page. The build embeds the files: see CMakeLists.txt.

std::string frame_html(); ///< has placeholders: @STYLE@ and @PROGRAM@
std::string style_css();  ///< CodeMirror's style, then ours
std::string program_js(); ///< CodeMirror of Debian's package libjs-codemirror, then our own JavaScript

/// Returns the whole page.
std::string page_html();

} // namespace placedpar::serve
