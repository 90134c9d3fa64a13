#include "netlist/language/token_stream.hpp"

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

TokenStream::TokenStream(std::shared_ptr<const SourceFile> main, const std::filesystem::path& path, Reporter& reporter)
    : reporter_(reporter) {
    open_.push_back({Lexer(std::move(main), reporter), real_path(path), {}});
}

const Token& TokenStream::peek(std::size_t ahead) {
    fill(ahead + 1);
    return ahead_[ahead];
}

Token TokenStream::take() {
    fill(1);
    auto token = std::move(ahead_.front());
    ahead_.pop_front();
    return token;
}

void TokenStream::fill(std::size_t count) {
    while (ahead_.size() < count) {
        auto token = open_.back().lexer.next();
        if (++tokens_ > most_tokens)
            reporter_.give_up(token.at,
                              fmt::format("the netlist is too large: it has more than {} words", most_tokens));
        if (token.kind == TokenKind::directive)
            include(token);
        else if (token.kind == TokenKind::end && open_.size() > 1)
            open_.pop_back();
        else
            ahead_.push_back(std::move(token));
    }
}

void TokenStream::include(const Token& directive) {
    if (directive.text != "include") {
        reporter_.error(directive.at, fmt::format("\"#{}\" is no directive", directive.text),
                        "there is only #include \"file\"");
        open_.back().lexer.skip_line();
        return;
    }
    auto name = open_.back().lexer.next();
    if (name.kind != TokenKind::text || name.text.empty()) {
        reporter_.error(name.at, "#include needs the name of a file in quotes", "#include \"file\"");
        if (name.at.line == directive.at.line)
            open_.back().lexer.skip_line();
        else if (name.kind != TokenKind::end)
            ahead_.push_back(std::move(name));
        return;
    }
    if (++includes_ > most_includes)
        reporter_.give_up(directive.at, fmt::format("more than {} files are included", most_includes));
    open(open_.back().path.parent_path() / name.text, name, directive);
}

void TokenStream::open(const std::filesystem::path& path, const Token& name, const Token& directive) {
    auto real = real_path(path);
    if (includes_itself(real, name))
        return;
    auto shown = std::filesystem::path(directive.at.file->path()).parent_path() / name.text;
    std::error_code error;
    auto loaded = load_source(std::filesystem::exists(shown, error) ? shown : real);
    included_.push_back(loaded.file->path());
    included_bytes_ += loaded.file->text().size();
    if (included_bytes_ > most_included_bytes)
        reporter_.give_up(name.at, fmt::format("more than {} bytes are included", most_included_bytes));
    report_problems(loaded, name);
    if (loaded.problems.empty())
        open_.push_back({Lexer(loaded.file, reporter_), real, name.at});
}

/// Whether it does; then that is reported.
bool TokenStream::includes_itself(const std::filesystem::path& real, const Token& name) {
    auto same = std::ranges::find(open_, real, &Open::path);
    if (same == open_.end())
        return false;
    std::vector<SecondPlace> others;
    for (auto between = std::next(same); between != open_.end(); ++between)
        others.push_back({"on the way from the file to itself, included here", between->included_at});
    reporter_.error(name.at, fmt::format("\"{}\" includes itself", name.text), "", std::move(others));
    return true;
}

void TokenStream::report_problems(const LoadedSource& loaded, const Token& name) {
    for (const auto& problem : loaded.problems)
        if (problem.location.line == 0)
            reporter_.error(name.at, fmt::format("cannot include \"{}\": {}", name.text, problem.message));
        else
            reporter_.error(problem.location, problem.message, "", {{"included here", name.at}});
}

} // namespace placedpar
