#include "bench/identification/contest.hpp"

#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "identification/on_line/population_set.hpp"
#include "runtime/vector_width.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace placedpar {

using namespace hydraulics;

namespace {

/// All contestants use the same random stream, so that their answers agree.
constexpr const char* stream = "search";

std::uint64_t all_evaluations(const Transient& transient) {
    std::uint64_t samples = 0;
    for (std::size_t i = 0; i < transient.windows(); ++i)
        samples += transient.window_at(i).size();
    return samples * Transient::trials * Transient::population;
}

/// The algorithm as an engineer would write it for this problem alone, with integers and loops.
class PlainLoop {
public:
    explicit PlainLoop(const Transient& transient) : transient_(transient), random_(transient.seed, stream) {}

    Answer identify() {
        draw_all();
        for (std::size_t window = 0; window < transient_.windows(); ++window)
            for (std::size_t trial = 0; trial < Transient::trials; ++trial) {
                for (std::size_t i = 0; i < count; ++i)
                    fitness_[i] = transient_.fitness(compliance(codes_[i]), transient_.window_at(window));
                best_ = codes_[static_cast<std::size_t>(std::max_element(fitness_.begin(), fitness_.end()) -
                                                        fitness_.begin())];
                next_generation();
            }
        return {compliance(best_), all_evaluations(transient_)};
    }

private:
    static constexpr std::size_t count = Transient::population;
    static constexpr std::uint32_t length = Transient::bits;

    static double compliance(std::uint32_t code) { return Transient::largest * code / (1u << length); }
    void draw_all() {
        for (std::uint32_t& code : codes_)
            code = random_() >> (32 - length);
    }
    void next_generation() {
        double sum = 0;
        for (double each : fitness_)
            sum += std::max(each, 0.0);
        if (!(sum > 0))
            return draw_all();
        std::array<std::uint32_t, count> parents = codes_;
        for (std::uint32_t& code : codes_) {
            double ball = random_.uniform() * sum, end = 0;
            std::size_t i = 0;
            while ((end += std::max(fitness_[i], 0.0)) <= ball)
                ++i;
            code = parents[i];
        }
        for (std::size_t i = 0; i + 1 < count; i += 2)
            if (random_.chance(Transient::crossover)) {
                std::uint32_t cut = 1 + random_.below(length - 1);
                std::uint32_t difference = (codes_[i] ^ codes_[i + 1]) >> (length - cut) << (length - cut);
                codes_[i] ^= difference;
                codes_[i + 1] ^= difference;
            }
        for (std::uint32_t& code : codes_)
            for (std::uint32_t bit = 0; bit < length; ++bit)
                if (random_.chance(Transient::mutation))
                    code ^= 1u << (length - 1 - bit);
    }

    const Transient& transient_;
    RandomStream random_;
    std::array<std::uint32_t, count> codes_{};
    std::array<double, count> fitness_{};
    std::uint32_t best_ = 0;
};

std::vector<Sample> plain_numbers(const Transient& transient) {
    std::vector<Sample> record;
    for (const LinkSample& each : transient.record)
        record.push_back(
            {each.inlet_psi, each.inlet_slope_psi_per_s, each.piston_flow_in3_per_s, each.inlet_in2, each.bypass_in2});
    return record;
}

/// Uses the library, but evaluates the individuals one by one through the virtual function.
Answer one_by_one(const Transient& transient) {
    auto problem = make_search_problem(CircuitProblem(boom_circuit(), transient.flow));
    Search search(problem->bits(), {}, RandomStream(transient.seed, stream));
    SlidingWindow window{WindowSettings{}};
    std::vector<double> fitness(search.population().size());
    for (const Sample& sample : plain_numbers(transient)) {
        window.push(sample);
        for (std::size_t trial = 0; window.ready() && trial < Transient::trials; ++trial) {
            for (std::size_t i = 0; i < fitness.size(); ++i)
                fitness[i] = problem->fitness(search.population()[i], window.samples(), Transient::bias);
            search.next_generation(fitness);
        }
    }
    return {problem->decode(search.best().genome).at(0), all_evaluations(transient)};
}

Answer with(const Transient& transient, const SearchSettings& settings, Coding coding) {
    auto problem = make_search_problem(CircuitProblem(boom_circuit(), transient.flow), coding);
    SearchResult result =
        run_traditional(*problem, plain_numbers(transient), settings, RandomStream(transient.seed, stream));
    return {result.estimates.back().parameters.at(0), all_evaluations(transient)};
}

Answer thesis_way(const Transient& transient) { return with(transient, {}, Coding::natural); }

Answer universal(const Transient& transient) {
    SearchSettings settings;
    settings.elite = 1;
    settings.reproduction = UniversalReproduction{};
    return with(transient, settings, Coding::gray);
}

/// Does everything that the monitor and the command do with a link's samples: the search, the gate, the medians and the
/// standard errors.
Answer serve(const Transient& transient, std::size_t width, Mutation mutation) {
    identification::DiagnosisSettings settings;
    settings.search.mutation = mutation;
    const LinkSet boom{Link::boom};
    const identification::SetProblem problem(Configuration::a, boom, transient.flow, settings.bits);
    use_vector_width(width);
    identification::PopulationSet set(boom, settings, transient.seed, stream);
    double time_s = 0;
    for (const LinkSample& sample : transient.record)
        set.take(problem, {sample}, time_s += 0.02);
    use_vector_width(widest_vector_width());
    if (set.state().generations != transient.windows() * Transient::trials)
        throw std::logic_error("the service has not made the expected number of generations");
    return {set.state().estimates.front().compliance_in3_per_psi().value(), 0};
}

template <std::size_t width>
Answer service(const Transient& transient) {
    return serve(transient, width, BitMutation{});
}
template <std::size_t width>
Answer distances(const Transient& transient) {
    return serve(transient, width, DistanceMutation{});
}

} // namespace

std::vector<Contestant> ours() {
    std::vector<Contestant> all{
        {"plain scalar loop", [](const Transient& transient) { return PlainLoop(transient).identify(); }, 0},
        {"PlacedPar, one by one", one_by_one, 0},
        {"PlacedPar, vectorised", thesis_way, 0},
        {"... Gray, elite, universal", universal, 1},
        {"the service, 2 doubles", service<2>, 2}};
    if (widest_vector_width() >= 4)
        all.push_back({"the service, 4 doubles", service<4>, 2});
    if (widest_vector_width() >= 8)
        all.push_back({"the service, 8 doubles", service<8>, 2});
    all.push_back({"... distance, 2 doubles", distances<2>, 3});
    if (widest_vector_width() >= 4)
        all.push_back({"... distance, 4 doubles", distances<4>, 3});
    if (widest_vector_width() >= 8)
        all.push_back({"... distance, 8 doubles", distances<8>, 3});
    return all;
}

} // namespace placedpar
