#include "netlist/read.hpp"

#include "netlist/complete/complete.hpp"
#include "netlist/elaborate/elaborator.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/language/occam.hpp"
#include "netlist/language/parser.hpp"
#include "netlist/print/print.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

std::size_t count_words(std::string text) {
    Reporter reporter;
    Lexer lexer(std::make_shared<const SourceFile>("", std::move(text)), reporter);
    std::size_t count = 0;
    while (lexer.next().kind != TokenKind::end)
        ++count;
    return count;
}

/// What is printed of a network that loads must load, too: replicated, a network can be larger than its text.
void check_size(std::string printed, const Location& at, Reporter& reporter) {
    auto bytes = printed.size();
    if (bytes > largest_source_bytes)
        reporter.give_up(at, fmt::format("the network is too large: written out it would have {} bytes, {} are allowed",
                                         bytes, largest_source_bytes));
    if (bytes > most_tokens && count_words(std::move(printed)) > most_tokens)
        reporter.give_up(
            at, fmt::format("the network is too large: written out it would have more than {} words", most_tokens));
}

/// What is wrong with a text that is occam is not its words.
void recognise_occam(const std::shared_ptr<const SourceFile>& main, Reporter& reporter) {
    auto found = occam_in(main);
    if (auto first = reporter.first_file(); !found && first)
        found = occam_in(first);
    if (found)
        reporter.replace_all(found->at,
                             "this is occam; a netlist is in the configuration language of the C toolset (icconf)",
                             found->hint);
}

Statements parse(TokenStream& tokens, const LoadedSource& source, Reporter& reporter) try {
    auto statements = Parser(tokens, reporter).parse_netlist();
    if (reporter.failed())
        recognise_occam(source.file, reporter);
    return statements;
} catch (const GiveUp&) {
    recognise_occam(source.file, reporter);
    throw;
}

/// As statements behind those of the netlist.
Statements read_faults(const std::vector<std::string>& texts, Reporter& reporter) {
    Statements statements;
    for (const std::string& text : texts) {
        LoadedSource source = check_source("--fault", text);
        for (const auto& problem : source.problems)
            reporter.error({source.file, 1, 1}, problem.message);
        TokenStream tokens(source.file, "--fault", reporter);
        attempt([&] { statements.push_back(Parser(tokens, reporter).parse_fault_option()); });
    }
    return statements;
}

Declared declared_in(const Draft& draft) {
    auto executes = [](const Node& node) { return node.kind && node.kind->make_executive; };
    return {static_cast<std::size_t>(std::ranges::count_if(draft.nodes, executes)), draft.processes.size()};
}

std::optional<Network> read_source(const LoadedSource& source, const std::filesystem::path& path,
                                   const Catalogue& catalogue, const Overrides& overrides, const ReadOptions& options,
                                   Reporter& reporter, Declared& declared) {
    for (const auto& problem : source.problems)
        reporter.error(problem.location, problem.message);
    if (reporter.failed())
        return std::nullopt;
    TokenStream tokens(source.file, path, reporter, options.include_folders);
    auto statements = parse(tokens, source, reporter);
    if (reporter.failed())
        return std::nullopt;
    Elaborator elaborator(catalogue, overrides, reporter);
    elaborator.run(statements);
    declared = declared_in(elaborator.draft());
    auto faults = read_faults(options.faults, reporter);
    elaborator.run(faults);
    if (reporter.failed())
        return std::nullopt;
    elaborator.settle_overrides();
    if (reporter.failed())
        return std::nullopt;
    auto network = complete(elaborator.take(), catalogue, options.programs, reporter);
    if (reporter.failed())
        return std::nullopt;
    network.source_path = source.file->path();
    network.included_paths = tokens.take_included();
    network.includes_toolset = tokens.includes_toolset();
    network.hash = network_hash(canonical_form(network));
    check_size(print_cfs(network), {source.file, 0, 0}, reporter);
    return network;
}

/// Files in the order in which they first appear among the diagnostics, then by line.
void sort_by_place(std::vector<Diagnostic>& diagnostics) {
    std::vector<const SourceFile*> files;
    auto rank = [&](const Location& location) {
        auto found = std::find(files.begin(), files.end(), location.file.get());
        return found - files.begin();
    };
    for (const auto& diagnostic : diagnostics)
        if (std::find(files.begin(), files.end(), diagnostic.location.file.get()) == files.end())
            files.push_back(diagnostic.location.file.get());
    std::stable_sort(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& x, const Diagnostic& y) {
        return std::tuple(rank(x.location), x.location.line, x.location.column) <
               std::tuple(rank(y.location), y.location.line, y.location.column);
    });
}

ReadResult read(const LoadedSource& source, const std::filesystem::path& path, const Catalogue& catalogue,
                const Overrides& overrides, const ReadOptions& options) {
    Reporter reporter;
    ReadResult result;
    try {
        result.network = read_source(source, path, catalogue, overrides, options, reporter, result.declared);
    } catch (const GiveUp&) {
        // the last diagnostic says why
    }
    result.diagnostics = reporter.take();
    result.not_shown = reporter.not_shown();
    sort_by_place(result.diagnostics);
    return result;
}

} // namespace

std::string render(const ReadResult& result) { return render(result.diagnostics) + result.not_shown; }

ReadResult read_netlist(const std::filesystem::path& path, const Catalogue& catalogue, const Overrides& overrides,
                        const ReadOptions& options) {
    return read(load_input(path), path, catalogue, overrides, options);
}

ReadResult read_netlist_text(const std::string& text, const Catalogue& catalogue, const Overrides& overrides,
                             const std::string& shown_path, const ReadOptions& options) {
    return read(check_source(shown_path, text), shown_path, catalogue, overrides, options);
}

} // namespace placedpar
