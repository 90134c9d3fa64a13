#include "tests/occam/check/check_text.hpp"

#include "tests/occam/language/read_text.hpp"
#include "text/diagnostic.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar::test {

CheckedText check_text(const std::string& text, const std::string& shown_path) {
    Reporter reporter;
    ReadText read = read_text(text, shown_path);
    if (read.failed)
        return {std::move(read.parsed), read.messages, true, 1};
    occam::check(*read.parsed.program, read.parsed.options, reporter);
    CheckedText checked{std::move(read.parsed), "", reporter.failed()};
    const std::vector<Diagnostic> diagnostics = reporter.take();
    checked.messages = render(diagnostics) + reporter.not_shown();
    checked.errors = static_cast<std::size_t>(std::ranges::count(diagnostics, Severity::error, &Diagnostic::severity));
    return checked;
}

const occam::Declaration& declared(const CheckedText& checked, const std::string& name) {
    for (const occam::DeclarationBox& each : checked.parsed.program->declarations) {
        if (each->name == name)
            return *each;
    }
    throw std::invalid_argument("not declared: " + name);
}

} // namespace placedpar::test
