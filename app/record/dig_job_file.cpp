#include "app/record/dig_job_file.hpp"

#include "explore/study/toml_reader.hpp"
#include "hydraulics/data/units.hpp"

#include <cmath>
#include <utility>

namespace placedpar {

using namespace hydraulics;

namespace {

class DigJobReader : TomlReader {
public:
    DigJobReader(const std::string& path, const MovingExcavator& machine) : TomlReader(path, "job"), machine_(machine) {
        job_.name = path;
    }

    DigJob read() {
        const toml::table top = parsed();
        std::uint64_t repeat = 1;
        read_table(top,
                   {{"about", [&](const toml::node& node) { job_.about = text(node); }},
                    {"repeat", [&](const toml::node& node) { repeat = whole(node, 1, 1000); }},
                    {"start", [&](const toml::node& node) { read_start(node); }},
                    {"move", [&](const toml::node& node) { read_moves(node); }}},
                   "job");
        if (!started_ || job_.moves.empty())
            report(top.source().begin, "a job needs a start and at least one move",
                   "start = {reach = 300, height = -20, pitch = -60, swing = 0} and [[move]]");
        refuse_if_failed();
        const std::vector<JoystickMove> once = job_.moves;
        for (std::uint64_t i = 1; i < repeat; ++i)
            job_.moves.insert(job_.moves.end(), once.begin(), once.end());
        require_feasible(once.size());
        return std::move(job_);
    }

private:
    static constexpr double most_s = 600;

    double number(const toml::node& node, double least, double most) {
        const double value = node.is_number() ? node.value_or(0.0) : std::nan("");
        if (!(value >= least && value <= most)) {
            report(node.source().begin, fmt::format("expected a number from {:g} to {:g}", least, most));
            return least;
        }
        return value;
    }

    Handlers handlers_of(TipPose& pose) {
        constexpr double most = 1000;
        return {{"reach", [&](const toml::node& node) { pose.reach_in = number(node, -most, most); }},
                {"height", [&](const toml::node& node) { pose.height_in = number(node, -most, most); }},
                {"pitch", [&](const toml::node& node) { pose.pitch_rad = number(node, -most, most) / deg_per_rad; }},
                {"swing", [&](const toml::node& node) { pose.swing_rad = number(node, -most, most) / deg_per_rad; }}};
    }

    void read_start(const toml::node& node) {
        started_ = true;
        if (const toml::table* table = node.as_table())
            read_table(*table, handlers_of(job_.start), "start");
        else
            report(node.source().begin, "expected a table with the pose of the arm",
                   "start = {reach = 300, height = -20, pitch = -60, swing = 0}");
    }

    void read_moves(const toml::node& node) {
        for (const toml::table* table : tables_in(node, "expected tables of moves", "[[move]]")) {
            JoystickMove move{0, {}, 0, table->source().begin.line};
            Handlers handlers = handlers_of(move.velocity);
            handlers["seconds"] = [&](const toml::node& each) { move.seconds = number(each, 0.02, most_s); };
            handlers["soil"] = [&](const toml::node& each) { move.soil_lbf = number(each, 0, 1e6); };
            read_table(*table, handlers, "move");
            if (move.seconds == 0)
                report(table->source().begin, "the move has no duration", "seconds = 2");
            job_.moves.push_back(move);
            places_.push_back(table->source().begin);
        }
    }

    void require_feasible(std::size_t moves) {
        if (job_.duration_s() > most_s)
            report(places_.front(),
                   fmt::format("the job lasts {:g} s, expected at most {:g}", job_.duration_s(), most_s),
                   "use fewer moves, or a smaller repeat");
        else if (auto move = unreachable_move(job_, machine_.arm, machine_.joystick_lag_s, machine_.control_period_s))
            report(
                places_[*move % moves],
                fmt::format("the arm does not reach the tip's path in {}",
                            *move < moves ? "this move" : "a repetition of this move"),
                "use a shorter or slower move, or another start; with repeat, the moves should lead back to the start");
        refuse_if_failed();
    }

    const MovingExcavator& machine_;
    DigJob job_;
    bool started_ = false;
    std::vector<toml::source_position> places_; ///< places of the moves in the file
};

} // namespace

DigJob load_dig_job(const std::string& path, const MovingExcavator& machine) {
    return DigJobReader(path, machine).read();
}

} // namespace placedpar
