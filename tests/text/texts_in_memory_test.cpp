#include "text/load_source.hpp"
#include "text/texts_in_memory.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

namespace placedpar {

TEST_CASE("a text in memory stands in for its file, by whatever path, while it is asked for") {
    const auto folder = std::filesystem::temp_directory_path() / "placedpar-texts";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a.inc") << "on disk";
    TextsInMemory texts;
    texts.put(folder / "a.inc", "in memory");
    texts.put(folder / "new.inc", "not saved yet");
    CHECK(load_source(folder / "a.inc").file->text() == "on disk");
    {
        const ReadsFromMemory reads(texts);
        CHECK(load_source(folder / "a.inc").file->text() == "in memory");
        CHECK(load_source(folder / "." / ".." / folder.filename() / "a.inc").file->text() == "in memory");
        CHECK(names_file(folder / "new.inc"));
        CHECK_FALSE(names_file(folder));
        texts.remove(folder / "a.inc");
        CHECK(load_source(folder / "a.inc").file->text() == "on disk");
    }
    CHECK_FALSE(names_file(folder / "new.inc"));
    std::filesystem::remove_all(folder);
}

} // namespace placedpar
