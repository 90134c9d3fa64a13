#include "hydraulics/data/parameters.hpp"
#include "app/command.hpp"
#include "text/output_file.hpp"

namespace placedpar {

namespace {

ExitCode print_parameters() {
    print_out(hydraulics::excavator_text());
    return ExitCode::success;
}

} // namespace

extern const Command parameters_command{
    .name = "parameters",
    .about = "Prints the constants of the excavator in the format that --machine reads",
    .place = 90,
    .declare = [](Options&, const std::string&) -> Action { return print_parameters; },
};

} // namespace placedpar
