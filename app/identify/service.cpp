#include "app/identify/ways.hpp"

#include "app/identify/identifying.hpp"
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

/// Prints movements, and keeps them for JSON if asked.
class MovementList {
public:
    explicit MovementList(bool keeps_movements) : keeps_movements_(keeps_movements) {}

    std::size_t count() const { return count_; }
    bool flagged() const { return flagged_; }

    void show(const std::vector<MovementFinding>& found) {
        for (const MovementFinding& movement : found) {
            print_out(count_++ == 0 ? movements_heading() + print_movement(movement) : print_movement(movement));
            if (keeps_movements_)
                movements_.push_back(movement_json(movement));
            for (const LinkFinding& link : movement.links)
                flagged_ = flagged_ || !link.flags.empty();
        }
    }
    boost::json::array movements_json() && { return std::move(movements_); }

private:
    bool keeps_movements_;
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

/// Reports the results after the last sample.
void report(const Identifying& identifying, MovementList&& movements, boost::json::object& json) {
    print_out("\n" + print_verdicts(identifying.diagnosis()));
    for (auto& [key, value] : verdicts_json(identifying.diagnosis()))
        json[key] = value;
    json["sampling"] = sampling_json(identifying.diagnosis().sampling());
    json["samples"] = identifying.diagnosis().samples();
    json["movements"] = std::move(movements).movements_json();
}

} // namespace

ExitCode identify_as_service(const IdentifyOptions& typed, boost::json::object& json) {
    IdentifyOptions options = typed;
    settings_of(options); // reports wrong settings before anything is read
    InterruptedBySignals interruption;
    RecordPieces pieces(options.record, needs_of_service(options), print_warnings,
                        [&] { return interruption.requested(); });
    MovementList movements(!options.json.empty());
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
        movements.show(identifying->take(*piece));
        progress.show(fmt::format("{:.0f} Mbyte, {}", static_cast<double>(pieces.bytes()) / 1e6,
                                  counted(movements.count(), "movement")));
    }
    progress.clear();
    json["warnings"] = warnings_json(pieces.warnings());
    if (!identifying)
        return ExitCode::interrupted;
    movements.show(identifying->end());
    const bool alarmed = !identifying->diagnosis().alarms().empty();
    if (movements.count() == 0 && !alarmed && !pieces.stopped())
        refuse_rest(*identifying);
    const bool doubted = movements.flagged() || alarmed;
    report(*identifying, std::move(movements), json);
    if (pieces.stopped())
        return ExitCode::interrupted;
    return options.strict && doubted ? ExitCode::missed_tolerance : ExitCode::success;
}

} // namespace placedpar
