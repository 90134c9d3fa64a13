#include "app/built_with.hpp"
#include "app/command.hpp"
#include "app/options.hpp"
#include "experiments/kit/examples_folder.hpp"
#include "ranks/ranks.hpp"
#include "report/manifest.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <linux/seccomp.h>
#include <sys/prctl.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace placedpar {

namespace {

/// A program or library that PlacedPar needs at run time.
struct RuntimePart {
    const char* name;
    const char* needed_by;
    std::optional<std::string> (*find)(); ///< returns a version or a place; nullopt if the part is missing
    const char* advice;                   ///< what to do if it is missing
};

/// Returns the first line that a command of the shell prints. Returns nullopt if it prints nothing or fails.
std::optional<std::string> first_line_of(const char* command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> output(::popen(command, "r"), ::pclose);
    std::array<char, 256> line{};
    if (!output || !std::fgets(line.data(), line.size(), output.get()))
        return std::nullopt;
    std::string text = line.data();
    while (std::fgets(line.data(), line.size(), output.get())) {
    } // the rest is read, too, because a program may print an error if its output is closed early
    return text.substr(0, text.find_last_not_of(" \n") + 1);
}

std::optional<std::string> find_examples() try { return examples_folder().string(); } catch (const UserError&) {
    return std::nullopt;
}

std::optional<std::string> find_gnuplot() { return first_line_of("gnuplot --version 2>/dev/null"); }

std::optional<std::string> find_mpirun() { return first_line_of("mpirun --version 2>/dev/null"); }

std::optional<std::string> find_module_of_ranks() {
    const std::filesystem::path module = module_of_ranks();
    return module.empty() ? std::nullopt : std::optional(module.string());
}

/// Returns whether the kernel can filter system calls, which `serve` needs. Tries to install a filter at address 0: a
/// kernel with filters refuses the address, a kernel without filters refuses the call.
std::optional<std::string> find_filters_of_calls() {
    const bool refused = ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr, 0, 0) < 0;
    return refused && errno == EFAULT ? std::optional<std::string>("yes") : std::nullopt;
}

std::optional<std::string> find_python() {
    return first_line_of("python3 -c 'import placedpar as p; print(p.__version__, p.__path__[0])' 2>/dev/null");
}

std::optional<std::string> find_numpy() {
    return first_line_of("python3 -c 'import numpy; print(numpy.__version__)' 2>/dev/null");
}

std::optional<std::string> find_pandas() {
    return first_line_of("python3 -c 'import pandas; print(pandas.__version__)' 2>/dev/null");
}

constexpr std::array runtime_parts{
    RuntimePart{"examples", "replay, serve, and the commands of the documents", find_examples,
                "set PLACEDPAR_EXAMPLES to the folder with the examples"},
    RuntimePart{"gnuplot", "plots of run, report, replay, optimise, identify", find_gnuplot,
                "apt-get install gnuplot-nox"},
    RuntimePart{"mpirun", "run --native, sweep and calibrate on ranks", find_mpirun, "apt-get install openmpi-bin"},
    RuntimePart{"module of ranks", "run --native, sweep and calibrate on ranks", find_module_of_ranks,
                "apt-get install libboost-mpi-dev (on Debian 12 libboost-mpi1.81-dev), then configure and build again"},
    RuntimePart{"seccomp filters", "serve and mark", find_filters_of_calls,
                "use a Linux kernel with CONFIG_SECCOMP_FILTER"},
    RuntimePart{"placedpar in Python", "import placedpar", find_python,
                "run cmake --install, or set PYTHONPATH to the folder `python` of the build"},
    RuntimePart{"NumPy", "searches in Python", find_numpy, "apt-get install python3-numpy"},
    RuntimePart{"pandas", "tables and identify in Python", find_pandas, "apt-get install python3-pandas"},
};

std::string print_part(const RuntimePart& part) {
    const std::optional<std::string> found = part.find();
    return fmt::format("{:<20} {:<48} {}\n", part.name, part.needed_by,
                       found ? *found : fmt::format("missing: {}", part.advice));
}

ExitCode doctor() {
    std::string out =
        fmt::format("placedpar {}\nbuilt with {}\n{} processor cores\n\n{:<20} {:<48} {}\n", version_text(), built_with,
                    std::thread::hardware_concurrency(), "part", "needed by", "found");
    for (const RuntimePart& part : runtime_parts)
        out += print_part(part);
    print_out(out);
    return ExitCode::success;
}

Action declare_doctor(Options&, const std::string&) { return doctor; }

} // namespace

extern const Command doctor_command{
    .name = "doctor",
    .about = "Lists the programs and libraries that commands need, with versions, and says which are missing",
    .place = 95,
    .declare = declare_doctor,
};

} // namespace placedpar
