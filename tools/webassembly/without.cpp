// This file replaces what WebAssembly lacks: threads, and the reader of studies (files about experiments with a
// netlist).

#include "explore/check/check_file.hpp"
#include "explore/check/languages.hpp"
#include "explore/workers.hpp"

namespace placedpar {

std::size_t count_cores() { return 1; }

/// Calls work(0), work(1) and so on, one after the other.
void on_workers(std::size_t workers, const std::function<void(std::size_t)>& work,
                const std::function<void()>& meanwhile, std::chrono::milliseconds) {
    for (std::size_t i = 0; i < workers; ++i) {
        work(i);
        meanwhile();
    }
}

CheckedFile check_study(const std::filesystem::path& path, const Catalogue&) {
    CheckedFile checked{.language = "study"};
    checked.diagnostics = {
        fault_of_whole(path, "a page without a server cannot check a study", "\"placedpar check\" checks it")};
    return checked;
}

} // namespace placedpar
