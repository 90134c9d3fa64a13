// Compiles damaged programs of occam, and runs what the compiler accepts. Reads damaged configurations.

#include "netlist/read.hpp"
#include "occam/check/check.hpp"
#include "occam/code/compile.hpp"
#include "occam/configuration/configuration.hpp"
#include "occam/library/library.hpp"
#include "occam/network/file_kinds.hpp"
#include "tests/fuzz/reader.hpp"
#include "tests/occam/code/executed.hpp"
#include "tests/occam/language/print.hpp"
#include "text/load_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::fuzz {

namespace {

/// Splits a text into lines, or into words, blanks and single other characters.
std::vector<std::string> pieces_of(const std::string& text, bool into_lines) {
    const auto kind = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 ? 1 : c == ' ' ? 2 : 0; };
    std::vector<std::string> pieces;
    for (const char c : text) {
        const bool goes_on = !pieces.empty() && (into_lines ? pieces.back().back() != '\n'
                                                            : kind(c) != 0 && kind(c) == kind(pieces.back().back()));
        if (goes_on)
            pieces.back() += c;
        else
            pieces.emplace_back(1, c);
    }
    return pieces;
}

/// Deletes, doubles, exchanges or replaces pieces: four bytes of `changes` say what is done to which two pieces.
std::string damaged(std::string text, std::string_view changes) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(changes[at]); };
    for (int left = 6; left > 0 && changes.size() >= 5 && !text.empty(); --left, changes.remove_prefix(5)) {
        std::vector<std::string> pieces = pieces_of(text, (byte(0) & 4) != 0);
        std::string& one = pieces[(byte(1) * 256U + byte(2)) % pieces.size()];
        std::string& other = pieces[(byte(3) * 256U + byte(4)) % pieces.size()];
        switch (byte(0) & 3) {
        case 0: one.clear(); break;
        case 1: one += one; break;
        case 2: std::swap(one, other); break;
        default: one = other;
        }
        text.clear();
        for (const std::string& each : pieces)
            text += each;
    }
    return text;
}

/// Returns a text with the changes that follow it behind a zero.
std::string changed_text(std::string_view input) {
    const std::size_t end = std::min(input.find('\0'), input.size());
    return damaged(std::string(input.substr(0, end)), input.substr(std::min(end + 1, input.size())));
}

/// Returns whether a program can change memory in ways that nothing checks.
bool is_unsafe(const std::string& text) {
    static constexpr std::array<std::string_view, 9> words = {"ANY",    "RETYPES", "RESHAPES", "PLACE", "MOVE2D",
                                                              "DRAW2D", "CLIP2D",  "#OPTION",  "LOAD"};
    return std::ranges::any_of(words, [&](std::string_view word) { return text.find(word) != text.npos; });
}

void run(const occam::Code& code, const occam::CodeOptions& options, bool is_safe) {
    const std::uint64_t bytes = 4 * code.workspace_words + code.bytes.size() + code.vector_space_bytes;
    if (bytes > test::BootedCode::memory_bytes / 2)
        return;
    test::BootedCode booted(code, options);
    booted.run(400'000);
    const transputer::Stopped stopped = booted.core().stopped();
    require(!is_safe || stopped == transputer::Stopped::nothing || stopped == transputer::Stopped::by_error,
            "a program that is checked leaves no other memory than its own in disorder");
}

} // namespace

/// The input is a byte for the options, a program, and behind a zero the changes to it.
void compile_occam(const std::string& input) {
    if (input.empty())
        return;
    const auto how = static_cast<unsigned char>(input[0]);
    const std::string text = changed_text(std::string_view(input).substr(1));
    LoadedSource source = check_source("text.occ", text);
    if (!source.problems.empty())
        return;
    Reporter reporter;
    const occam::Parsed parsed =
        occam::parse(source.file, {.folders = {}, .built_in = occam::library_text, .defined = {}}, reporter);
    if (!reporter.failed()) {
        require(!occam::print(*parsed.program).empty() || parsed.program->declarations.empty(),
                "what is read can be printed");
        occam::check(*parsed.program, parsed.options, reporter);
    }
    const bool has_failed = reporter.failed();
    render(reporter.take());
    const occam::Declaration* const main = has_failed ? nullptr : occam::main_procedure(*parsed.program);
    if (!main)
        return;
    const occam::CodeOptions options{
        .model = (how & 1) != 0 ? transputer::Model::t414 : transputer::Model::t800,
        .mode = static_cast<occam::ErrorMode>((how >> 1) % 3),
        .range_checks = (how & 8) == 0,
        .run_time_checks = (how & 16) == 0,
        .vector_space = (how & 32) == 0,
    };
    run(occam::compile(*parsed.program, *main, options), options,
        options.range_checks && options.run_time_checks && !is_unsafe(text));
}

/// The input is a configuration, and behind a zero the changes to it. It is read as it is, and with a VAL set.
void configure_occam(const std::string& input) {
    const std::string text = changed_text(input);
    ReadOptions options;
    options.make_netlist = occam::netlist_of_configuration;
    for (const char* folder : {"examples/occam/sixteen", "tests/occam/configuration/forms"})
        options.include_folders.push_back(std::filesystem::path(PLACEDPAR_SOURCE_DIR) / folder);
    Catalogue kinds;
    kinds.make_from_files(occam::make_file_kinds());
    for (const Overrides& set : {Overrides{}, Overrides{{"workers", "3"}}}) {
        const ReadResult result = read_netlist_text(text, kinds, set, "text.pgm", options);
        render(result);
        require(result.network.has_value() != has_errors(result.diagnostics),
                "what is refused is refused with an error");
        for (const Diagnostic& each : result.diagnostics)
            require(each.location.file != nullptr, "an error has its file");
    }
}

} // namespace placedpar::fuzz
