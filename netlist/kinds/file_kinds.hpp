#pragma once

#include "netlist/kinds/process_kind.hpp"
#include "netlist/network/network.hpp"
#include "text/reporter.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Holds the options with which source files are compiled.
struct CompileChoices {
    std::string mode = "halt";   ///< effect of an error at run time: halt, stop or universal
    bool range_checks = true;    ///< whether subscripts, segments, conversions and counts are checked
    bool run_time_checks = true; ///< whether errors at run time, including overflow, are checked
};

/// Compiles occam for netlists. A netlist can name a source file in occam as the program of a process; this class makes
/// a kind of process from the file. For each node with such processes, it makes an image: the program that is in the
/// node's memory when the run begins. Several threads may use one object.
class FileKinds {
public:
    virtual ~FileKinds() = default;

    /// Returns whether the name of a program means a source file in occam, such as "phil.occ", or a PROC in this file,
    /// such as "phil.occ#fork".
    virtual bool is_file(std::string_view program) const = 0;
    /// Reads the file, and makes a kind from it. Searches first the folder of the netlist that names the file, then
    /// `folders`. Returns the name of the kind, for find(); "" after reporting errors. A file that has not changed is
    /// not read again.
    virtual std::string read(const std::string& program, const Location& named_at,
                             const std::vector<std::filesystem::path>& folders, Reporter&) = 0;
    /// Returns the kind of a name that read() has returned; null for any other name.
    virtual const ProcessKind* find(std::string_view name) const = 0;
    /// Returns the paths of the files from which the kind is made, without libraries that are built into PlacedPar.
    virtual std::vector<std::string> files_of(std::string_view name) const = 0;

    /// Sets the options with which image() compiles from now on.
    virtual void choose(const CompileChoices&) = 0;
    /// Makes the image of a node. The image has all processes in occam on the node, and processes that pass on messages
    /// between processes in occam on other nodes. Returns null after reporting errors. REQUIRES: if a channel leads
    /// from this node's processes in occam to a process in C++, or back, no other channel uses its wire in the same
    /// direction.
    virtual std::shared_ptr<const transputer::Image> image(const Network&, std::size_t node, Reporter&) = 0;
};

/// Returns the number of the link that connects the node to its host; nothing if the node has no host.
std::optional<int> link_to_host(const Network&, std::size_t node);

} // namespace placedpar
