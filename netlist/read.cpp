#include "netlist/read.hpp"

#include "netlist/complete/complete.hpp"
#include "netlist/elaborate/elaborator.hpp"
#include "netlist/elaborate/option_statements.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "netlist/language/characters.hpp"
#include "netlist/language/occam.hpp"
#include "netlist/language/parser.hpp"
#include "netlist/print/print.hpp"
#include "text/standard_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>

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

/// Returns an upper limit of the number of tokens in the text. This function is faster than count_words(), which finds
/// the exact number. REQUIRES: the text has no illegal tokens.
std::size_t most_words_in(std::string_view printed) {
    std::size_t count = 0;
    bool in_word = false;
    for (char c : printed) {
        const bool goes_on = in_name(c);
        count += (goes_on && !in_word) || (!goes_on && c != ' ' && c != '\n');
        in_word = goes_on;
    }
    return count;
}

/// Refuses a network whose printed text would be too large to be read again. Replication can make the printed text
/// larger than the netlist.
void check_size(WrittenOut out, const Location& at, Reporter& reporter) {
    if (out.bytes > largest_source_bytes)
        reporter.give_up(at, fmt::format("the network is too large: written out it would have {} bytes, but at "
                                         "most {} bytes are allowed",
                                         out.bytes, largest_source_bytes));
    if (most_words_in(out.text) > most_tokens && count_words(std::move(out.text)) > most_tokens)
        reporter.give_up(
            at, fmt::format("the network is too large: written out it would have more than {} words", most_tokens));
}

/// Returns a hint if the text looks like a file with a transputer's machine code, which is not a netlist; otherwise "".
std::string hint_for(const std::string& text) {
    const auto is_odd = [](char c) { return static_cast<unsigned char>(c) < 9 || static_cast<unsigned char>(c) > 126; };
    if (text.size() < 16 || static_cast<std::size_t>(std::ranges::count_if(text, is_odd)) < text.size() / 8)
        return "";
    const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    const std::string why_not = why_not_bootable(bytes);
    return why_not.empty()
               ? "this file boots a transputer: placedpar run executes it; in a netlist, write use \"FILE\" for root;"
               : why_not;
}

bool is_standard_input(const SourceFile& file) { return file.path() == shown_input("-"); }

/// If the text is occam, or source text of the assembler, replaces all errors by one error that says so.
void recognise_occam(const std::shared_ptr<const SourceFile>& main, Reporter& reporter) {
    if (main->path().ends_with(".tas"))
        return reporter.replace_all({main, 0, 0},
                                    "this is a program in transputer instructions, not a netlist: placedpar assemble "
                                    "makes a bootable file of it",
                                    "");
    auto found = occam_in(main);
    if (auto first = reporter.first_file(); !found && first)
        found = occam_in(first);
    if (found && is_standard_input(*main))
        reporter.replace_all(found->at, "this is occam, but standard input is read as a netlist",
                             "write the program into a file whose name ends in .occ");
    else if (found)
        reporter.replace_all(
            found->at,
            "this is occam, but a netlist is written in the configuration language of the C toolset (icconf)",
            found->hint);
}

Declared declared_in(const Draft& draft) {
    auto executes = [](const Node& node) { return node.kind && node.kind->has_executive(); };
    return {static_cast<std::size_t>(std::ranges::count_if(draft.nodes, executes)), draft.processes.size()};
}

/// Sorts the diagnostics by file, then by line and column. Files keep the order in which they first appear.
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

/// Adds the source files in occam from which kinds were made to the network's list of input files.
void add_program_paths(Network& network, const Catalogue& catalogue) {
    std::set<std::string> known;
    for (const ProcessInstance& process : network.processes)
        if (process.is_code && known.insert(process.kind).second)
            for (const std::string& path : catalogue.files()->files_of(process.kind))
                if (std::ranges::find(network.included_paths, path) == network.included_paths.end())
                    network.included_paths.push_back(path);
}

} // namespace

std::string render(const ReadResult& result) { return render(result.diagnostics) + result.not_shown; }

/// Holds the results of parsing the text, from which networks with different values of options are made, and the
/// options that all these networks share.
struct ParsedNetlist::Syntax {
    struct Content {
        std::string (*translate_hint)(const std::string&) = nullptr; ///< see MadeNetlist; null if the file is a netlist
        Statements statements = {};
        std::vector<std::string> included_paths = {};
        CompiledPrograms compiled = {};
        bool includes_toolset = false;
    };

    Syntax(const LoadedSource& source, const std::filesystem::path& path, const ReadOptions& options);
    Content parse(const ValChoice&, Reporter&) const;
    /// Returns whether a netlist that was made from a file in occam must be made again, because an option may set a VAL
    /// of this file.
    bool is_made_again(const Overrides& overrides) const {
        return content.translate_hint && !overrides.empty() && !found.failed();
    }
    /// Returns the network; nothing if the reporter has errors. REQUIRES: the reporter already has the diagnostics of
    /// `found`, unless the netlist is made again.
    std::optional<Network> network(const Catalogue&, const Overrides&, Reporter&, Declared&) const;

    std::shared_ptr<const SourceFile> file;
    std::filesystem::path path;
    ReadOptions options;
    Reporter found; ///< diagnostics of reading and parsing
    Content content;
};

ParsedNetlist::Syntax::Syntax(const LoadedSource& source, const std::filesystem::path& from, const ReadOptions& read)
    : file(source.file), path(from), options(read) {
    for (const auto& problem : source.problems)
        found.error(problem.location, problem.message, hint_for(file->text()));
    if (!found.failed())
        content = parse({}, found);
}

ParsedNetlist::Syntax::Content ParsedNetlist::Syntax::parse(const ValChoice& choose, Reporter& reporter) const {
    Content parsed;
    MadeNetlist made;
    if (options.make_netlist)
        made = options.make_netlist(file, options.include_folders, choose, reporter);
    parsed.translate_hint = made.translate_hint;
    if (reporter.failed())
        return parsed;
    TokenStream tokens(made.text ? made.text : file, path, reporter, options.include_folders, std::move(made.origins));
    attempt([&] { parsed.statements = Parser(tokens, reporter).parse_netlist(); });
    if (reporter.failed() && !made.text)
        recognise_occam(file, reporter);
    parsed.included_paths = tokens.take_included();
    parsed.included_paths.insert(parsed.included_paths.end(), made.paths.begin(), made.paths.end());
    parsed.compiled = std::move(made.compiled);
    parsed.includes_toolset = tokens.includes_toolset();
    return parsed;
}

std::optional<Network> ParsedNetlist::Syntax::network(const Catalogue& catalogue, const Overrides& overrides,
                                                      Reporter& reporter, Declared& declared) const {
    if (reporter.failed())
        return std::nullopt;
    const Statements set = read_overrides(overrides, reporter);
    Elaborator elaborator(catalogue, set, reporter);
    std::optional<Content> again;
    if (is_made_again(overrides) && !reporter.failed())
        again = parse([&](const auto&... val) { return elaborator.choose_val(val...); }, reporter);
    const Content& stated = again ? *again : content;
    elaborator.run(stated.statements);
    declared = declared_in(elaborator.draft());
    const Statements faults = read_faults(options.faults, reporter);
    elaborator.run(faults);
    if (reporter.failed())
        return std::nullopt;
    elaborator.use(options.programs);
    elaborator.read_files(options.include_folders);
    if (reporter.failed())
        return std::nullopt;
    elaborator.run(set);
    auto network = complete(elaborator.take(), catalogue, reporter, stated.compiled);
    if (reporter.failed())
        return std::nullopt;
    network.source_path = file->path();
    network.included_paths = stated.included_paths;
    add_program_paths(network, catalogue);
    network.includes_toolset = stated.includes_toolset;
    WrittenOut out = write_out(network, largest_source_bytes);
    network.hash = out.hash;
    check_size(std::move(out), {file, 0, 0}, reporter);
    return network;
}

ParsedNetlist::ParsedNetlist(const std::filesystem::path& path, const ReadOptions& options)
    : syntax_(std::make_shared<const Syntax>(load_input(path), path, options)) {}

ParsedNetlist ParsedNetlist::of_text(const std::string& text, const std::string& shown_path,
                                     const ReadOptions& options) {
    return ParsedNetlist(std::make_shared<const Syntax>(check_source(shown_path, text), shown_path, options));
}

ReadResult ParsedNetlist::read(const Catalogue& catalogue, const Overrides& overrides) const {
    Reporter reporter = syntax_->is_made_again(overrides) ? Reporter() : syntax_->found;
    ReadResult result;
    try {
        result.network = syntax_->network(catalogue, overrides, reporter, result.declared);
    } catch (const GiveUp&) {
        // the reporter gave up; its last diagnostic states the reason
    }
    result.diagnostics = reporter.take();
    result.not_shown = reporter.not_shown();
    sort_by_place(result.diagnostics);
    if (const auto translate = syntax_->content.translate_hint)
        for (Diagnostic& each : result.diagnostics)
            each.hint = translate(each.hint);
    return result;
}

ReadResult read_netlist(const std::filesystem::path& path, const Catalogue& catalogue, const Overrides& overrides,
                        const ReadOptions& options) {
    return ParsedNetlist(path, options).read(catalogue, overrides);
}

ReadResult read_netlist_text(const std::string& text, const Catalogue& catalogue, const Overrides& overrides,
                             const std::string& shown_path, const ReadOptions& options) {
    return ParsedNetlist::of_text(text, shown_path, options).read(catalogue, overrides);
}

} // namespace placedpar
