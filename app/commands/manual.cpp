#include "app/command.hpp"
#include "report/manifest.hpp"
#include "text/output_file.hpp"

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/case_conv.hpp>
#include <fmt/format.h>

#include <string>
#include <string_view>

namespace placedpar {

namespace {

/// A text as troff takes it: its own signs escaped, a hyphen as typed, a line that is no request.
std::string troff(std::string_view text) {
    std::string out;
    for (char c : text)
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\n' ? "\n\\&" : std::string(1, c);
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

/// "TYPE", with what is there if nothing is said.
std::string value_of(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0)
        return "";
    std::string by_default = option.get_default_str().empty() ? "" : ", " + option.get_default_str() + " if not given";
    return fmt::format(" \\fI{}\\fR{}", troff(option.get_type_name()), troff(by_default));
}

std::string describe(const CLI::Option& option) {
    bool positional = option.get_positional();
    std::string name = troff(option.get_name(positional, true));
    return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", name, positional ? "" : value_of(option),
                       troff(option.get_description()));
}

std::string describe_options(const CLI::App& app) {
    std::string out;
    for (const CLI::Option* option : app.get_options())
        out += describe(*option);
    return out;
}

/// Lines as they are.
std::string as_typed(const std::string& text) { return text.empty() ? "" : ".PP\n.nf\n\\&" + troff(text) + "\n.fi\n"; }

std::string describe_command(const CLI::App& command) {
    return fmt::format(".SS \"{} {}\"\n{}.\n", troff(program_name()), troff(command.get_name()),
                       troff(command.get_description())) +
           describe_options(command) + as_typed(command.get_footer());
}

std::string manual(const CLI::App& app) {
    std::string page = fmt::format(".TH {} 1 \"\" \"PlacedPar {}\" \"User Commands\"\n",
                                   boost::algorithm::to_upper_copy(troff(program_name())), version);
    page += ".SH NAME\n" + troff(program_name());
    page += " \\- simulator of transputer networks and of the CSP processes placed on them\n";
    page += ".SH SYNOPSIS\n.B " + troff(program_name());
    page += "\n\\fICOMMAND\\fR [\\fIOPTION\\fR]... [\\fIARGUMENT\\fR]...\n";
    page += ".SH DESCRIPTION\n" + troff(app.get_description()) + "\n.SH OPTIONS\n" + describe_options(app);
    page += ".SH COMMANDS\n";
    for (const CLI::App* command : app.get_subcommands({}))
        page += describe_command(*command);
    page += ".SH \"EXIT STATUS\"\n" + as_typed(app.get_footer());
    page += ".SH FILES\ndocs/ and examples/, of which this page and the commands speak, are in the folder "
            "share/doc/placedpar\n"
            "beside the one that holds the program, as in /usr/share/doc/placedpar, and at the top of the sources.\n";
    return page + ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nwhen set and not empty, nothing is coloured on a terminal\n";
}

Action declare_manual(CLI::App& command, const std::string&) {
    return [&command] {
        print_out(manual(*command.get_parent()));
        return ExitCode::success;
    };
}

} // namespace

extern const Command manual_command{
    .name = "manual",
    .about = "Prints the manual page, for man -l -",
    .place = 120,
    .declare = declare_manual,
};

} // namespace placedpar
