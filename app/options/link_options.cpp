#include "app/options/link_options.hpp"

#include "text/user_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>

namespace placedpar {

using namespace hydraulics;

CLI::Option* add_links(CLI::App& command, std::string& links, const std::string& about) {
    return command.add_option("--link", links, about)->type_name("LINK[,LINK]");
}

CLI::Option* add_configuration(CLI::App& command, std::string& configuration, const std::string& about) {
    return command.add_option("--configuration", configuration, about)
        ->check(CLI::IsMember({"a", "b", "c", "d", "e"}).description(""))
        ->type_name("a|b|c|d|e");
}

LinkSet links_of(const std::string& text) {
    LinkSet links;
    for (std::size_t start = 0, end = 0; end != std::string::npos; start = end + 1) {
        end = text.find(',', start);
        std::string name = text.substr(start, end - start);
        auto link = link_named(name);
        if (!link)
            throw UserError(
                fmt::format("--link {}: there is no link \"{}\"; there are bucket, boom, stick and swing", text, name));
        if (links.contains(*link))
            throw UserError(fmt::format("--link {}: {} is named twice", text, name_of(*link)));
        links.insert(*link);
    }
    return links;
}

} // namespace placedpar
