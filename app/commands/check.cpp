#include "app/command.hpp"
#include "app/options/netlist_options.hpp"
#include "app/options/occam_options.hpp"
#include "explore/check/check_file.hpp"
#include "explore/occam_program.hpp"
#include "explore/problems.hpp"
#include "report/manifest.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

struct CheckCommandOptions {
    NetlistOptions netlist;
    OccamOptions occam;
    std::string format = "text";
};

/// Prints the warnings and the summary. If the file has errors, throws RefusedInput with the errors and the warnings
/// instead.
void print_checked(const CheckedFile& checked) {
    const std::string text = render(checked.diagnostics) + checked.not_shown;
    if (checked.failed())
        throw RefusedInput(text);
    print_error(text);
    print_out(checked.summary);
}

void refuse_for_programs(const Options& typed, const std::string& file) {
    for (const char* option : {"--set", "--use", "--fault"})
        if (typed.is_given(option) && is_occam(file))
            throw UserError(fmt::format("{} has no effect on {}: the option is for netlists, not for programs in occam",
                                        option, file));
}

ExitCode check(const CheckCommandOptions& options) {
    const ProblemRegistry problems = known_problems(0);
    const CheckedFile checked = check_file(options.netlist.file, known_kinds(problems),
                                           {.set = overrides_of(options.netlist.set),
                                            .read = read_options_of(options.netlist.read),
                                            .program = wanted_checks(options.occam)});
    if (options.format == "json")
        print_out(print_pretty(checked_json(options.netlist.file, checked)));
    else
        print_checked(checked);
    return checked.failed() ? ExitCode::bad_input : ExitCode::success;
}

Action declare_check(Options& command, const std::string&) {
    auto options = std::make_shared<CheckCommandOptions>();
    add_netlist(command, options->netlist);
    command.add("--format", options->format, "output format: text, or JSON with the place and hint of every error")
        .one_of({"text", "json"})
        .show_default();
    add_occam(command, options->occam);
    return [options, command] {
        refuse_for_programs(command, options->netlist.file);
        return check(*options);
    };
}

} // namespace

extern const Command check_command{
    .name = "check",
    .about = "Reads and checks a netlist, a program in occam, or a study",
    .place = 30,
    .declare = declare_check,
};

} // namespace placedpar
