#include "tests/occam/language/read_text.hpp"

#include "text/diagnostic.hpp"
#include "text/load_source.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace placedpar::test {

std::filesystem::path occam_path(const std::string& name) {
    return std::filesystem::path(PLACEDPAR_SOURCE_DIR) / "tests/occam" / name;
}

std::vector<std::filesystem::path> occam_files(const std::filesystem::path& folder, const std::string& extension) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() == extension)
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::vector<std::filesystem::path> occam_programs() {
    auto files = occam_files(occam_path("programs"), ".occ");
    std::ranges::copy(occam_files(occam_path("../../examples/occam/beside-inmos"), ".occ"), std::back_inserter(files));
    return files;
}

std::string whole_file(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

ReadText read_text(const std::string& text, const std::string& shown_path, const std::vector<std::string>& defined,
                   bool all_are_known) {
    Reporter reporter;
    occam::ParseOptions options;
    options.defined = defined;
    options.built_in = [all_are_known](const std::string& name) -> std::optional<std::string> {
        const bool is_known = all_are_known || name.starts_with("known") || name.starts_with("hostio");
        return is_known ? std::optional<std::string>("") : std::nullopt;
    };
    LoadedSource source = check_source(shown_path, text);
    if (!source.problems.empty())
        return {{}, render(source.problems), true};
    ReadText read{occam::parse(source.file, options, reporter), "", reporter.failed()};
    read.messages = render(reporter.take()) + reporter.not_shown();
    return read;
}

} // namespace placedpar::test
