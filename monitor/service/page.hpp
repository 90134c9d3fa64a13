#pragma once

namespace placedpar::monitor {

/// The web page of the service: self-contained HTML that sends requests to this service only.
extern const char* const page_html;

} // namespace placedpar::monitor
