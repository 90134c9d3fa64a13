#include "explore/identify/ways.hpp"

#include "explore/identify/identifying.hpp"
#include "explore/identify/question.hpp"
#include "identification/report/diagnosis_report.hpp"
#include "text/counted.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// Prints movements, and stores them for JSON if the output needs them.
class MovementList {
public:
    /// REQUIRES: the output outlives the list.
    explicit MovementList(const IdentifyOutput& output) : output_(output) {}

    std::size_t count() const { return count_; }
    bool flagged() const { return flagged_; }

    void show(const std::vector<MovementFinding>& found) {
        for (const MovementFinding& movement : found) {
            output_.print(count_++ == 0 ? movements_heading() + print_movement(movement) : print_movement(movement));
            if (output_.keeps_movements)
                movements_.push_back(movement_json(movement));
            for (const LinkFinding& link : movement.links)
                flagged_ = flagged_ || !link.flags.empty();
        }
    }
    boost::json::array json() && { return std::move(movements_); }

private:
    const IdentifyOutput& output_;
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

/// Reports the results after the last sample.
void report(const Identifying& identifying, MovementList&& movements, const IdentifyOutput& output) {
    output.print("\n" + print_verdicts(identifying.diagnosis()));
    for (auto& [key, value] : verdicts_json(identifying.diagnosis()))
        output.json[key] = value;
    output.json["sampling"] = sampling_json(identifying.diagnosis().sampling());
    output.json["samples"] = identifying.diagnosis().samples();
    output.json["movements"] = std::move(movements).json();
}

/// Reports the results when the record ends or is stopped.
IdentifyEnd end(Identifying& identifying, MovementList&& movements, const RecordStream& pieces,
                const IdentifyOutput& output) {
    movements.show(identifying.end());
    const bool alarmed = !identifying.diagnosis().alarms().empty();
    if (movements.count() == 0 && !alarmed && !pieces.stopped())
        refuse_rest(identifying);
    const bool doubted = movements.flagged() || alarmed;
    report(identifying, std::move(movements), output);
    if (pieces.stopped())
        return IdentifyEnd::interrupted;
    return doubted ? IdentifyEnd::doubtful : IdentifyEnd::sound;
}

} // namespace

IdentifyEnd identify_as_service(const IdentifySettings& given, const RecordInput& input, const IdentifyOutput& output) {
    IdentifySettings settings = given;
    settings_of(settings); // reports wrong settings before anything is read
    const auto pieces = input.pieces(needs_of_service(settings));
    MovementList movements(output);
    std::optional<Identifying> identifying;
    while (auto piece = pieces->next()) {
        if (!identifying && moves(settings, piece->channels()))
            return identify_moving(settings, std::move(*piece), *pieces, output);
        if (!identifying) {
            if (settings.configuration.empty())
                settings.configuration = "a";
            identifying.emplace(settings, *piece, output.warn);
            output.print(print_beginning(*identifying, settings));
        }
        movements.show(identifying->take(*piece));
        output.progress(fmt::format("{:.0f} Mbyte, {}", static_cast<double>(pieces->bytes()) / 1e6,
                                    counted(movements.count(), "movement")));
    }
    output.json["warnings"] = warnings_json(pieces->warnings());
    return identifying ? end(*identifying, std::move(movements), *pieces, output) : IdentifyEnd::interrupted;
}

} // namespace placedpar
