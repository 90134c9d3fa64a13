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

/// Says how source files are compiled.
struct CompileChoices {
    std::string mode = "halt";   ///< effect of an error at run time: halt, stop or universal
    bool range_checks = true;    ///< checks of subscripts and the like
    bool run_time_checks = true; ///< whether errors at run time, including overflow, are checked
};

/// Makes process kinds from source files, and images from the processes on a node. A netlist names a source file as the
/// program of a process. Several threads may use one object.
class FileKinds {
public:
    virtual ~FileKinds() = default;

    /// Returns whether a program is the name of a source file, such as "phil.occ" or "phil.occ#fork".
    virtual bool is_file(std::string_view program) const = 0;
    /// Reads the file. Searches first the folder of the text that names the file, then `folders`. Returns the name by
    /// which find() knows the kind; "" after reporting errors. Files that have not changed are not read again.
    virtual std::string read(const std::string& program, const Location& named_at,
                             const std::vector<std::filesystem::path>& folders, Reporter&) = 0;
    /// Returns the kind of a name that read() has returned; null for any other name.
    virtual const ProcessKind* find(std::string_view name) const = 0;
    /// Returns the paths of the files from which the kind is made, without files that are built into the program.
    virtual std::vector<std::string> files_of(std::string_view name) const = 0;

    /// States how image() compiles from now on.
    virtual void choose(const CompileChoices&) = 0;
    /// Makes the program of a node: all its processes that are code, and code that passes on messages between such
    /// processes on other nodes. Returns null after reporting errors. REQUIRES: a channel between this program and a
    /// process that is not code shares no wire of the node with another channel in its direction.
    virtual std::shared_ptr<const transputer::Image> image(const Network&, std::size_t node, Reporter&) = 0;
};

/// Returns the link that connects the node to its host; nothing if the node has no host.
std::optional<int> link_to_host(const Network&, std::size_t node);

} // namespace placedpar
