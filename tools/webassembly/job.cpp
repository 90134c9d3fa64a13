#include "explore/check/check_file.hpp"
#include "explore/occam_check.hpp"
#include "explore/occam_program.hpp"
#include "iserver/terminal.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "occam/configuration/configuration.hpp"
#include "occam/network/file_kinds.hpp"
#include "report/run_report.hpp"
#include "text/load_source.hpp"
#include "text/paint.hpp"
#include "text/texts_in_memory.hpp"
#include "text/user_error.hpp"
#include "text/utf8.hpp"

#include <boost/json/src.hpp>

#include <csignal>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>

/// Emscripten declares this function without defining it. There is no signal that would need another stack.
extern "C" int sigaltstack(const stack_t*, stack_t*) { return -1; }

namespace placedpar {

namespace json = boost::json;

namespace {

constexpr std::size_t most_output_bytes = 256U << 10; ///< value of our choice, as in serve/job.cpp

struct Job {
    std::string task, main, keys;
    TextsInMemory files;
    std::uint64_t seed = 1;
};

Job job_of(const json::object& object) {
    Job job{std::string(object.at("do").as_string()), std::string(object.at("main").as_string()), "", {}};
    for (const auto& [name, text] : object.at("files").as_object())
        job.files.put(std::string(name), std::string(text.as_string()));
    if (const json::value* keys = object.if_contains("keys"))
        job.keys = std::string(keys->as_string());
    if (const json::value* seed = object.if_contains("seed"))
        job.seed = seed->to_number<std::uint64_t>();
    return job;
}

/// The kinds of processes that need nothing but the rooms compiled here.
Catalogue known_kinds() {
    Catalogue catalogue;
    catalogue.make_from_files(occam::make_file_kinds());
    add_csp_kinds(catalogue);
    return catalogue;
}

ReadOptions options_of_reading() {
    ReadOptions options;
    options.make_netlist = occam::netlist_of_configuration;
    return options;
}

json::array faults_of(const std::string& main, const Catalogue& kinds) {
    const NamesOf names = is_occam(main) || occam::is_configuration(main) ? NamesOf::occam : NamesOf::netlist;
    const std::vector<Diagnostic> faults = is_occam(main)
                                               ? check_occam_source(load_input(main).file, {}).diagnostics
                                               : read_netlist(main, kinds, {}, options_of_reading()).diagnostics;
    json::array result;
    for (const Diagnostic& each : faults)
        result.push_back(diagnostic_json(each, names));
    return result;
}

/// Reads the job's netlist, or makes a netlist with one transputer for a program in occam. Throws UserError.
Network network_of(const Job& job, const Catalogue& kinds, std::string& warnings) {
    const WarningSink warn = [&warnings](const std::string& text) { warnings += unpainted(text); };
    const ProgramMachine machine;
    ReadOptions read = options_of_reading();
    if (is_occam(job.main))
        read.compiled[job.main] = compiled_program(job.main, {}, machine, warn);
    const ParsedNetlist parsed = is_occam(job.main)
                                     ? ParsedNetlist::of_text(netlist_around(job.main, machine), job.main, read)
                                     : ParsedNetlist(job.main, read);
    ReadResult result = parsed.read(kinds, {});
    if (!result.network)
        throw RefusedInput(render(result));
    return std::move(*result.network);
}

std::string listings_of(const RunReport& report) {
    std::string all;
    for (const ProgramUse& program : report.programs)
        all += program.listing.empty() ? "" : program.name + "\n" + program.listing;
    return all;
}

void run(const Job& job, const Catalogue& kinds, json::object& answer) {
    std::string warnings, output;
    Network network = network_of(job, kinds, warnings);
    network.host.terminal = [&] {
        return std::make_shared<iserver::ScriptedTerminal>(job.keys, [&output](std::string_view text) {
            output += text.substr(0, most_output_bytes - std::min(output.size(), most_output_bytes));
        });
    };
    network.host.lists_code = job.task == "listing";
    Machine machine(network, kinds, job.seed);
    const RunReport report = machine.run(Time::max());
    answer["ended"] = name_of(report.result.ending);
    answer["output"] = output;
    answer["report"] = print_report(report, network);
    answer["warnings"] = warnings;
    if (job.task == "listing")
        answer["listing"] = listings_of(report);
}

json::object answer_to(const Job& job) {
    const ReadsFromMemory reading(job.files);
    const Catalogue kinds = known_kinds();
    json::object answer;
    try {
        if (job.task == "check")
            answer["faults"] = faults_of(job.main, kinds);
        else
            run(job, kinds, answer);
    } catch (const UserError& refused) {
        answer["ended"] = "refused";
        answer["refused"] = unpainted(refused.what());
        answer["faults"] = faults_of(job.main, kinds);
    } catch (const std::exception& failed) {
        answer["ended"] = "failed";
        answer["refused"] = unpainted(failed.what());
    }
    return answer;
}

} // namespace

} // namespace placedpar

/// Reads a job from standard input, and writes the answer to standard output, as `placedpar serve --job` does. Knows
/// the jobs "check", "run" and "listing" (serve/job.hpp). Answers have no page of the run.
int main() {
    const std::string text(std::istreambuf_iterator<char>(std::cin), {});
    const boost::json::value job = boost::json::parse(text);
    std::cout << placedpar::as_json(boost::json::serialize(placedpar::answer_to(placedpar::job_of(job.as_object()))))
              << std::endl;
}
