#pragma once

#include "runtime/fingerprint.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Where the figure in a cell comes from.
enum class Origin {
    outcome,    ///< of the simulation, nothing was fitted to it
    calibrated, ///< one constant was fitted to this cell
    workload    ///< a constant of the program's own cost was read off this cell
};

/// One figure of a table of the thesis beside the simulated one.
struct Cell {
    std::string row, column, unit;
    std::optional<double> thesis;
    double simulated;
    std::optional<double> tolerance_percent; ///< none: printed, not judged
    Origin origin = Origin::outcome;

    /// Of the thesis's figure; 0 where both are 0. None without a figure to compare with.
    std::optional<double> error_percent() const;
    bool within_tolerance() const;
};

/// One way of reading an experiment, run.
struct Reading {
    std::string name;
    std::vector<Cell> cells;
    std::string notes; ///< for people, below the table
};

/// An experiment of the thesis, run. The first reading is the default one, by which it is judged.
struct Replay {
    std::vector<Reading> readings;
    std::string constants; ///< for people: which were published, stated as workload, calibrated
    std::uint64_t fingerprint = 0;
};

struct ReplayContext {
    std::filesystem::path examples;
    std::uint64_t seed;
    std::function<void(const std::string&)> progress; ///< what is being run
};

struct Experiment {
    std::string name;
    std::string about;
    std::function<Replay(const ReplayContext&)> run;
};

const std::vector<Experiment>& experiments();

Replay replay_table_e1(const ReplayContext&);
Replay replay_table_e2(const ReplayContext&);

/// A table for people: each cell as simulated, thesis and error.
std::string print_reading(const Reading&);
const char* name_of(Origin);

} // namespace placedpar
