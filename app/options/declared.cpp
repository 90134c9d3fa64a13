#include "app/options/declared.hpp"

#include <algorithm>

namespace placedpar {

std::vector<std::string> DeclaredCommand::names_of_commands() const {
    std::vector<std::string> names;
    for (const DeclaredCommand& each : commands)
        names.push_back(each.name);
    return names;
}

std::vector<std::string> DeclaredCommand::names_of_options() const {
    std::vector<std::string> names;
    for (const DeclaredOption& each : options)
        names.insert(names.end(), each.names.begin(), each.names.end());
    return names;
}

const DeclaredCommand* DeclaredCommand::command(const std::string& called) const {
    auto found = std::ranges::find(commands, called, &DeclaredCommand::name);
    return found == commands.end() ? nullptr : &*found;
}

const DeclaredOption* DeclaredCommand::option(const std::string& typed) const {
    auto found = std::ranges::find_if(
        options, [&](const DeclaredOption& each) { return std::ranges::count(each.names, typed) > 0; });
    return found == options.end() ? nullptr : &*found;
}

} // namespace placedpar
