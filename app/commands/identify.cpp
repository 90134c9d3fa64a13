#include "app/command.hpp"
#include "app/identify/ways.hpp"
#include "app/options/identify_options.hpp"
#include "hydraulics/data/record.hpp"
#include "report/manifest.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// Throws UserError for options that a search over the whole movement lacks.
void require_whole_way(const IdentifyOptions& options) {
    const std::array<std::pair<const char*, bool>, 3> of_thesis{
        {{"--rising", options.rising}, {"--on", !options.netlist.empty()}, {"--window", options.window.has_value()}}};
    for (const auto& [option, typed] : of_thesis)
        if (typed)
            throw UserError(
                fmt::format("{} works only with --way thesis; --way whole uses all samples at once", option));
}

/// Throws UserError for options that the way lacks.
void require_one_way(const IdentifyOptions& options) {
    if (options.way == "thesis")
        return;
    if (options.way == "whole")
        return require_whole_way(options);
    const std::array<std::pair<const char*, bool>, 5> of_thesis{{{"--samples", options.samples.has_value()},
                                                                 {"--rising", options.rising},
                                                                 {"--coding", !options.coding.empty()},
                                                                 {"--on", !options.netlist.empty()},
                                                                 {"--offset auto", options.offset == "auto"}}};
    for (const auto& [option, typed] : of_thesis)
        if (typed)
            throw UserError(fmt::format("{} works only with --way thesis, which searches the first transient; "
                                        "--way service uses all movements in order",
                                        option));
}

void require_files(const IdentifyOptions& options) {
    const std::filesystem::path output[] = {options.json, options.trend};
    std::vector<std::string> inputs = options.records;
    inputs.insert(inputs.end(), {options.machine, options.netlist, options.columns_from});
    if (std::ranges::count_if(inputs, is_standard_stream) > 1)
        throw UserError("standard input can be read only once: at most one of RECORD, --machine, --columns-from and "
                        "--on can be \"-\"");
    for (const std::string& input : inputs)
        require_apart(output, input);
    for (const std::filesystem::path& file : output)
        if (!file.empty())
            require_writable(file);
}

/// Throws UserError if the options do not fit the number of records.
void require_number_of_records(const IdentifyOptions& options) {
    const bool many = options.records.size() > 1;
    if (many && options.way != "service")
        throw UserError(fmt::format("{} records, expected one with --way {}: a trend needs --way service",
                                    options.records.size(), options.way));
    if (!many && !options.trend.empty())
        throw UserError(
            "--trend needs at least two records; expected placedpar identify FIRST SECOND ... --trend FILE");
}

ExitCode identify_record(IdentifyOptions options, const std::string& command_line) try {
    if (options.side == "outlet" && options.way == "service")
        throw UserError("--side outlet works only with --way thesis or whole; --way service identifies inlet sides");
    if (options.way.empty())
        options.way = options.side == "outlet" ? "whole" : "service";
    if (options.way != "service" && options.configuration.empty())
        options.configuration = "a";
    require_files(options);
    require_one_way(options);
    require_number_of_records(options);
    boost::json::object json{
        {"version", version}, {"commit", commit}, {"command", command_line}, {"seed", options.seed}};
    ExitCode code = options.records.size() > 1 ? identify_trend(options, json)
                    : options.way == "service" ? identify_as_service(options, json)
                    : options.way == "whole"   ? identify_over_whole(options, json)
                                               : identify_by_thesis(options, json);
    if (!options.json.empty())
        write_whole(options.json, print_pretty(json));
    return code;
} catch (const hydraulics::UnfitRecord& unfit) {
    throw RefusedInput(fmt::format("{}: error: {}\n", shown_input(options.record), unfit.what()));
}

Action declare_identify(Options& command, const std::string& typed) {
    auto options = std::make_shared<IdentifyOptions>();
    declare_identify_options(command, *options);
    return [options, typed] {
        options->record = options->records.front();
        return identify_record(*options, typed);
    };
}

} // namespace

extern const Command identify_command{
    .name = "identify",
    .about = "Identifies hydraulic compliances from a record of a motion",
    .place = 70,
    .declare = declare_identify,
};

} // namespace placedpar
