#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/estimates.hpp"
#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/peers.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/usual_settings.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/parallel.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

std::size_t samples_to_send(const ProcessEnvironment& environment, std::size_t recorded) {
    auto wanted = static_cast<std::size_t>(environment.integer("samples"));
    if (wanted > recorded)
        throw UserError(fmt::format("samples = {}, but the record of \"{}\" has {}", wanted,
                                    environment.text("problem"), recorded));
    return wanted == 0 ? recorded : wanted;
}

/// Returns the samples of the record. For an objective, returns one empty sample for each generation.
std::vector<Sample> samples_of(const ProcessEnvironment& environment, const RecordedProblem& recorded) {
    if (recorded.problem()->objective())
        return empty_record(static_cast<std::size_t>(environment.integer("generations")));
    auto first = recorded.record().begin();
    return {first, first + static_cast<std::ptrdiff_t>(samples_to_send(environment, recorded.samples()))};
}

/// The host computer's process. Sends every sample to each master, as soon as the master takes it, and receives the
/// estimates.
class Host {
public:
    Host(ProcessEnvironment& environment, const ProblemRegistry& problems)
        : recorded_(problems.find(environment.text("problem"))), samples_(samples_of(environment, recorded_)),
          bytes_(recorded_.problem()->channels() == 0
                     ? 0
                     : static_cast<std::uint32_t>(environment.integer("sample_bytes"))),
          to_masters_(environment.outputs<HostMessage>("to_masters")),
          masters_(peers_at(environment.network(), environment.index(), "to_masters")),
          estimates_(environment, problems) {}

    void run() {
        std::size_t masters = to_masters_.size();
        par_for(masters + estimates_.searches(),
                [&](std::size_t i) { i < masters ? send(i) : estimates_.receive(i - masters); });
        estimates_.report();
    }

private:
    void send(std::size_t master) {
        HostMessage message;
        message.bytes = bytes_;
        for (const Sample& sample : samples_) {
            message.sample = sample;
            to_masters_[master].output(message);
            estimates_.note_taken(masters_[master].process);
        }
        message.end = true;
        to_masters_[master].output(message);
    }

    const RecordedProblem& recorded_;
    std::vector<Sample> samples_;
    std::uint32_t bytes_;
    std::vector<Output<HostMessage>> to_masters_;
    std::vector<Peer> masters_;
    Estimates estimates_;
};

std::vector<MeasurementDescription> host_measurements() {
    std::vector<MeasurementDescription> all{
        {"estimates", "", "how many came back"},
        {"response", "ms", "mean time from when a master took a sample until its estimate arrived"},
        {"longest_response", "ms", "the longest response"},
        {"accurate_after", "ms",
         "time after which the fittest estimate stays accurate; absent if the last estimate is not accurate"},
        {"best_of", "", "the master whose last estimate is the fittest"},
    };
    for (MeasurementDescription& each : search_description::individual_measurements("that estimate"))
        all.push_back(std::move(each));
    return all;
}

} // namespace

ProcessKind host_kind(const ProblemRegistry& problems) {
    using namespace search_description;
    using namespace description;
    return {.name = "ga.host",
            .about = "The host computer's part: sends each sample of the problem's record to every master, as fast as "
                     "they take it, and takes the estimates that come back.",
            .ports = {output<HostMessage>("to_masters", "host message", "an array: one end for each master"),
                      optional(input<EstimateMessage>("from_masters", "estimate",
                                                      "an array: one end for each master whose estimates come back"))},
            .parameters = {problem(),
                           integer("samples", {.unit = "samples", .by_default = 0, .least = 0, .most = 1e9},
                                   "how many samples of the record are sent; 0: all"),
                           integer("generations", {.unit = "generations", .by_default = 100, .least = 1, .most = 1e7},
                                   "how long a problem without a record is searched; each is asked for by an empty "
                                   "sample"),
                           bytes_in_message("sample_bytes", 16, "a sample in a message"),
                           real("accuracy", {.by_default = 0, .least = 0, .most = 1},
                                "greatest relative error of an accurate estimate, against the true parameters of a "
                                "simulated record; 0: not checked")},
            .measurements = host_measurements(),
            .body = [&problems](ProcessEnvironment& environment) { Host(environment, problems).run(); },
            .check = [&problems](const Network& network,
                                 std::size_t process) { return check_host(network, process, problems); },
            .is_determinate = [](const Network& network,
                                 std::size_t process) { // with an accuracy, the order of the host's processes matters
                return std::get<double>(network.processes[process].parameters.at("accuracy")) == 0;
            }};
}

} // namespace placedpar
