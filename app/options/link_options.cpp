#include "app/options/link_options.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <string>

namespace placedpar {

using namespace hydraulics;

Option add_links(Options& command, std::string& links, const std::string& about) {
    return command.add("--link", links, about).type("LINK[,LINK]");
}

Option add_configuration(Options& command, std::string& configuration, const std::string& about) {
    return command.add("--configuration", configuration, about).one_of({"a", "b", "c", "d", "e"});
}

LinkSet links_of(const std::string& text) {
    LinkSet links;
    for (std::size_t start = 0, end = 0; end != std::string::npos; start = end + 1) {
        end = text.find(',', start);
        std::string name = text.substr(start, end - start);
        auto link = link_named(name);
        if (!link)
            throw UserError(
                fmt::format("--link {}: unknown link \"{}\"; the links are bucket, boom, stick and swing", text, name));
        if (links.contains(*link))
            throw UserError(fmt::format("--link {}: {} is named twice", text, name_of(*link)));
        links.insert(*link);
    }
    return links;
}

} // namespace placedpar
