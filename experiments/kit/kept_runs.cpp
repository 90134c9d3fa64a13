#include "experiments/kit/kept_runs.hpp"

#include "text/checksum.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace placedpar {

namespace {

constexpr std::string_view first_words = "checked runs of ", first_words_before = "runs of ";

/// Without its end.
std::string line_of(const std::string& of, const std::string& what, std::uint64_t seed, const Figures& figures) {
    std::string line = fmt::format("{}\t{}", what, seed);
    for (double figure : figures)
        line += fmt::format("\t{}", figure);
    return fmt::format("{}\t{:016x}", line, static_cast<std::uint64_t>(checksum_of(of, line)));
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t end = 0; end != line.npos; line.remove_prefix(end == line.npos ? 0 : end + 1)) {
        end = line.find('\t');
        fields.push_back(line.substr(0, end));
    }
    return fields;
}

} // namespace

KeptRuns::KeptRuns(const std::filesystem::path& path, const std::string& of) : path_(path), of_(of) {
    const std::size_t whole = read();
    if (whole > 0)
        std::filesystem::resize_file(path, whole);
    out_.open(path, whole > 0 ? std::ios::app : std::ios::trunc);
    if (whole == 0)
        write(fmt::format("{}{}", first_words, of));
}

std::size_t KeptRuns::read() {
    std::ifstream in(path_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::size_t whole = 0;
    for (std::size_t number = 1, end = 0; (end = text.find('\n', whole)) != text.npos; ++number, whole = end + 1)
        read_line(text.substr(whole, end - whole), number);
    if (whole == 0 && !text.empty())
        read_line(text, 1); // it was cut off, or is another file
    return whole;
}

void KeptRuns::read_line(const std::string& line, std::size_t number) {
    if (number > 1)
        return read_run(line, number);
    if (line == fmt::format("{}{}", first_words, of_))
        return;
    if (line.starts_with(first_words_before))
        throw UserError(fmt::format("{}: its runs were kept by an earlier PlacedPar, without checksums, and may be "
                                    "damaged: name another file",
                                    path_.string()));
    throw UserError(fmt::format("{} keeps \"{}\", expected \"{}{}\": name another file", path_.string(),
                                line.substr(0, 200), first_words, of_));
}

/// Written again it is the same: so is the checksum, and no number has another notation.
void KeptRuns::read_run(const std::string& line, std::size_t number) {
    const std::vector<std::string_view> fields = fields_of(line);
    const auto seed = parse_number<std::uint64_t>(fields.size() > 2 ? fields[1] : "");
    Figures figures;
    for (std::size_t i = 2; i + 1 < fields.size(); ++i)
        if (auto figure = parse_number<double>(fields[i]))
            figures.push_back(*figure);
    const std::string what(fields[0]);
    if (!seed || line != line_of(of_, what, *seed, figures) || !runs_.try_emplace({what, *seed}, figures).second)
        throw UserError(
            fmt::format("{}: line {} is damaged: without it, its run is made again", path_.string(), number));
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
    write(line_of(of_, what, seed, figures));
    runs_[{what, seed}] = figures;
}

} // namespace placedpar
