#include "netlist/read.hpp"

#include "netlist/complete/complete.hpp"
#include "netlist/elaborate/elaborator.hpp"
#include "netlist/language/parser.hpp"
#include "netlist/print/print.hpp"

#include <algorithm>

namespace placedpar {

namespace {

std::optional<Network> read_source(const LoadedSource& source, const std::filesystem::path& path,
                                   const Catalogue& catalogue, const Overrides& overrides, Reporter& reporter) {
    for (const auto& problem : source.problems)
        reporter.error(problem.location, problem.message);
    if (reporter.failed())
        return std::nullopt;
    TokenStream tokens(source.file, path, reporter);
    auto statements = Parser(tokens, reporter).parse_netlist();
    if (reporter.failed())
        return std::nullopt;
    Elaborator elaborator(catalogue, overrides, reporter);
    elaborator.run(statements);
    elaborator.check_overrides();
    if (reporter.failed())
        return std::nullopt;
    auto network = complete(elaborator.take(), catalogue, reporter);
    if (reporter.failed())
        return std::nullopt;
    network.source_path = source.file->path();
    network.included_paths = tokens.take_included();
    network.hash = network_hash(network);
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
                const Overrides& overrides) {
    Reporter reporter;
    ReadResult result;
    try {
        result.network = read_source(source, path, catalogue, overrides, reporter);
    } catch (const GiveUp&) {
        // the last diagnostic says why
    }
    result.diagnostics = reporter.take();
    sort_by_place(result.diagnostics);
    return result;
}

} // namespace

ReadResult read_netlist(const std::filesystem::path& path, const Catalogue& catalogue, const Overrides& overrides) {
    return read(load_source(path), path, catalogue, overrides);
}

ReadResult read_netlist_text(const std::string& text, const Catalogue& catalogue, const Overrides& overrides,
                             const std::string& shown_path) {
    return read(check_source(shown_path, text), shown_path, catalogue, overrides);
}

} // namespace placedpar
