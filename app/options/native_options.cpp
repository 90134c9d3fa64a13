#include "app/options/native_options.hpp"

#include "app/options/common_options.hpp"
#include "explore/problems.hpp"
#include "explore/workers.hpp"
#include "native/native_run.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace placedpar {

namespace {

constexpr std::size_t most_threads = 1024; // our choice, far more than computers have cores

/// The kinds of the processes of one thread, with problems of its own, which may keep what they have computed.
struct KindsOfThread {
    KindsOfThread(std::uint64_t seed, SearchObserver* observer)
        : problems(known_problems(seed)), catalogue(known_kinds(problems, observer)) {}
    ProblemRegistry problems;
    Catalogue catalogue;
};

std::size_t threads_of(const NativeOptions& options, const Network& network) {
    const std::size_t useful = std::max<std::size_t>(count_native_nodes(network), 1);
    return std::min(options.threads == 0 ? count_cores() : options.threads, useful);
}

} // namespace

void add_native(Options& command, NativeOptions& options) {
    command.add_flag("--native", options.is_native,
                     "runs the processes on threads of this computer, and measures their times by its clock");
    add_threads(command, options.threads);
}

void add_threads(Options& command, std::size_t& threads) {
    add_number(command, "--threads", threads, 1, most_threads,
               "number of threads of a native run; by default one for each core");
}

void refuse_with_native(const NativeOptions& options, bool predicts,
                        const std::vector<std::pair<bool, const char*>>& typed) {
    if (options.is_native && predicts)
        throw UserError("--predict simulates a native run: leave out --native, or --predict");
    if (!options.is_native && !predicts && options.threads != 0)
        throw UserError("--threads is for native runs: give --native, too");
    if (options.is_native)
        for (const auto& [is_typed, name] : typed)
            if (is_typed)
                throw UserError(fmt::format("{}: only simulated runs have this option: leave out --native", name));
}

RunReport run_natively(const Network& network, const NativeOptions& options, std::uint64_t seed,
                       SearchObserver* observer, const Interruption& interruption) {
    std::optional<OneEventAtATime> in_turns;
    if (observer)
        in_turns.emplace(*observer);
    NativeSettings settings;
    settings.seed = seed;
    settings.threads = threads_of(options, network);
    settings.make_catalogue = [&]() -> std::shared_ptr<const Catalogue> {
        const auto kinds = std::make_shared<KindsOfThread>(seed, in_turns ? &*in_turns : nullptr);
        return {kinds, &kinds->catalogue};
    };
    settings.is_interrupted = [&interruption] { return interruption.requested(); };
    return run_natively(network, settings);
}

} // namespace placedpar
