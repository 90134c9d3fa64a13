#include "ranks/ranks.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <system_error>
#include <thread>

namespace placedpar {

namespace {

/// Returns whether Open MPI, or Slurm with PMIx, started this process: each sets an environment variable.
bool started_as_rank() {
    return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMIX_NAMESPACE") != nullptr;
}

constexpr const char* module_name = "placedpar_mpi.so";

/// Loads the module that sends messages by MPI. If the module is not at its usual path, the system's linker searches
/// for it. Returns null if there is no module.
void* load_module() {
    const std::filesystem::path place = module_of_ranks();
    const std::string path = place.empty() ? module_name : place.string();
    return dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL); // global, so that Open MPI's own modules find its functions
}

} // namespace

std::filesystem::path module_of_ranks() {
    std::error_code unknown;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
    for (const auto& path : {folder / module_name, folder.parent_path() / "lib" / "placedpar" / module_name})
        if (std::filesystem::exists(path, unknown))
            return path;
    return {};
}

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
        throw UserError(fmt::format("{} ranks of mpirun would each make the same runs: start {} without mpirun; only "
                                    "sweep shares its runs among ranks, and only run --native shares its processes",
                                    ranks->count(), command));
    return true;
}

Ranks::Message wait_for_message(Ranks& ranks) {
    for (;;) {
        if (std::optional<Ranks::Message> message = ranks.receive())
            return *message;
        std::this_thread::sleep_for(rank_patience);
    }
}

namespace {

/// The first characters of the texts by which a rank above 0 reports its preparation to rank 0. After `has_prepared`
/// follows what identifies the prepared work, after `has_failed` the reason of the failure.
constexpr char has_prepared = '+', has_failed = '-';

std::string account_of(const std::function<std::string()>& prepare) {
    try {
        return has_prepared + prepare();
    } catch (const std::exception& failure) {
        return has_failed + std::string(failure.what());
    }
}

/// Throws UserError unless the rank has prepared the same work as rank 0.
void require_same(const Ranks::Message& account, const std::string& digest) {
    if (account.text.front() == has_failed)
        throw UserError(fmt::format("rank {}: {}", account.from, account.text.substr(1)));
    if (account.text.substr(1) != digest)
        throw UserError(
            fmt::format("rank {}: its netlist, its options or its version of PlacedPar differ from those of "
                        "rank 0; every machine must have the same files",
                        account.from));
}

/// Runs actions, and keeps the first exception that one of them throws.
class FirstFailure {
public:
    void try_to(const std::function<void()>& action) {
        try {
            action();
        } catch (...) {
            if (!failure_)
                failure_ = std::current_exception();
        }
    }
    bool is_there() const { return failure_ != nullptr; }
    void rethrow() const {
        if (failure_)
            std::rethrow_exception(failure_);
    }

private:
    std::exception_ptr failure_;
};

void send_to_others(Ranks& ranks, const std::string& text) {
    for (int rank = 1; rank < ranks.count(); ++rank)
        ranks.send(rank, text);
}

/// Prepares the work in rank 0, and checks that all other ranks have prepared the same work.
void prepare_first(Ranks& ranks, const std::function<std::string()>& prepare) {
    FirstFailure failure;
    std::string digest;
    failure.try_to([&] { digest = prepare(); });
    for (int others = ranks.count() - 1; others > 0; --others)
        failure.try_to([&] { require_same(wait_for_message(ranks), digest); });
    send_to_others(ranks, failure.is_there() ? "end" : "begin");
    failure.rethrow();
}

/// Prepares the work in a rank above 0, and returns whether rank 0 begins the work.
bool prepare_after(Ranks& ranks, const std::function<std::string()>& prepare) {
    ranks.send(0, account_of(prepare));
    return wait_for_message(ranks).text == "begin";
}

} // namespace

bool all_prepared(Ranks& ranks, const std::function<std::string()>& prepare) {
    if (ranks.own() > 0)
        return prepare_after(ranks, prepare);
    prepare_first(ranks, prepare);
    return true;
}

} // namespace placedpar
