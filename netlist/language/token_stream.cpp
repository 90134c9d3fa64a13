#include "netlist/language/token_stream.hpp"

#include "netlist/language/include_path.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

std::filesystem::path real_path(const std::filesystem::path& path) {
    std::error_code error;
    auto result = std::filesystem::weakly_canonical(path, error);
    return error ? path : result;
}

} // namespace

TokenStream::TokenStream(std::shared_ptr<const SourceFile> main, const std::filesystem::path& path, Reporter& reporter,
                         std::vector<std::filesystem::path> include_folders, std::vector<PartOrigin> origins)
    : reporter_(reporter), include_folders_(std::move(include_folders)) {
    open_.push_back({Lexer(std::move(main), reporter, std::move(origins)), real_path(path), {}});
}

const Token& TokenStream::peek(std::size_t ahead) {
    fill(ahead + 1);
    return ahead_[ahead];
}

Token TokenStream::take() {
    fill(1);
    auto token = std::move(ahead_.front());
    ahead_.pop_front();
    behind_last_ = token.end;
    return token;
}

Token TokenStream::next_token() {
    auto& lexer = open_.back().lexer;
    auto token = lexer.next();
    token.end = lexer.here();
    if (++tokens_ > most_tokens)
        reporter_.give_up(token.at, fmt::format("the netlist is too large: it has more than {} words", most_tokens));
    return token;
}

void TokenStream::fill(std::size_t count) {
    while (ahead_.size() < count) {
        auto token = next_token();
        if (token.kind == TokenKind::directive)
            obey(token);
        else if (token.kind == TokenKind::end && open_.size() > 1)
            open_.pop_back();
        else
            ahead_.push_back(std::move(token));
    }
}

void TokenStream::obey(const Token& directive) {
    auto& lexer = open_.back().lexer;
    if (lower_case(directive.text) == "include")
        return include(directive);
    reporter_.error(directive.at, fmt::format("\"#{}\" is not a directive", directive.text),
                    "the only directive is #include \"file\"");
    lexer.skip_line();
}

void TokenStream::include(const Token& directive) {
    auto& lexer = open_.back().lexer;
    auto name = lexer.read_file_name();
    if (!name) {
        reporter_.error(lexer.here(), "#include needs the name of a file in quotes", "#include \"file\"");
        lexer.skip_line();
        return;
    }
    if (++includes_ > most_includes)
        reporter_.give_up(directive.at, fmt::format("the netlist includes more than {} files", most_includes));
    open(*name);
}

/// Returns the folders to search for an included file: the folder of the including file, by its displayed and by its
/// canonical path, then the include folders.
std::vector<std::filesystem::path> TokenStream::folders_for(const Token& name) const {
    std::vector<std::filesystem::path> folders{std::filesystem::path(name.at.file->path()).parent_path(),
                                               open_.back().path.parent_path()};
    folders.insert(folders.end(), include_folders_.begin(), include_folders_.end());
    return folders;
}

void TokenStream::open(const Token& name) {
    auto path = without_backslashes(name.text);
    includes_toolset_ |= is_of_the_toolset(path);
    auto found = find_included(path, folders_for(name));
    if (!found)
        return is_of_the_toolset(path) ? void() : refuse_missing(name);
    auto real = real_path(*found);
    if (includes_itself(real, name))
        return;
    auto loaded = load_source(*found);
    reporter_.add_included(loaded.file, name.at);
    included_.push_back(loaded.file->path());
    included_bytes_ += loaded.file->text().size();
    if (included_bytes_ > most_included_bytes)
        reporter_.give_up(name.at, fmt::format("the netlist includes more than {} bytes", most_included_bytes));
    report_problems(loaded, name);
    if (loaded.problems.empty())
        open_.push_back({Lexer(loaded.file, reporter_), real, name.at});
}

void TokenStream::refuse_missing(const Token& name) {
    std::string folders;
    for (const auto& folder : include_folders_)
        folders += (folders.empty() ? "" : ", ") + folder.string();
    reporter_.error(name.at, fmt::format("cannot include \"{}\": this file does not exist", name.text),
                    folders.empty() ? "-I FOLDER adds a folder to search, besides the folder of the including file"
                                    : "looked in the folder of the including file and in " + folders);
}

/// Returns true, after reporting, if the file includes itself, directly or through others.
bool TokenStream::includes_itself(const std::filesystem::path& real, const Token& name) {
    auto same = std::ranges::find(open_, real, &Open::path);
    if (same == open_.end())
        return false;
    std::vector<SecondPlace> others;
    for (auto between = std::next(same); between != open_.end(); ++between)
        others.push_back({"included here, in the chain by which the file includes itself", between->included_at});
    reporter_.error(name.at, fmt::format("\"{}\" includes itself", name.text), "", std::move(others));
    return true;
}

void TokenStream::report_problems(const LoadedSource& loaded, const Token& name) {
    for (const auto& problem : loaded.problems)
        if (problem.location.line == 0)
            reporter_.error(name.at, fmt::format("cannot include \"{}\": {}", name.text, problem.message));
        else
            reporter_.error(problem.location, problem.message);
}

} // namespace placedpar
