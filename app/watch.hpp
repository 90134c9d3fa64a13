#pragma once

#include "gaprocs/generation_log.hpp"

#include <chrono>
#include <cstddef>
#include <string>

namespace placedpar {

/// Shows a log on standard error while it is written: on a terminal the curve of the searches, drawn anew in its place
/// at most ten times a second and as wide as the terminal is then; elsewhere a line for the generations 1, 2, 5, 10, 20
/// and so on. It switches nothing on that would have to be switched off again, so that the terminal is whole however
/// the program ends.
class Watch final : public SearchObserver {
public:
    /// `heading` is the first line. The log is told of everything; it outlives this.
    Watch(GenerationLog& log, std::string heading);

    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration& migration) override { log_.observe(migration); }
    void observe(const ObservedAnswer& answer) override { log_.observe(answer); }
    /// Shows how it ended.
    void finish();

private:
    using Clock = std::chrono::steady_clock; // of the wall: it decides when to draw, and nothing of the run

    void show();
    void draw();
    void say_milestone();

    GenerationLog& log_;
    std::string heading_;
    bool terminal_;
    Clock::time_point drawn_{};
    std::size_t lines_ = 0;          ///< drawn last
    std::size_t next_milestone_ = 1; ///< a generation that gets a line
    std::string said_;               ///< the last such line
};

} // namespace placedpar
