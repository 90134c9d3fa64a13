#pragma once

namespace placedpar::monitor {

/// The page that shows the service: HTML with everything in it, asking the service alone.
extern const char* const page_html;

} // namespace placedpar::monitor
