#include "gaprocs/processes/island_exchange.hpp"

#include "gaprocs/processes/island_run.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

/// Returns whether a string has the same fitness on both islands.
bool same_window(const ProcessInstance& a, const ProcessInstance& b) {
    return a.parameters.at("window") == b.parameters.at("window") && a.parameters.at("bias") == b.parameters.at("bias");
}

bool contains(std::span<const std::size_t> numbers, std::size_t number) {
    return std::ranges::find(numbers, number) != numbers.end();
}

} // namespace

IslandExchange::IslandExchange(const ProcessEnvironment& environment, const SearchProblem& problem,
                               const SearchSettings& settings, const Workload& workload)
    : archipelago_(archipelago_of(environment.network())), problem_(problem), bias_(settings.window.bias),
      workload_(workload), emigration_(Emigration::named(environment.text("emigration"))),
      acceptance_(Acceptance::named(environment.text("acceptance"))) {
    const Network& network = environment.network();
    const ProcessInstance& process = network.processes[environment.index()];
    const Archipelago& archipelago = *archipelago_;
    schedule_ = schedule_of(process);
    self_ = archipelago.number_of(environment.index());
    const PlacedIsland& self = archipelago.islands()[self_];
    neighbours_ = self.neighbours;
    has_neighbours_ = !self.ports_to.empty() || !self.ports_from.empty();
    bool over_a_window = !problem.objective();
    samples_to_begin_ = over_a_window ? samples_awaited(network, archipelago, self_) : 0;
    for (std::size_t to : neighbours_)
        outgoing_.push_back(
            std::make_unique<Outgoing>(to, environment.output<Emigrants>(self.ports_to.at(to)), environment.process()));
    for (const auto& [from, port] : self.ports_from) {
        const PlacedIsland& other = archipelago.islands()[from];
        incoming_.push_back(std::make_unique<Incoming>(
            Incoming{from,
                     network.processes[other.process].name,
                     environment.input<Emigrants>(port),
                     other.neighbours,
                     over_a_window && !same_window(process, network.processes[other.process]),
                     {}}));
    }
}

std::vector<Migration> IslandExchange::exchange(Search& search, std::span<const double> fitness,
                                                std::span<const Sample> window) {
    Emigrants emigrants = leaving(search, fitness);
    if (schedule_.in_step())
        exchange_in_step(emigrants, search.generation() + 1);
    else
        exchange_by_mail(emigrants);
    auto arrivals = take_arrivals();
    if (!acceptance_.among_offspring())
        evaluate_arrivals(arrivals, window);
    return arrivals;
}

/// Returns the emigrants. If the exchange has no destinations, returns no emigrants and draws no random numbers.
Emigrants IslandExchange::leaving(Search& search, std::span<const double> fitness) const {
    Emigrants emigrants;
    emigrants.generation = search.generation() + 1;
    if (schedule_.destinations(emigrants.generation, neighbours_).empty())
        return emigrants;
    emigrants.individuals = search.emigrants(fitness, emigration_);
    emigrants.bytes = message_bytes(emigrants.individuals.size(), workload_.string_bytes + workload_.fitness_bytes);
    return emigrants;
}

void IslandExchange::exchange_in_step(const Emigrants& emigrants, std::uint64_t generation) {
    std::vector<Component> components;
    auto destinations = schedule_.destinations(generation, neighbours_);
    for (auto& each : outgoing_)
        if (contains(destinations, each->to))
            components.push_back({[&] { each->output.output(emigrants); }, own_priority()});
    for (auto& each : incoming_)
        if (contains(schedule_.destinations(generation, each->its_neighbours), self_))
            components.push_back({[&] { each->last = each->input.input(); }, own_priority()});
    run_in_parallel(std::move(components), SourceLocation::current());
}

void IslandExchange::exchange_by_mail(const Emigrants& emigrants) {
    for (auto& each : outgoing_)
        if (std::exchange(each->idle, false))
            each->letters.out().output({emigrants});
}

std::vector<Migration> IslandExchange::take_arrivals() {
    std::vector<Migration> arrivals;
    for (auto& each : incoming_) {
        Emigrants taken = std::exchange(each->last, {});
        for (Individual& individual : taken.individuals)
            arrivals.push_back({taken.generation, each->from, self_, std::move(individual), std::nullopt});
    }
    return arrivals;
}

/// Evaluates the immigrants that come from islands with another window. If the schedule is asynchronous, evaluates all
/// immigrants, because older samples may underlie their fitness. All other immigrants keep their fitness, which was
/// computed from the same samples.
void IslandExchange::evaluate_arrivals(std::span<Migration> arrivals, std::span<const Sample> window) const {
    if (problem_.objective())
        return; // an objective is the same on all islands
    for (auto& each : incoming_)
        for (Migration& arrival : arrivals)
            if (arrival.from == each->from && (each->other_window || !schedule_.in_step())) {
                compute(static_cast<std::int64_t>(window.size()) * workload_.error_evaluation);
                arrival.individual.fitness = problem_.fitness(arrival.individual.genome, window, bias_);
            }
}

const std::string& IslandExchange::name_of(std::size_t island) const {
    return (*std::ranges::find(incoming_, island, [](const auto& each) { return each->from; }))->process;
}

void IslandExchange::beside_mail(const std::function<void()>& search) {
    if (schedule_.in_step() || !has_neighbours_)
        return search();
    std::vector<Component> components;
    for (auto& each : outgoing_)
        components.push_back({[&] { send_letters(*each); }, Priority::high});
    for (auto& each : incoming_)
        components.push_back({[&] { receive_letters(*each); }, Priority::high});
    auto search_and_end = [&] {
        search();
        Emigrants end;
        end.end = true;
        for (auto& each : outgoing_)
            each->letters.out().output({end});
    };
    components.push_back({search_and_end, own_priority()});
    run_in_parallel(std::move(components), SourceLocation::current());
}

void IslandExchange::send_letters(Outgoing& outgoing) {
    for (bool end = false; !end;) {
        Emigrants letter = outgoing.letters.in().input().message;
        end = letter.end;
        outgoing.output.output(std::move(letter));
        outgoing.idle = true;
    }
}

void IslandExchange::receive_letters(Incoming& incoming) {
    for (Emigrants letter = incoming.input.input(); !letter.end; letter = incoming.input.input())
        incoming.last = std::move(letter);
}

} // namespace placedpar
