#include "app/command.hpp"
#include "app/options/booted_options.hpp"
#include "app/options/occam_options.hpp"
#include "app/signals.hpp"
#include "explore/exercise/course.hpp"
#include "explore/exercise/student_run.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

struct ExerciseOptions {
    std::string number;
    NetlistOptions program;
};

void list_exercises() {
    for (const Exercise& each : exercises())
        print_out(fmt::format("{:>4}  {}\n", each.number, each.title()));
    print_out(fmt::format(
        "\n{0} exercise NUMBER prints a program to start from, {0} exercise NUMBER FILE checks your program.\n",
        program_name()));
}

ExitCode check_program(const Options& command, const ExerciseOptions& options) {
    const Exercise exercise = exercise_of(options.number);
    const std::string& file = options.program.file;
    if (!is_occam(file))
        throw UserError(fmt::format("{}: a solution is a program in occam, with a name such as mine.occ", file));
    InterruptedBySignals interruption;
    const SolutionVerdict verdict = check_solution(load_network(command, options.program, {}), exercise, interruption);
    if (verdict.end == StudentRun::End::interrupted)
        return ExitCode::interrupted;
    print_out(fmt::format("{}: {}\n", file, verdict.text()));
    if (verdict.wrong.empty())
        return ExitCode::success;
    return verdict.end == StudentRun::End::deadlock ? ExitCode::deadlock : ExitCode::bad_input;
}

ExitCode exercise(const Options& command, const ExerciseOptions& options) {
    if (!options.program.file.empty())
        return check_program(command, options);
    if (options.number.empty())
        list_exercises();
    else
        print_out(exercise_of(options.number).start);
    return ExitCode::success;
}

Action declare_exercise(Options& command, const std::string&) {
    auto options = std::make_shared<ExerciseOptions>();
    command.add("NUMBER", options->number, "number of an exercise, such as 3.2; prints a program to start from");
    command.add("FILE", options->program.file, "your program, which is run and checked");
    return [options, command] { return exercise(command, *options); };
}

} // namespace

extern const Command exercise_command{
    .name = "exercise",
    .about = "Prints an exercise of the course in occam, or checks a solution",
    .place = 55,
    .declare = declare_exercise,
    .values = numbers_of_exercises,
};

} // namespace placedpar
