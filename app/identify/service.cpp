#include "app/identify/ways.hpp"

#include "app/identify/question.hpp"
#include "app/identify/record_pieces.hpp"
#include "app/options/link_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/load.hpp"
#include "hydraulics/circuit/circuit.hpp"
#include "identification/on_line/moving_identification.hpp"
#include "identification/on_line/record_diagnosis.hpp"
#include "identification/report/diagnosis_report.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
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

DiagnosisSettings settings_of(const IdentifyOptions& options) {
    DiagnosisSettings settings;
    settings.bits = options.bits.value_or(settings.bits);
    settings.search.elite = options.elite.value_or(settings.search.elite);
    settings.search.population = options.population.value_or(settings.search.population);
    settings.search.window.trials = options.trials.value_or(settings.search.window.trials);
    settings.search.window.length = options.window.value_or(settings.search.window.length);
    settings.search.window.bias = options.bias;
    settings.validate();
    return settings;
}

LinkSet wanted_links(const IdentifyOptions& options, const ChannelSet& there) {
    return options.links.empty() ? links_to_diagnose(there) : links_of(options.links);
}

/// Returns whether the configuration is to be recognised.
bool moves(const IdentifyOptions& options, const ChannelSet& there) {
    return options.configuration.empty() && recognisable(there);
}

/// Rounds a period to whole nanoseconds, since clock steps written as decimals are whole nanoseconds.
double whole_nanoseconds(double period_s) { return std::round(period_s * 1e9) / 1e9; }

/// Identifies the compliances in a record that is read in pieces.
class Identifying {
public:
    Identifying(const IdentifyOptions& options, const Record& first)
        : settings_(settings_of(options)), keeps_movements_(!options.json.empty()),
          links_(required_links(options, first)),
          diagnosis_(made(options, first), settings_, readers_of(options, first)) {}

    LinkSet links() const { return links_; }
    const DiagnosisSettings& settings() const { return settings_; }
    const Diagnosis& diagnosis() const { return diagnosis_.diagnosis(); }
    std::size_t movements() const { return count_; }
    bool flagged() const { return flagged_; }

    void take(const Record& piece) { show(diagnosis_.take(piece)); }
    void end() { show(diagnosis_.end()); }

    boost::json::array movements_json() && { return std::move(movements_); }

private:
    static LinkSet required_links(const IdentifyOptions& options, const Record& first) {
        const LinkSet wanted = wanted_links(options, first.channels());
        if (!wanted.empty())
            return wanted;
        for (Link link : links_of(first.links())) // throws an error that names the channels that the first link lacks
            require_channels(first, link, areas_from(first.channels(), link, areas_asked(options)));
        throw UnfitRecord("no link has all readings that identification needs: inlet_pressure, angle, and spool "
                          "or servo or (inlet_area and bypass_area)");
    }

    Diagnosis made(const IdentifyOptions& options, const Record& first) const {
        ExcavatorParameters machine = excavator_parameters(load_machine(options.machine, print_warnings));
        machine.period_s = whole_nanoseconds(first.period_s);
        Diagnosis diagnosis(machine_name, machine, settings_, options.seed);
        diagnosis.change({*configuration_named(options.configuration), links_});
        return diagnosis;
    }

    PerLink<LinkReader> readers_of(const IdentifyOptions& options, const Record& first) const {
        PerLink<LinkReader> readers;
        const bool offset = !options.offset.empty() && options.offset != "none";
        for (Link link : links_of(links_)) {
            const AreasFrom from = areas_from(first.channels(), link, areas_asked(options));
            require_channels(first, link, from);
            readers[index_of(link)].from = from;
        }
        LinkReader& boom = readers[index_of(Link::boom)];
        if (offset && (!links_.contains(Link::boom) || boom.from != AreasFrom::spool))
            throw UserError(fmt::format("--offset {}: the option has no effect, because no area is computed from "
                                        "the boom's spool",
                                        options.offset));
        boom.spool_offset_in = offset ? offset_asked(options.offset) : 0;
        return readers;
    }

    void show(const std::vector<MovementFinding>& found) {
        for (const MovementFinding& movement : found) {
            print_out(count_++ == 0 ? movements_heading() + print_movement(movement) : print_movement(movement));
            if (keeps_movements_)
                movements_.push_back(movement_json(movement));
            for (const LinkFinding& link : movement.links)
                flagged_ = flagged_ || !link.flags.empty();
        }
    }

    DiagnosisSettings settings_;
    bool keeps_movements_;
    LinkSet links_;
    RecordDiagnosis diagnosis_;
    std::size_t count_ = 0;
    boost::json::array movements_; ///< empty unless keeps_movements_, so that memory does not grow with the record
    bool flagged_ = false;
};

std::string print_beginning(const Identifying& identifying, const IdentifyOptions& options) {
    std::vector<std::string_view> names;
    for (Link link : links_of(identifying.links()))
        names.push_back(name_of(link));
    const Sampling& sampling = identifying.diagnosis().sampling();
    return fmt::format("{} in configuration {}; search with {}, {} per sample\n{}\n", fmt::join(names, ", "),
                       options.configuration, counted(identifying.settings().search.population, "individual"),
                       counted(identifying.settings().search.window.trials, "generation"),
                       sampling.readings > 1 ? fmt::format("{}\n", print_sampling(sampling)) : "");
}

[[noreturn]] void refuse_rest(const Identifying& identifying) {
    throw UnfitRecord(fmt::format("no movement in {}: expected a valve that opens for long enough while the pressure "
                                  "lets oil flow into the cylinder",
                                  counted(identifying.diagnosis().samples(), "sample")));
}

/// Reports the results after the last sample.
void report(Identifying& identifying, boost::json::object& json) {
    print_out("\n" + print_verdicts(identifying.diagnosis()));
    for (auto& [key, value] : verdicts_json(identifying.diagnosis()))
        json[key] = value;
    json["sampling"] = sampling_json(identifying.diagnosis().sampling());
    json["samples"] = identifying.diagnosis().samples();
    json["movements"] = std::move(identifying).movements_json();
}

} // namespace

ExitCode identify_as_service(const IdentifyOptions& typed, boost::json::object& json) {
    IdentifyOptions options = typed;
    settings_of(options); // reports wrong settings before anything is read
    InterruptedBySignals interruption;
    RecordPieces pieces(options.record,
                        needs_of(options,
                                 [&](const ChannelSet& there) {
                                     return moves(options, there) ? LinkSet::all() : wanted_links(options, there);
                                 }),
                        print_warnings, [&] { return interruption.requested(); });
    std::optional<Identifying> identifying;
    ProgressLine progress;
    while (auto piece = pieces.next()) {
        progress.clear();
        if (!identifying && moves(options, piece->channels()))
            return identify_moving(options, std::move(*piece), pieces, json);
        if (!identifying) {
            if (options.configuration.empty())
                options.configuration = "a";
            identifying.emplace(options, *piece);
            print_out(print_beginning(*identifying, options));
        }
        identifying->take(*piece);
        progress.show(fmt::format("{:.0f} Mbyte, {}", static_cast<double>(pieces.bytes()) / 1e6,
                                  counted(identifying->movements(), "movement")));
    }
    progress.clear();
    json["warnings"] = warnings_json(pieces.warnings());
    if (!identifying)
        return ExitCode::interrupted;
    identifying->end();
    const bool alarmed = !identifying->diagnosis().alarms().empty();
    if (identifying->movements() == 0 && !alarmed && !pieces.stopped())
        refuse_rest(*identifying);
    const bool doubted = identifying->flagged() || alarmed;
    report(*identifying, json);
    if (pieces.stopped())
        return ExitCode::interrupted;
    return options.strict && doubted ? ExitCode::missed_tolerance : ExitCode::success;
}

} // namespace placedpar
