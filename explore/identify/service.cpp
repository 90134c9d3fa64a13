#include "explore/identify/ways.hpp"

#include "explore/identify/question.hpp"
#include "hydraulics/circuit/circuit.hpp"
#include "identification/on_line/moving_identification.hpp"
#include "identification/on_line/record_diagnosis.hpp"
#include "identification/report/diagnosis_report.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// The monitor uses the same random numbers for a machine of this name.
constexpr const char* machine_name = "record";

DiagnosisSettings settings_of(const IdentifySettings& given) {
    DiagnosisSettings settings;
    settings.bits = given.bits.value_or(settings.bits);
    settings.search.elite = given.elite.value_or(settings.search.elite);
    settings.search.population = given.population.value_or(settings.search.population);
    settings.search.window.trials = given.trials.value_or(settings.search.window.trials);
    settings.search.window.length = given.window.value_or(settings.search.window.length);
    settings.search.window.bias = given.bias;
    settings.validate();
    return settings;
}

LinkSet wanted_links(const IdentifySettings& settings, const ChannelSet& there) {
    return settings.links.empty() ? links_to_diagnose(there) : links_of(settings.links);
}

/// Returns whether the configuration is to be recognised.
bool moves(const IdentifySettings& settings, const ChannelSet& there) {
    return settings.configuration.empty() && recognisable(there);
}

/// Rounds a period to whole nanoseconds, since clock steps written as decimals are whole nanoseconds.
double whole_nanoseconds(double period_s) { return std::round(period_s * 1e9) / 1e9; }

/// Identifies the compliances in a record that is read in pieces.
class Identifying {
public:
    Identifying(const IdentifySettings& settings, const Record& first, const IdentifyOutput& output)
        : settings_(settings_of(settings)), output_(output), links_(required_links(settings, first)),
          diagnosis_(made(settings, first), settings_, readers_of(settings, first)) {}

    LinkSet links() const { return links_; }
    const DiagnosisSettings& settings() const { return settings_; }
    const Diagnosis& diagnosis() const { return diagnosis_.diagnosis(); }
    std::size_t movements() const { return count_; }
    bool flagged() const { return flagged_; }

    void take(const Record& piece) { show(diagnosis_.take(piece)); }
    void end() { show(diagnosis_.end()); }

    boost::json::array movements_json() && { return std::move(movements_); }

private:
    static LinkSet required_links(const IdentifySettings& settings, const Record& first) {
        const LinkSet wanted = wanted_links(settings, first.channels());
        if (!wanted.empty())
            return wanted;
        for (Link link : links_of(first.links())) // throws an error that names the channels that the first link lacks
            require_channels(first, link, areas_from(first.channels(), link, areas_asked(settings)));
        throw UnfitRecord("no link has all readings that identification needs: inlet_pressure, angle, and spool "
                          "or servo or (inlet_area and bypass_area)");
    }

    Diagnosis made(const IdentifySettings& settings, const Record& first) const {
        ExcavatorParameters machine = excavator_parameters(load_machine(settings.machine, output_.warn));
        machine.period_s = whole_nanoseconds(first.period_s);
        Diagnosis diagnosis(machine_name, machine, settings_, settings.seed);
        diagnosis.change({*configuration_named(settings.configuration), links_});
        return diagnosis;
    }

    PerLink<LinkReader> readers_of(const IdentifySettings& settings, const Record& first) const {
        PerLink<LinkReader> readers;
        const bool offset = !settings.offset.empty() && settings.offset != "none";
        for (Link link : links_of(links_)) {
            const AreasFrom from = areas_from(first.channels(), link, areas_asked(settings));
            require_channels(first, link, from);
            readers[index_of(link)].from = from;
        }
        LinkReader& boom = readers[index_of(Link::boom)];
        if (offset && (!links_.contains(Link::boom) || boom.from != AreasFrom::spool))
            throw UserError(fmt::format("--offset {}: the option has no effect, because no area is computed from "
                                        "the boom's spool",
                                        settings.offset));
        boom.spool_offset_in = offset ? offset_asked(settings.offset) : 0;
        return readers;
    }

    void show(const std::vector<MovementFinding>& found) {
        for (const MovementFinding& movement : found) {
            output_.print(count_++ == 0 ? movements_heading() + print_movement(movement) : print_movement(movement));
            if (output_.keeps_movements)
                movements_.push_back(movement_json(movement));
            for (const LinkFinding& link : movement.links)
                flagged_ = flagged_ || !link.flags.empty();
        }
    }

    DiagnosisSettings settings_;
    const IdentifyOutput& output_;
    LinkSet links_;
    RecordDiagnosis diagnosis_;
    std::size_t count_ = 0;
    boost::json::array movements_; ///< empty unless the output keeps movements
    bool flagged_ = false;
};

std::string print_beginning(const Identifying& identifying, const IdentifySettings& settings) {
    std::vector<std::string_view> names;
    for (Link link : links_of(identifying.links()))
        names.push_back(name_of(link));
    const Sampling& sampling = identifying.diagnosis().sampling();
    return fmt::format("{} in configuration {}; search with {}, {} per sample\n{}\n", fmt::join(names, ", "),
                       settings.configuration, counted(identifying.settings().search.population, "individual"),
                       counted(identifying.settings().search.window.trials, "generation"),
                       sampling.readings > 1 ? fmt::format("{}\n", print_sampling(sampling)) : "");
}

[[noreturn]] void refuse_rest(const Identifying& identifying) {
    throw UnfitRecord(fmt::format("no movement in {}: expected a valve that opens for long enough while the pressure "
                                  "lets oil flow into the cylinder",
                                  counted(identifying.diagnosis().samples(), "sample")));
}

/// Reports the results after the last sample.
void report(Identifying& identifying, const IdentifyOutput& output) {
    output.print("\n" + print_verdicts(identifying.diagnosis()));
    for (auto& [key, value] : verdicts_json(identifying.diagnosis()))
        output.json[key] = value;
    output.json["sampling"] = sampling_json(identifying.diagnosis().sampling());
    output.json["samples"] = identifying.diagnosis().samples();
    output.json["movements"] = std::move(identifying).movements_json();
}

/// Reports the results of a record that has been read to its end, or has been stopped.
IdentifyEnd end(Identifying& identifying, const RecordStream& pieces, const IdentifyOutput& output) {
    identifying.end();
    const bool alarmed = !identifying.diagnosis().alarms().empty();
    if (identifying.movements() == 0 && !alarmed && !pieces.stopped())
        refuse_rest(identifying);
    const bool doubted = identifying.flagged() || alarmed;
    report(identifying, output);
    if (pieces.stopped())
        return IdentifyEnd::interrupted;
    return doubted ? IdentifyEnd::doubtful : IdentifyEnd::sound;
}

} // namespace

IdentifyEnd identify_as_service(const IdentifySettings& given, const RecordInput& input, const IdentifyOutput& output) {
    IdentifySettings settings = given;
    settings_of(settings); // reports wrong settings before anything is read
    const auto pieces = input.pieces(needs_of(settings, [&](const ChannelSet& there) {
        return moves(settings, there) ? LinkSet::all() : wanted_links(settings, there);
    }));
    std::optional<Identifying> identifying;
    while (auto piece = pieces->next()) {
        if (!identifying && moves(settings, piece->channels()))
            return identify_moving(settings, std::move(*piece), *pieces, output);
        if (!identifying) {
            if (settings.configuration.empty())
                settings.configuration = "a";
            identifying.emplace(settings, *piece, output);
            output.print(print_beginning(*identifying, settings));
        }
        identifying->take(*piece);
        output.progress(fmt::format("{:.0f} Mbyte, {}", static_cast<double>(pieces->bytes()) / 1e6,
                                    counted(identifying->movements(), "movement")));
    }
    output.json["warnings"] = warnings_json(pieces->warnings());
    return identifying ? end(*identifying, *pieces, output) : IdentifyEnd::interrupted;
}

} // namespace placedpar
