#include "serve/examples.hpp"

#include "text/load_source.hpp"

#include <algorithm>
#include <array>

namespace placedpar::serve {

namespace fs = std::filesystem;

Texts read_examples(const fs::path& folder) {
    constexpr std::array extensions = {".cfs", ".inc", ".occ", ".pgm"};
    Texts texts;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file() || std::ranges::find(extensions, entry.path().extension()) == extensions.end())
            continue;
        const LoadedSource source = load_source(entry.path());
        if (source.problems.empty())
            texts[entry.path().lexically_relative(folder).generic_string()] = source.file->text();
    }
    return texts;
}

} // namespace placedpar::serve
