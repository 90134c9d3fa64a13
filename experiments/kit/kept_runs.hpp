#pragma once

#include <cstddef>
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
/// where it stood. One line a run, with a checksum; figures to their last bit.
class KeptRuns {
public:
    /// Takes the runs that are in the file, if there is one; a last line that was not written to its end is dropped.
    /// `of`: what the runs belong to, in one line. Throws UserError: the file belongs to something else or is no such
    /// file, one of its lines is damaged or there twice, or it cannot be written; it is left as it is then.
    KeptRuns(const std::filesystem::path& path, const std::string& of);

    std::optional<Figures> find(const std::string& what, std::uint64_t seed) const;
    /// Throws UserError when it cannot be written. REQUIRES: `what` has no tabulator and no end of line.
    void add(const std::string& what, std::uint64_t seed, const Figures& figures);

private:
    /// How long the file's whole lines are.
    std::size_t read();
    void read_line(const std::string& line, std::size_t number);
    void read_run(const std::string& line, std::size_t number);
    void write(const std::string& line);

    std::filesystem::path path_;
    std::string of_;
    std::map<std::pair<std::string, std::uint64_t>, Figures> runs_;
    std::ofstream out_;
};

} // namespace placedpar
