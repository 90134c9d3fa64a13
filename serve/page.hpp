#pragma once

#include <string>

namespace placedpar::serve {

// These functions return parts of the web page on which users run programs. The build embeds the parts' files in the
// program.

std::string frame_html(); ///< the page's HTML with the placeholders @STYLE@ and @PROGRAM@
std::string style_css();  ///< CodeMirror's style, then the page's own style
std::string program_js(); ///< CodeMirror from Debian's package libjs-codemirror, then the page's own JavaScript

/// Returns the whole page.
std::string page_html();

} // namespace placedpar::serve
