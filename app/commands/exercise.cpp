#include "app/command.hpp"
#include "app/exercise/course.hpp"
#include "app/exercise/student_run.hpp"
#include "app/options/booted_options.hpp"
#include "app/options/occam_options.hpp"
#include "app/signals.hpp"
#include "explore/check/check_file.hpp"
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

/// The number of orders of processes that a solution is tried in, besides the usual one.
constexpr std::uint64_t orders = 20;

void list_exercises() {
    for (const Exercise& each : exercises())
        print_out(fmt::format("{:>4}  {}\n", each.number, each.title()));
    print_out(fmt::format("\n{0} exercise NUMBER prints a program to start from, {0} exercise NUMBER FILE checks "
                          "yours.\n",
                          program_name()));
}

ExitCode report(const std::string& file, const StudentRun& made, const std::string& wrong) {
    if (made.end == StudentRun::End::interrupted)
        return ExitCode::interrupted;
    print_out(fmt::format("{}: not solved: {}\n", file, wrong));
    return made.end == StudentRun::End::deadlock ? ExitCode::deadlock : ExitCode::bad_input;
}

ExitCode check_solution(const Options& command, const ExerciseOptions& options) {
    const Exercise exercise = exercise_of(options.number);
    const std::string& file = options.program.file;
    if (!is_occam(file))
        throw UserError(fmt::format("{}: a solution is a program in occam, with a name such as mine.occ", file));
    const Network network = load_network(command, options.program, {});
    InterruptedBySignals interruption;
    for (std::uint64_t order = 0; order <= orders; ++order) {
        const StudentRun made =
            run_student_program(network, order == 0 ? std::nullopt : std::optional(order), interruption);
        std::string wrong = what_is_wrong(made, exercise.expected);
        if (order > 0 && !wrong.empty())
            wrong = fmt::format("it is right in the usual order of its processes, but not in all orders\nwith "
                                "--shuffle {}, {}",
                                order, wrong);
        if (!wrong.empty() || made.end == StudentRun::End::interrupted)
            return report(file, made, wrong);
    }
    print_out(fmt::format("{}: solved; also in {} other orders of its processes\n", file, orders));
    return ExitCode::success;
}

ExitCode exercise(const Options& command, const ExerciseOptions& options) {
    if (!options.program.file.empty())
        return check_solution(command, options);
    if (options.number.empty())
        list_exercises();
    else
        print_out(exercise_of(options.number).start);
    return ExitCode::success;
}

Action declare_exercise(Options& command, const std::string&) {
    auto options = std::make_shared<ExerciseOptions>();
    command.add("NUMBER", options->number, "page and place of an exercise: 3.2; prints a program to start from");
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
