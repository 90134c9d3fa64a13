#include "app/identify/many_records.hpp"

#include "app/identify/record_pieces.hpp"
#include "app/identify/trend.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/identify/identifying.hpp"
#include "explore/identify/question.hpp"
#include "hydraulics/data/clock_time.hpp"
#include "identification/on_line/moving_identification.hpp"
#include "identification/verdict/mean_deviation.hpp"
#include "picture/gnuplot.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// The movements of one link in one record.
struct LinkMovements {
    std::vector<Deviation> deviations;
    WayUnits units{};
};

/// Collects the movements of an excavator in one record that determine the deviations of its links well enough
/// (is_evidence()).
class MovementsOfRecord {
public:
    explicit MovementsOfRecord(const Diagnosis& diagnosis) : diagnosis_(diagnosis) {}

    void take(const std::vector<MovementFinding>& found) {
        count_ += found.size();
        impossible_ += static_cast<std::size_t>(std::ranges::count_if(found, has_impossible));
        for (const MovementFinding& movement : found)
            for (const LinkFinding& link : movement.links)
                if (link.whole && is_evidence(link)) {
                    links_[index_of(link.link)].deviations.push_back(link.whole->deviation.with_steady_leak());
                    links_[index_of(link.link)].units = link.whole->units;
                }
    }
    void add_to(RecordAnswer& answer) const {
        answer.why_none = why_none();
        for (Link link : all_links)
            if (const auto& [deviations, units] = links_[index_of(link)]; !deviations.empty()) {
                const Deviation mean = mean_deviation(deviations);
                const double health = diagnosis_.health_in3_per_psi(link);
                auto set = [&, link = link](TrendValue value, FaultHypothesis way, double zero, double unit) {
                    answer.of(link, value) = {zero + unit * mean.by[index_of(way)], unit * mean.standard_error(way)};
                };
                set(TrendValue::compliance, FaultHypothesis::compliance, health, units.compliance_in3_per_psi);
                set(TrendValue::leak, FaultHypothesis::leak, 0, units.leak_in3_per_s_psi);
                if (deviations.front().by[index_of(FaultHypothesis::offset)] != 0) // areas that are measured directly
                                                                                   // have no offset
                    set(TrendValue::offset, FaultHypothesis::offset, 0, units.offset_in);
            }
    }

private:
    static bool is_impossible(const LinkFinding& link) {
        return std::ranges::any_of(link.flags, [](const Flag& flag) { return flag.kind == FlagKind::impossible; });
    }
    static bool has_impossible(const MovementFinding& movement) {
        return std::ranges::any_of(movement.links, is_impossible);
    }

    std::string why_none() const {
        if (count_ == 0)
            return "the record has no movement of the link";
        if (impossible_ > 0)
            return fmt::format("{} of {} have impossible readings", impossible_, counted(count_, "movement"));
        return fmt::format("{} of too little change of pressure, or with too much noise", counted(count_, "movement"));
    }

    bool is_evidence(const LinkFinding& link) const {
        return !is_impossible(link) &&
               LinkJudge::is_evidence(link.whole->deviation,
                                      link.whole->deviation.by[index_of(FaultHypothesis::offset)] == 0
                                          ? AreasFrom::areas
                                          : AreasFrom::spool);
    }

    const Diagnosis& diagnosis_;
    PerLink<LinkMovements> links_;
    std::size_t count_ = 0, impossible_ = 0; ///< number of movements; number of those with impossible readings
};

/// Returns the standard deviation of the error that inexact equations cause in a compliance. This error differs from
/// record to record (identification/verdict/deviation.hpp).
double repeat_error(double healthy_in3_per_psi) {
    return repeats_within * WayUnits::of(healthy_in3_per_psi).compliance_in3_per_psi;
}

std::string_view name_of_source(AreasFrom areas) {
    switch (areas) {
    case AreasFrom::areas: return "from the areas as read";
    case AreasFrom::spool: return "from the spool";
    case AreasFrom::servo: return "from the servo-valve's voltage";
    }
    return "";
}

/// Throws UserError if a link's compliance comes from another source of areas than in an earlier record. Each source
/// has its own error, so the difference would look like a change.
void require_equal_sources(const std::vector<RecordAnswer>& before, const RecordAnswer& answer) {
    for (Link link : all_links)
        for (const RecordAnswer& each : before) {
            const std::string_view here = answer.source[index_of(link)], there = each.source[index_of(link)];
            if (!here.empty() && !there.empty() && here != there)
                throw UserError(fmt::format(
                    "{}: the compliance of the {} is found {}, but in {} {}: expected one source in all records; "
                    "choose it by --areas-from, or by --configuration if it is recognised only in some records",
                    answer.record, name_of(link), here, each.record, there));
        }
}

/// Returns the date in the file's name, or else in its folder's name.
std::optional<double> date_in_path(const std::filesystem::path& path) {
    const auto of_file = date_in_name(path.filename().string());
    return of_file ? of_file : date_in_name(path.parent_path().filename().string());
}

/// Reads the records one after another.
class TrendReader {
public:
    explicit TrendReader(const IdentifyOptions& options) : options_(options) {
        if (options_.configuration.empty())
            fixed_.configuration = "a";
    }

    bool stopped() const { return interruption_.requested(); }
    /// Reads a record and returns its answer. The answer has no values if no movement of the record counts as evidence.
    /// Throws RefusedInput and UnfitRecord.
    RecordAnswer read(const std::string& path) {
        ++number_;
        RecordPieces pieces(path, needs_of_service(options_), print_warnings, [&] { return stopped(); });
        RecordAnswer answer{path, std::nullopt};
        if (auto first = pieces.next()) {
            answer.date_s = pieces.begun_s() ? pieces.begun_s() : date_in_path(path);
            moves(options_, first->channels()) ? follow_moving(std::move(*first), pieces, answer)
                                               : follow(std::move(*first), pieces, answer);
        }
        answer.warnings = pieces.warnings();
        progress_.clear();
        return answer;
    }

private:
    void follow(Record first, RecordPieces& pieces, RecordAnswer& answer) {
        const ChannelSet channels = first.channels();
        Identifying identifying(fixed_, first, print_warnings);
        MovementsOfRecord movements(identifying.diagnosis());
        read_all(std::move(first), pieces, [&](const Record& piece) { movements.take(identifying.take(piece)); });
        movements.take(identifying.end());
        movements.add_to(answer);
        for (Link link : links_of(identifying.links()))
            if (answer.of(link, TrendValue::compliance))
                answer.source[index_of(link)] = name_of_source(areas_from(channels, link, areas_asked(options_)));
    }

    void follow_moving(Record first, RecordPieces& pieces, RecordAnswer& answer) {
        require_no_fixed_settings(options_);
        const LinkSet wanted = links_that_move(options_);
        MovingIdentification moving(
            load_machine(options_.machine, print_warnings),
            [&](std::size_t links) { return moving_way(options_, links); }, options_.seed);
        read_all(std::move(first), pieces, [&](const Record& piece) { moving.take(piece); });
        if (stopped())
            return;
        answer.why_none = "the link moves too little, or its compliance is doubtful";
        for (const LinkIdentified& link : combined_links(moving.sets()))
            if (link.flags.empty() && wanted.contains(link.link)) {
                answer.source[index_of(link.link)] = "with the configuration recognised";
                answer.of(link.link, TrendValue::compliance) = {
                    link.compliance_in3_per_psi,
                    std::hypot(link.standard_error, repeat_error(moving.healthy_in3_per_psi(link.link)))};
            }
    }

    void read_all(Record first, RecordPieces& pieces, const std::function<void(const Record&)>& take) {
        for (std::optional<Record> piece = std::move(first); piece; piece = pieces.next()) {
            take(*piece);
            progress_.show(fmt::format("record {} of {}, {:.0f} Mbyte", number_, options_.records.size(),
                                       static_cast<double>(pieces.bytes()) / 1e6));
        }
    }

    const IdentifyOptions& options_;
    IdentifySettings fixed_ = options_; ///< settings with a configuration
    InterruptedBySignals interruption_;
    ProgressLine progress_;
    std::size_t number_ = 0; ///< number of the current record, from 1
};

/// Returns whether a link changes, or has no answer in some record.
bool is_doubtful(const Trend& trend) {
    const std::vector<Link> links = links_of(trend.links());
    const auto lacks_one = [&](const RecordAnswer& answer) {
        return std::ranges::any_of(links, [&](Link link) { return !answer.of(link, TrendValue::compliance); });
    };
    return !trend.changes().empty() || std::ranges::any_of(trend.answers(), lacks_one);
}

} // namespace

ExitCode identify_trend(const IdentifyOptions& options, boost::json::object& json) {
    settings_of(options); // reports wrong settings before any record is read
    if (!options.trend.empty())
        require_gnuplot();
    std::vector<RecordAnswer> answers;
    TrendReader reader(options);
    for (const std::string& record : options.records) {
        try {
            RecordAnswer answer = reader.read(record);
            require_equal_sources(answers, answer);
            answers.push_back(std::move(answer));
        } catch (const UnfitRecord& unfit) {
            throw RefusedInput(fmt::format("{}: error: {}\n", shown_input(record), unfit.what()));
        }
        if (reader.stopped()) {
            answers.pop_back(); // the record was not read to its end
            break;
        }
    }
    const Trend trend(std::move(answers));
    if (trend.links().empty() && !reader.stopped())
        throw UserError("no record has a movement from which a compliance can be identified");
    print_out(print_trend(trend));
    if (reader.stopped())
        return ExitCode::interrupted;
    if (!options.trend.empty())
        write_whole(options.trend, trend_svg(trend));
    for (auto& [key, value] : trend_json(trend))
        json[key] = value;
    return options.strict && is_doubtful(trend) ? ExitCode::missed_tolerance : ExitCode::success;
}

} // namespace placedpar
