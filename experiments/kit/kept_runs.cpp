#include "experiments/kit/kept_runs.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

namespace placedpar {

namespace {

constexpr const char* first_words = "runs of ";

std::string line_of(const std::string& what, std::uint64_t seed, const Figures& figures) {
    std::string line = fmt::format("{}\t{}", what, seed);
    for (double figure : figures)
        line += fmt::format("\t{:a}", figure);
    return line;
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, '\t');)
        fields.push_back(field);
    return fields;
}

} // namespace

KeptRuns::KeptRuns(const std::filesystem::path& path, const std::string& of) : path_(path) {
    read(of);
    out_.open(path, std::ios::trunc);
    write(first_words + of);
    for (const std::string& line : lines_)
        write(line);
}

void KeptRuns::read(const std::string& of) {
    std::ifstream in(path_);
    std::string line;
    if (!std::getline(in, line))
        return;
    if (line != first_words + of)
        throw UserError(fmt::format("{} keeps \"{}\", expected \"{}{}\": name another file", path_.string(), line,
                                    first_words, of));
    while (std::getline(in, line) && !in.eof()) { // at the end of the file, the line has none of its own
        std::vector<std::string> fields = fields_of(line);
        if (fields.size() < 2)
            throw UserError(fmt::format("{}: \"{}\" is no run", path_.string(), line));
        Figures& figures = runs_[{fields[0], std::strtoull(fields[1].c_str(), nullptr, 10)}];
        for (std::size_t i = 2; i < fields.size(); ++i)
            figures.push_back(std::strtod(fields[i].c_str(), nullptr));
        lines_.push_back(line);
    }
}

void KeptRuns::write(const std::string& line) {
    out_ << line << std::endl; // at once: the program may be ended
    if (!out_)
        throw UserError(fmt::format("cannot write {}", path_.string()));
}

std::optional<Figures> KeptRuns::find(const std::string& what, std::uint64_t seed) const {
    auto found = runs_.find({what, seed});
    return found == runs_.end() ? std::nullopt : std::optional(found->second);
}

void KeptRuns::add(const std::string& what, std::uint64_t seed, const Figures& figures) {
    write(line_of(what, seed, figures));
    runs_[{what, seed}] = figures;
}

} // namespace placedpar
