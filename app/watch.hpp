#pragma once

#include "gaprocs/generation_log.hpp"

#include <chrono>
#include <cstddef>
#include <string>

namespace placedpar {

/// Shows a GenerationLog on standard error during the run. On a terminal it draws the curve of the searches, at the
/// terminal's present width, and redraws it at most ten times a second. Elsewhere it prints a line for generations 1,
/// 2, 5, 10, 20 and so on. It changes no terminal mode, so the terminal is intact however the program ends.
class Watch final : public SearchObserver {
public:
    /// `heading` is the first line. The log receives all events. REQUIRES: the log outlives this object.
    Watch(GenerationLog& log, std::string heading);

    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration& migration) override { log_.observe(migration); }
    void observe(const ObservedAnswer& answer) override { log_.observe(answer); }
    /// Shows the ending.
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
