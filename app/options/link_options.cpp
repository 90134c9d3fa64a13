#include "app/options/link_options.hpp"

#include <string>

namespace placedpar {

Option add_links(Options& command, std::string& links, const std::string& about) {
    return command.add("--link", links, about).type("LINK[,LINK]");
}

Option add_configuration(Options& command, std::string& configuration, const std::string& about) {
    return command.add("--configuration", configuration, about).one_of({"a", "b", "c", "d", "e"});
}

} // namespace placedpar
