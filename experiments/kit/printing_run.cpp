#include "experiments/kit/printing_run.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "explore/problems.hpp"
#include "iserver/terminal.hpp"
#include "occam/check/check.hpp"
#include "occam/code/compile.hpp"
#include "occam/language/parse.hpp"
#include "occam/library/library.hpp"
#include "text/load_source.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <memory>
#include <sstream>
#include <utility>

namespace placedpar {

namespace {

CompiledProgram compiled_occam(const std::filesystem::path& path, const occam::CodeOptions& code) {
    const LoadedSource source = load_source(path);
    Reporter reporter;
    occam::ParseOptions options;
    options.built_in = [](const std::string& name) { return occam::library_text(name); };
    if (!source.problems.empty())
        throw RefusedInput(render(source.problems));
    const occam::Parsed parsed = occam::parse(source.file, options, reporter);
    if (!reporter.failed())
        occam::check(*parsed.program, parsed.options, reporter);
    const occam::Declaration* main = reporter.failed() ? nullptr : occam::main_procedure(*parsed.program);
    if (main == nullptr)
        throw RefusedInput(render(reporter.take()));
    auto bytes = occam::bootable(occam::compile(*parsed.program, *main, code), code);
    return {std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes)), nullptr};
}

PrintedRun run_with_screen(Network network, const ProblemRegistry& problems, const ReplayContext& context) {
    PrintedRun run;
    network.host.terminal = [&run] {
        return std::make_shared<iserver::ScriptedTerminal>("", [&run](std::string_view text) { run.text += text; });
    };
    run.fingerprint = run_to_the_end(network, problems, context).result.fingerprint;
    return run;
}

} // namespace

double PrintedRun::number_behind(std::string_view words) const {
    if (const std::size_t at = text.find(words); at != text.npos) {
        std::istringstream rest(text.substr(at + words.size()));
        if (double number = 0; rest >> number)
            return number;
    }
    throw UserError(fmt::format("the program printed no number after \"{}\"; its whole output is\n{}", words, text));
}

std::vector<double> PrintedRun::numbers() const {
    std::vector<double> numbers;
    std::istringstream words(text);
    for (std::string word; words >> word;)
        if (const auto number = parse_number<double>(word))
            numbers.push_back(*number);
    return numbers;
}

PrintedRun run_occam(const std::filesystem::path& path, const occam::CodeOptions& code, int memory_cycles,
                     const ReplayContext& context) {
    const std::string netlist = fmt::format("T800 (memory = 2M, memorycycles = {}) root;\nconnect root.link[0] to "
                                            "host;\nuse \"{}\" for root;\n",
                                            memory_cycles, path.filename().string());
    const auto make = [&](const auto& file, auto&&...) {
        return MadeNetlist{.text = std::make_shared<const SourceFile>(file->path(), netlist),
                           .compiled = {{file->path(), compiled_occam(path, code)}}};
    };
    const ProblemRegistry problems = known_problems(context.seed);
    const ParsedNetlist parsed(path, {.make_netlist = make});
    return run_with_screen(load_network(parsed, {}, known_kinds(problems), context.warn), problems, context);
}

PrintedRun run_printing(const std::filesystem::path& netlist, const Overrides& overrides,
                        const ReplayContext& context) {
    const ProblemRegistry problems = known_problems(context.seed);
    return run_with_screen(load_network(netlist, overrides, problems, context.warn), problems, context);
}

} // namespace placedpar
