#include "explore/stated_vals.hpp"

#include "netlist/network/network.hpp"

#include <fstream>
#include <string_view>

namespace placedpar {

namespace {

constexpr std::string_view blank = " \t\r";

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blank);
    return first == text.npos ? "" : text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

/// Reads a line such as "val slaves 3; /* of each */".
void add_val(std::map<std::string, std::string>& vals, std::string_view line) {
    constexpr std::string_view word = "val ";
    line = without_blanks(line);
    if (!line.starts_with(word))
        return;
    line = without_blanks(line.substr(word.size()));
    const std::size_t name = line.find_first_of(blank), end = line.find(';');
    if (name != line.npos && end != line.npos && name < end)
        vals[std::string(line.substr(0, name))] = without_blanks(line.substr(name, end - name));
}

} // namespace

std::map<std::string, std::string> stated_vals(const Network& network) {
    std::map<std::string, std::string> vals;
    std::vector<std::string> paths = network.included_paths;
    paths.push_back(network.source_path);
    for (const std::string& path : paths) {
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);)
            add_val(vals, line);
    }
    for (const SetByOption& set : network.set)
        if (auto stated = vals.find(set.name); stated != vals.end() && set.elements.empty())
            stated->second = set.value;
    return vals;
}

} // namespace placedpar
