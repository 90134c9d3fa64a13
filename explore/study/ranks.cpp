#include "explore/study/ranks.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace placedpar {

namespace {

/// Returns whether Open MPI, or Slurm with PMIx, started this process: each sets a variable of the environment.
bool started_as_rank() {
    return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMIX_NAMESPACE") != nullptr;
}

/// Loads the module from the program's folder, from the folder of the installation, or as the system's linker finds it.
void* load_module() {
    const std::filesystem::path name = "placedpar_mpi.so";
    std::error_code unknown;
    std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
    for (const auto& path : {folder / name, folder.parent_path() / "lib" / "placedpar" / name, name})
        if (void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL)) // global for Open MPI's own modules
            return module;
    return nullptr;
}

} // namespace

std::unique_ptr<Ranks> ranks_of_mpirun() {
    if (!started_as_rank())
        return nullptr;
    void* module = load_module();
    if (!module)
        throw UserError("mpirun started this PlacedPar, which was built without MPI: install "
                        "libboost-mpi1.81-dev and openmpi-bin, then configure and build PlacedPar again");
    using Make = Ranks*();
    return std::unique_ptr<Ranks>(reinterpret_cast<Make*>(dlsym(module, "placedpar_mpi_ranks"))());
}

bool left_to_rank_zero(const std::string& command) {
    std::unique_ptr<Ranks> ranks = ranks_of_mpirun();
    if (!ranks || ranks->count() == 1)
        return false;
    if (ranks->own() == 0)
        throw UserError(fmt::format("{} ranks of mpirun would each make the same runs: {} already uses all cores "
                                    "of one machine, so start it without mpirun; only sweep shares its runs "
                                    "among ranks",
                                    ranks->count(), command));
    return true;
}

} // namespace placedpar
