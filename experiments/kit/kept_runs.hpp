#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// What one run of an experiment gave, in an order that the experiment knows.
using Figures = std::vector<double>;

/// A file that keeps the figures of every run as soon as it ends, so that an experiment that was interrupted goes on
/// where it stood. One line a run; figures to their last bit.
class KeptRuns {
public:
    /// Takes the runs that are in the file, if there is one; a last line that was not written to its end is dropped.
    /// `of`: what the runs belong to, in one line. Throws UserError: the file belongs to something else or is no such
    /// file, or cannot be written.
    KeptRuns(const std::filesystem::path& path, const std::string& of);

    std::optional<Figures> find(const std::string& what, std::uint64_t seed) const;
    /// Throws UserError when it cannot be written. REQUIRES: `what` has no tabulator and no end of line.
    void add(const std::string& what, std::uint64_t seed, const Figures& figures);

private:
    void read(const std::string& of);
    void write(const std::string& line);

    std::filesystem::path path_;
    std::map<std::pair<std::string, std::uint64_t>, Figures> runs_;
    std::vector<std::string> lines_; ///< of the file, as it was found
    std::ofstream out_;
};

} // namespace placedpar
