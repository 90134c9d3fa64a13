#pragma once

#include "gaprocs/generation_log.hpp"

#include <chrono>
#include <cstddef>
#include <string>

namespace placedpar {

/// Shows on standard error how a genetic search advances during a run. On a terminal, draws the curve of the fitness,
/// at the terminal's present width, and redraws it at most ten times a second. Elsewhere, prints a line for generations
/// 1, 2, 5, 10, 20 and so on. It changes no mode of the terminal, so the terminal is intact however the program ends.
class Watch final : public SearchObserver {
public:
    /// `heading` is the first line. `log` receives all events of the run. REQUIRES: the log outlives this object.
    Watch(GenerationLog& log, std::string heading);

    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration& migration) override { log_.observe(migration); }
    void observe(const ObservedAnswer& answer) override { log_.observe(answer); }
    /// Shows the state at the end of the run.
    void finish();

private:
    using Clock =
        std::chrono::steady_clock; // wall-clock time; it decides only when to draw, and does not affect the run

    void show();
    void draw();
    void say_milestone();

    GenerationLog& log_;
    std::string heading_;
    bool terminal_;
    Clock::time_point drawn_{};
    std::size_t lines_ = 0;          ///< number of lines drawn last
    std::size_t next_milestone_ = 1; ///< next generation for which a line is printed
    std::string said_;               ///< the last line that was printed for a milestone
};

} // namespace placedpar
