// Damages good configurations: cut at each line, and without each word. Each is read or refused, and each refusal names
// a place. Nothing crashes.

#include "occam/configuration/configuration.hpp"
#include "tests/occam/configuration/configured_text.hpp"
#include "tests/occam/language/read_text.hpp"
#include "tests/occam/network/network_text.hpp"

#include <doctest/doctest.h>

#include <cctype>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

std::vector<std::string> cut_at_lines(const std::string& text) {
    std::vector<std::string> cut;
    for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1))
        cut.push_back(text.substr(0, end + 1));
    cut.pop_back(); // the whole text
    return cut;
}

std::vector<std::string> without_words(const std::string& text) {
    std::vector<std::string> damaged;
    const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin + 1;
        while (!is_blank(text[begin]) && end < text.size() && !is_blank(text[end]))
            ++end;
        if (!is_blank(text[begin]))
            damaged.push_back(text.substr(0, begin) + text.substr(end));
        begin = end;
    }
    return damaged;
}

/// Reads a damaged text in the folder of its programs. Returns whether it was refused. With a catalogue, the netlist is
/// read, too, which compiles the programs.
bool is_refused(const std::string& text, const std::filesystem::path& beside, const Catalogue* catalogue) {
    CAPTURE(text);
    Reporter reporter;
    const auto file = std::make_shared<const SourceFile>(beside.string(), text);
    if (!occam::is_configuration(*file)) // PLACED is missing in a file .occ
        return true;
    const MadeNetlist made = test::configuration_options().make_netlist(file, {}, {}, reporter);
    const bool failed = reporter.failed();
    const std::vector<Diagnostic> diagnostics = reporter.take();
    CHECK(diagnostics.size() <= 21);
    for (const Diagnostic& each : diagnostics)
        CHECK(each.location.file);
    CHECK(failed == !made.text);
    return failed || (catalogue && !read_netlist_text(made.text->text(), *catalogue, {}, beside.string()).network);
}

} // namespace

TEST_CASE("damaged configurations are read or refused") {
    const Catalogue catalogue = test::occam_catalogue();
    const auto folder = test::occam_path("../../examples/occam/sixteen");
    for (const char* const name : {"sixteen.pgm", "farm.pgm", "ring.occ"}) {
        const std::string good = test::whole_file(folder / name);
        CHECK_FALSE(is_refused(good, folder / name, &catalogue));
        std::size_t refused = 0, words = 0;
        for (const std::string& text : cut_at_lines(good))
            is_refused(text, folder / name, nullptr);
        for (const std::string& text : without_words(good))
            refused += is_refused(text, folder / name, ++words % 10 == 0 ? &catalogue : nullptr);
        CHECK(words > 100);
        CHECK(refused > words / 2); // the others are of comments, or leave another meaning
    }
}
