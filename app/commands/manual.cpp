#include "app/command.hpp"
#include "app/options.hpp"
#include "report/manifest.hpp"
#include "text/output_file.hpp"

#include <boost/algorithm/string/case_conv.hpp>
#include <fmt/format.h>

#include <string>
#include <string_view>

namespace placedpar {

namespace {

/// Escapes a text for troff: its special characters, hyphens, and lines that would be taken for a request.
std::string troff(std::string_view text) {
    std::string out;
    for (char c : text)
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\n' ? "\n\\&" : std::string(1, c);
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

/// Returns the option's type and default value, such as "N, 20 if not given".
std::string value_of(const DeclaredOption& option) {
    if (!option.takes_value)
        return "";
    std::string by_default = option.value.empty() ? "" : ", " + option.value + " if not given";
    return fmt::format(" \\fI{}\\fR{}", troff(option.type), troff(by_default));
}

std::string describe(const DeclaredOption& option) {
    return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", troff(option.label), option.names.empty() ? "" : value_of(option),
                       troff(option.about));
}

std::string describe_options(const DeclaredCommand& command) {
    std::string out;
    for (const DeclaredOption& option : command.options)
        out += describe(option);
    return out;
}

/// Returns the lines unchanged, as a block.
std::string as_typed(const std::string& text) { return text.empty() ? "" : ".PP\n.nf\n\\&" + troff(text) + "\n.fi\n"; }

std::string describe_command(const DeclaredCommand& command) {
    return fmt::format(".SS \"{} {}\"\n{}.\n", troff(program_name()), troff(command.name), troff(command.about)) +
           describe_options(command) + as_typed(command.footer);
}

std::string manual(const DeclaredCommand& program) {
    std::string page = fmt::format(".TH {} 1 \"\" \"PlacedPar {}\" \"User Commands\"\n",
                                   boost::algorithm::to_upper_copy(troff(program_name())), version);
    page += ".SH NAME\n" + troff(program_name());
    page += " \\- simulator of transputer networks and of the CSP processes placed on them\n";
    page += ".SH SYNOPSIS\n.B " + troff(program_name());
    page += "\n\\fICOMMAND\\fR [\\fIOPTION\\fR]... [\\fIARGUMENT\\fR]...\n";
    page += ".SH DESCRIPTION\n" + troff(program.about) + "\n.SH OPTIONS\n" + describe_options(program);
    page += ".SH COMMANDS\n";
    for (const DeclaredCommand& command : program.commands)
        page += describe_command(command);
    page += ".SH \"EXIT STATUS\"\n" + as_typed(program.footer);
    page += ".SH FILES\nThis page and the commands name files in docs/ and examples/. These folders are "
            "installed in\nshare/doc/placedpar, for example /usr/share/doc/placedpar, and are at the top of the "
            "source tree.\n";
    return page + ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nIf this variable is set and not empty, the program prints "
                  "no colours.\n";
}

Action declare_manual(Options& command, const std::string&) {
    return [command] {
        print_out(manual(command.program()));
        return ExitCode::success;
    };
}

} // namespace

extern const Command manual_command{
    .name = "manual",
    .about = "Prints the manual page, which man -l - displays",
    .place = 120,
    .declare = declare_manual,
};

} // namespace placedpar
