#include "serve/page.hpp"

namespace placedpar::serve {

namespace {

void put(std::string& page, const std::string& placeholder, const std::string& text) {
    page.replace(page.find(placeholder), placeholder.size(), text);
}

} // namespace

std::string page_html() {
    std::string page = frame_html();
    put(page, "@STYLE@", style_css());
    put(page, "@PROGRAM@", program_js());
    return page;
}

} // namespace placedpar::serve
