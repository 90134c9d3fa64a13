#include "explore/compare/comparison.hpp"
#include "explore/load.hpp"
#include "occam/configuration/configuration.hpp"
#include "report/manifest.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

namespace placedpar {

namespace {

using boost::json::object;

std::map<std::string, std::string> texts_in(const object& json) {
    std::map<std::string, std::string> texts;
    for (const auto& [name, value] : json)
        texts[std::string(name)] = std::string(value.as_string());
    return texts;
}

ReadOptions read_options_in(const object& manifest) {
    ReadOptions read{.programs = texts_in(manifest.at("programs").as_object()),
                     .make_netlist = occam::netlist_of_configuration};
    for (const auto& folder : manifest.at("include_folders").as_array())
        read.include_folders.emplace_back(std::string(folder.as_string()));
    if (const auto* faults = manifest.if_contains("faults"))
        for (const auto& fault : faults->as_array())
            read.faults.emplace_back(fault.as_string());
    return read;
}

ComparedRun run_of_manifest(const object& manifest, const std::string& name) {
    ComparedRun run{.name = name,
                    .parsed = ParsedNetlist(std::string(manifest.at("netlist").as_string()), read_options_in(manifest)),
                    .set = texts_in(manifest.at("overrides").as_object()),
                    .seed = manifest.at("seed").to_number<std::uint64_t>()};
    if (const auto* until = manifest.if_contains("until_ps"))
        run.until = Time(until->to_number<std::int64_t>());
    if (const auto* shuffle = manifest.if_contains("shuffle"))
        run.shuffle = shuffle->to_number<std::uint64_t>();
    return run;
}

} // namespace

static std::string netlist_has_changed(const std::string& path, const Network& network) {
    return fmt::format("{}: warning: {} has changed since this run; the new netlist is compared\n", path,
                       network.source_path);
}

ComparedRun run_of_report(const std::string& path, const std::function<void(const std::string&)>& warn) {
    const auto file = load_text(path);
    try {
        const object manifest = boost::json::parse(file->text()).as_object().at("manifest").as_object();
        ComparedRun run = run_of_manifest(manifest, path);
        const Network network = load_compared(run);
        if (hex(network.hash) != std::string(manifest.at("netlist_hash").as_string()))
            warn(netlist_has_changed(path, network));
        return run;
    } catch (const UserError&) {
        throw;
    } catch (const std::exception&) {
        throw UserError(fmt::format("{}: expected a report that placedpar run --json wrote", path));
    }
}

} // namespace placedpar
