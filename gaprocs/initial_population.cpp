#include "gaprocs/initial_population.hpp"

#include "text/load_source.hpp"
#include "text/user_error.hpp"

#include <algorithm>
#include <memory>

namespace placedpar {

namespace {

/// Reads the string in a line. An error message points to `begin`, the index of the string's first character.
Genome read_line(const Representation& representation, const std::shared_ptr<const SourceFile>& file, std::size_t line,
                 std::size_t begin) {
    try {
        return representation.read(file->line(line));
    } catch (const UserError& wrong) {
        Diagnostic refused;
        refused.message = wrong.what();
        refused.location = {file, line, begin + 1};
        throw RefusedInput(render(refused));
    }
}

} // namespace

std::vector<Genome> load_population(const std::filesystem::path& path, const Representation& representation) {
    LoadedSource source = load_source(path);
    if (!source.problems.empty())
        throw RefusedInput(render(source.problems));
    std::vector<Genome> population;
    auto lines = static_cast<std::size_t>(std::ranges::count(source.file->text(), '\n')) + 1;
    for (std::size_t line = 1; line <= lines; ++line) {
        std::string_view text = source.file->line(line);
        std::size_t begin = text.find_first_not_of(" \t\r");
        if (begin != text.npos && text[begin] != '#')
            population.push_back(read_line(representation, source.file, line, begin));
    }
    return population;
}

} // namespace placedpar
