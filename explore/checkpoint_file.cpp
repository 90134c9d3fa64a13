#include "explore/checkpoint_file.hpp"

#include "gaprocs/processes/parameters.hpp"
#include "netlist/network/network.hpp"
#include "netlist/print/text.hpp"
#include "report/manifest.hpp"
#include "report/search_log.hpp"
#include "text/checksum.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <bit>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

namespace json = boost::json;

constexpr std::string_view checkpoint_format = "checkpoint 3"; ///< changes whenever the format of the file changes

/// Returns an individual as JSON. The fitness is stored as its bits, so that reading restores it exactly.
json::object json_of(const Individual& individual) {
    return {{"genome", individual.genome.to_string()},
            {"fitness_bits", std::bit_cast<std::uint64_t>(individual.fitness)}};
}

Individual individual_from(const json::value& value) {
    return {Genome::from_string(json::value_to<std::string>(value.at("genome"))),
            std::bit_cast<double>(value.at("fitness_bits").to_number<std::uint64_t>())};
}

json::object json_of(const SearchCheckpoint& checkpoint) {
    json::array population;
    for (const Genome& genome : checkpoint.search.population)
        population.emplace_back(genome.to_string());
    json::array improvements;
    for (const Improvement& each : checkpoint.improvements)
        improvements.push_back(
            {{"generation", each.generation}, {"fitness_bits", std::bit_cast<std::uint64_t>(each.fitness)}});
    return {{"redraws", checkpoint.search.redraws},    {"drawn", checkpoint.search.drawn},
            {"populations", checkpoint.populations},   {"best", json_of(checkpoint.best)},
            {"improvements", std::move(improvements)}, {"last_best", json_of(checkpoint.search.best.value())},
            {"population", std::move(population)}};
}

/// Returns the improvements up to the generation of the checkpoint. Throws std::out_of_range if the generations are not
/// in order.
std::vector<Improvement> improvements_from(const json::value& value, std::uint64_t generation) {
    std::vector<Improvement> improvements;
    for (const json::value& each : value.as_array()) {
        const auto number = each.at("generation").to_number<std::uint64_t>();
        if (number > generation || number <= (improvements.empty() ? 0 : improvements.back().generation))
            throw std::out_of_range("an improvement");
        improvements.push_back({number, std::bit_cast<double>(each.at("fitness_bits").to_number<std::uint64_t>())});
    }
    return improvements;
}

SearchCheckpoint checkpoint_from(const json::value& value, std::uint64_t generation) {
    SearchCheckpoint checkpoint;
    checkpoint.search.generation = generation;
    checkpoint.search.redraws = value.at("redraws").to_number<std::uint64_t>();
    checkpoint.search.drawn = value.at("drawn").to_number<std::uint64_t>();
    checkpoint.search.best = individual_from(value.at("last_best"));
    for (const json::value& genome : value.at("population").as_array())
        checkpoint.search.population.push_back(Genome::from_string(json::value_to<std::string>(genome)));
    checkpoint.populations = value.at("populations").to_number<std::uint64_t>();
    checkpoint.best = individual_from(value.at("best"));
    checkpoint.improvements = improvements_from(value.at("improvements"), generation);
    return checkpoint;
}

/// Returns the checksum of a file's contents, without the checksum itself.
std::string checksum_text(const json::object& contents) {
    return hex(static_cast<std::uint64_t>(checksum_of(json::serialize(contents))));
}

/// Returns whether the checksum in the file is that of its other contents.
bool has_right_checksum(json::object file) {
    const auto stored = json::value_to<std::string>(file.at("checksum"));
    file.stable_erase(file.find("checksum"));
    return stored == checksum_text(file);
}

/// Throws UserError if the results of the search depend on data that a checkpoint does not contain.
void require_kept_whole(const ProcessInstance& search) {
    const auto refuse = [&](std::string_view why) {
        throw UserError(fmt::format("{}: --checkpoint: {} {}, which a checkpoint cannot store", search.declared.text(),
                                    search.name, why));
    };
    if (breeds_recoded(search))
        refuse("belongs to a pair of a coarse and a fine search, and has a bias point");
    for (const PortBinding& each : search.ports)
        if (each.port == "to_host" || each.port == "to_analyst")
            refuse(fmt::format("sends estimates ({})", each.port));
}

/// Throws UserError if a parameter has one value in the file and another value here. `what` names the parameter.
void require_equal(const std::filesystem::path& path, const std::string& what, const std::string& in_file,
                   const std::string& here) {
    if (in_file != here)
        throw UserError(fmt::format("{}: the checkpoint has {} {}, but this run has {}: give the file of a matching "
                                    "checkpoint, or delete this file to begin anew",
                                    path.string(), what, in_file, here));
}

} // namespace

CheckpointFile::CheckpointFile(std::filesystem::path path, const Network& network, std::uint64_t seed,
                               std::uint64_t every)
    : CheckpointFile(std::move(path), describe(network), seed, every) {}

CheckpointFile::CheckpointFile(std::filesystem::path path, std::vector<KeptSearch> searches, std::uint64_t seed,
                               std::uint64_t every)
    : path_(std::move(path)), seed_(seed), every_(every), searches_(std::move(searches)) {
    if (path_ == "-" || (std::filesystem::exists(path_) && !std::filesystem::is_regular_file(path_)))
        throw UserError(
            fmt::format("--checkpoint {}: give the name of a file, such as search.checkpoint", path_.string()));
    require_writable(path_);
    if (std::filesystem::exists(path_))
        read();
}

/// Reads the file. Throws UserError if the file has another format.
void CheckpointFile::read() {
    try {
        std::ifstream file(path_);
        const std::string text(std::istreambuf_iterator<char>(file), {});
        checksum_ = checksum_of(text);
        take(json::parse(text));
    } catch (const UserError&) {
        throw;
    } catch (const std::exception&) {
        refuse_file("it has another format");
    }
}

std::vector<KeptSearch> CheckpointFile::describe(const Network& network) {
    require_searches(network);
    std::vector<KeptSearch> all;
    for (const ProcessInstance& process : network.processes) {
        if (!searches(process))
            continue;
        require_kept_whole(process);
        KeptSearch described{process.name, {}};
        for (const char* name : {"problem", "coding", "population", "stream"})
            if (const auto found = process.parameters.find(name); found != process.parameters.end())
                described.parameters[name] = print_constant(found->second);
        all.push_back(std::move(described));
    }
    return all;
}

std::string CheckpointFile::digest() const { return fmt::format("{} {}", every_, checksum_); }

const SearchCheckpoint* CheckpointFile::begin_of(const std::string& search) const {
    const auto found = begin_states_.find(search);
    return found == begin_states_.end() ? nullptr : &found->second;
}

void CheckpointFile::keep(const std::string& search, const SearchCheckpoint& checkpoint) {
    const std::lock_guard lock(mutex_);
    States& states = incomplete_[checkpoint.search.generation];
    states[search] = checkpoint;
    if (states.size() < searches_.size())
        return;
    write(states);
    incomplete_.erase(incomplete_.begin(), incomplete_.upper_bound(checkpoint.search.generation));
}

void CheckpointFile::refuse_file(const std::string& why) const {
    throw UserError(fmt::format("{}: this is not a checkpoint of a search ({}): give another file, or delete this one",
                                path_.string(), why));
}

void CheckpointFile::require_same_run(const json::value& file) const {
    require_equal(path_, "seed", fmt::format("{}", file.at("seed").to_number<std::uint64_t>()),
                  fmt::format("{}", seed_));
    const json::array& kept = file.at("searches").as_array();
    require_equal(path_, "search count", fmt::format("{}", kept.size()), fmt::format("{}", searches_.size()));
    for (std::size_t i = 0; i < searches_.size(); ++i) {
        const KeptSearch& here = searches_[i];
        require_equal(path_, "a search named", json::value_to<std::string>(kept[i].at("name")), here.search);
        for (const auto& [name, value] : here.parameters)
            require_equal(path_, fmt::format("{}.{} =", here.search, name),
                          json::value_to<std::string>(kept[i].at("parameters").at(name)), value);
    }
}

void CheckpointFile::take(const json::value& file) {
    if (const auto format = json::value_to<std::string>(file.at("placedpar")); format != checkpoint_format)
        throw UserError(fmt::format("{}: another version of PlacedPar wrote this checkpoint, in the format \"{}\" "
                                    "(expected \"{}\"): continue with that version, or delete the file to begin anew",
                                    path_.string(), format, checkpoint_format));
    if (!has_right_checksum(file.as_object()))
        refuse_file("its checksum is not that of its contents, so the file is damaged");
    require_same_run(file);
    begin_ = file.at("generation").to_number<std::uint64_t>();
    if (begin_ == 0)
        refuse_file("its generation is 0");
    for (const json::value& search : file.at("searches").as_array())
        begin_states_[json::value_to<std::string>(search.at("name"))] = checkpoint_from(search, begin_);
}

void CheckpointFile::write(const States& states) const {
    json::array kept;
    for (const KeptSearch& each : searches_) {
        json::object search = json_of(states.at(each.search));
        search["name"] = each.search;
        search["parameters"] = json::value_from(each.parameters);
        kept.emplace_back(std::move(search));
    }
    json::object file{{"placedpar", checkpoint_format},
                      {"seed", seed_},
                      {"generation", states.begin()->second.search.generation},
                      {"searches", std::move(kept)}};
    const std::string checksum = checksum_text(file);
    file["checksum"] = checksum;
    write_whole(path_, print_pretty(file));
}

} // namespace placedpar
