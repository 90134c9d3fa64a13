#include "app/program.hpp"

#include "app/command.hpp"
#include "explore/problems.hpp"

#include <filesystem>
#include <utility>

namespace placedpar {

int run_program(int argc, char** argv, std::vector<ProcessKind> own_kinds, std::vector<ProblemFamily> own_problems,
                std::vector<AddPolicy> own_policies, std::vector<DeviceKind> own_devices) {
    add_own_kinds(std::move(own_kinds));
    add_own_devices(std::move(own_devices));
    add_own_problems(std::move(own_problems));
    auto begin = [&] {
        for (AddPolicy add : own_policies)
            add();
    };
    return carry_out({std::filesystem::path(argv[0]).filename().string(), "Runs, checks, shows and studies netlists.",
                      program_commands()},
                     argc, argv, begin);
}

} // namespace placedpar
