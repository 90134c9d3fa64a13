#include "explore/problems.hpp"

#include "classics/kinds.hpp"
#include "gaprocs/guarded_problem.hpp"
#include "gaprocs/processes/kinds.hpp"
#include "gaprocs/search_problem.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/circuit_problem.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/language/parser.hpp"
#include "occam/network/file_kinds.hpp"
#include "problems/benchmark/benchmark.hpp"
#include "problems/plant/coefficients.hpp"
#include "problems/plant/plant_family.hpp"
#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

using namespace hydraulics;

namespace {

/// The problem of finding the compliances of an excavator's hydraulic circuit, in measurements that were simulated with
/// known compliances.
struct SimulatedCircuit : CircuitProblem {
    std::vector<double> compliance_in3_per_psi;

    std::vector<double> true_parameters() const { return compliance_in3_per_psi; }
};

/// Returns the simulation of the boom in chapter 3 of the thesis, in which the valve opens at once. If `leaking`, adds
/// the leak of section 2.3.2, which begins when the valve opens.
ExcavatorScenario boom_of_chapter_3(bool leaking) {
    constexpr double leak_in3_per_s_psi = 0.004; // the leak takes 7 of 50 in^3/s
    ExcavatorScenario scenario = single_boom_scenario();
    if (leaking)
        scenario.links.front().leak = {leak_in3_per_s_psi, Parameters::excavator()["scenario_a.step_time"]};
    return scenario;
}

/// Returns the motion, which is simulated only once, because the seed affects only the noise of the measurements.
const ExcavatorMotion& motion_of_boom(bool leaking) {
    static const ExcavatorMotion sound = simulate_excavator(boom_of_chapter_3(false));
    static const ExcavatorMotion with_leak = simulate_excavator(boom_of_chapter_3(true));
    return leaking ? with_leak : sound;
}

/// Adds a problem with the boom's motion, measured with the lowest of the noise levels in chapter 3. The valve stays
/// open to the end of the motion, so that the record has the usual number of samples.
void add_boom(ProblemRegistry& problems, std::uint64_t seed, const char* name, AreasFrom from, bool leaking) {
    ExcavatorScenario scenario = boom_of_chapter_3(leaking);
    SimulatedCircuit boom{CircuitProblem(boom_circuit(), scenario.flow),
                          {scenario.links.front().mechanics.inlet_compliance_in3_per_psi}};
    UsableSamples usable;
    auto make = [=] {
        RandomStream noise(seed, "record of the boom");
        return boom_record(
            motion_of_boom(leaking), scenario, low_noise, [&] { return noise.uniform(); }, usable, from);
    };
    problems.add_to_make(name, make_search_problem(std::move(boom)), {usable.count, make});
}

std::vector<ProcessKind>& own_kinds() {
    static std::vector<ProcessKind> kinds;
    return kinds;
}

std::vector<DeviceKind>& own_devices() {
    static std::vector<DeviceKind> kinds;
    return kinds;
}

std::vector<ProblemFamily>& own_problems() {
    static std::vector<ProblemFamily> problems;
    return problems;
}

/// Throws UserError for a name that is already taken.
[[noreturn]] void refuse_taken(const char* what, const std::string& name) {
    throw UserError(fmt::format("this program adds a {0} \"{1}\", but the name is taken: choose another name, "
                                "such as \"own.{2}\"",
                                what, name, name.substr(name.rfind('.') + 1)));
}

void add_own_problem(ProblemRegistry& problems, const ProblemFamily& family) {
    const std::string& name = family.description.name;
    if (auto known = problems.names(); std::ranges::count(known, name) > 0)
        refuse_taken("search problem", name);
    problems.add(family);
}

void add_own_kind(Catalogue& catalogue, const ProcessKind& kind) {
    if (catalogue.find(kind.name) != nullptr)
        refuse_taken("process kind", kind.name);
    ProcessKind added = kind;
    added.is_own = true;
    catalogue.add(std::move(added));
}

void add_own_device(Catalogue& catalogue, const DeviceKind& kind) {
    auto refuse = [](const std::string& name) {
        throw UserError(
            fmt::format("this program adds a device \"{}\", but the name is taken: choose another name", name));
    };
    if (catalogue.devices().contains(kind.name))
        refuse(kind.name);
    for (const DeviceModel& model : kind.models)
        if (!can_be_a_name(model.name))
            throw UserError(
                fmt::format("this program adds a device \"{}\", but no netlist can use this name: choose one "
                            "word that is not reserved",
                            model.name));
        else if (catalogue.node_types().contains(model.name))
            refuse(model.name);
    DeviceKind added = kind;
    added.is_own = true;
    catalogue.add_device(std::move(added));
}

} // namespace

void add_own_kinds(std::vector<ProcessKind> kinds) { std::ranges::move(kinds, std::back_inserter(own_kinds())); }

void add_own_devices(std::vector<DeviceKind> kinds) { std::ranges::move(kinds, std::back_inserter(own_devices())); }

void add_own_problems(std::vector<ProblemFamily> problems) {
    std::ranges::move(problems, std::back_inserter(own_problems()));
}

ProblemRegistry known_problems(std::uint64_t seed, const std::function<ProblemFamily(const ProblemFamily&)>& around) {
    ProblemRegistry problems;
    add_boom(problems, seed, "boom", AreasFrom::spool, false);
    add_boom(problems, seed, "boom-by-voltage", AreasFrom::servo, false);
    add_boom(problems, seed, "leaking-boom", AreasFrom::spool, true);
    problems.add(plant_family(seed));
    problems.add(maximised<Coefficients>());
    add_benchmark_problems(problems);
    for (const ProblemFamily& family : own_problems())
        add_own_problem(problems, around(guarded(family)));
    return problems;
}

Catalogue known_kinds(const ProblemRegistry& problems, SearchObserver* observer, Checkpoints* checkpoints) {
    static const std::shared_ptr<FileKinds> files = occam::make_file_kinds();
    Catalogue catalogue;
    catalogue.make_from_files(files);
    add_csp_kinds(catalogue);
    add_classical_kinds(catalogue);
    add_genetic_algorithm_kinds(catalogue, problems, observer, checkpoints);
    for (const ProcessKind& kind : own_kinds())
        add_own_kind(catalogue, kind);
    for (const DeviceKind& kind : own_devices())
        add_own_device(catalogue, kind);
    return catalogue;
}

} // namespace placedpar
