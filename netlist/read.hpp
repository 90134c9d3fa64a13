#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/made_netlist.hpp"
#include "netlist/network/network.hpp"
#include "text/diagnostic.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Counts the processors and the processes that a netlist declares. A switch that a program can set, such as a C004,
/// counts as a processor. A statement with an error declares nothing.
struct Declared {
    std::size_t processors = 0, processes = 0;
};

struct ReadResult {
    std::optional<Network> network;      ///< set if and only if no diagnostic is an error
    std::vector<Diagnostic> diagnostics; ///< in the order of the text; at most 20 errors
    std::string not_shown = ""; ///< a text such as "... 3 more errors not shown"; "" if `diagnostics` is complete
    Declared declared = {};
};

/// Returns the diagnostics and `not_shown` as text.
std::string render(const ReadResult& result);

/// Holds options of the command line that affect how a netlist is read.
struct ReadOptions {
    std::vector<std::filesystem::path> include_folders =
        {};                               ///< searched for included files, after the folder of the including file
    std::vector<std::string> faults = {}; ///< faults stated by options: `t[0].link[1] silent (from = 20ms)`
    ProgramKinds programs = {}; ///< for each program that a `use` statement names, the kind of process that replaces
                                ///< it; an error if the netlist does not name the program
    NetlistMaker make_netlist = {}; ///< reads files in another language, such as occam
};

/// Holds the syntax of a netlist and of the files that it includes. The text is parsed once. Each call of read() then
/// makes a network from it, with other values set by options (overrides). The object is immutable: copies are cheap,
/// and several threads may use it at the same time.
class ParsedNetlist {
public:
    /// Reads the file; "-" is standard input. Files that standard input includes are relative to the working directory.
    /// Errors in the text are not thrown: each call of read() reports them.
    explicit ParsedNetlist(const std::filesystem::path& path, const ReadOptions& options = {});
    /// Parses a text that is not a file. Files that the text includes are relative to the working directory. Messages
    /// call the text `shown_path`.
    static ParsedNetlist of_text(const std::string& text, const std::string& shown_path = "netlist",
                                 const ReadOptions& options = {});

    /// Executes the statements of the netlist with these overrides, and checks the resulting network. Errors in the
    /// text or in the overrides are in the result; they are not thrown.
    ReadResult read(const Catalogue& catalogue, const Overrides& overrides = {}) const;

private:
    struct Syntax;
    explicit ParsedNetlist(std::shared_ptr<const Syntax> syntax) : syntax_(std::move(syntax)) {}

    std::shared_ptr<const Syntax> syntax_;
};

/// Parses and reads a netlist. Use ParsedNetlist if several networks are made from one netlist.
ReadResult read_netlist(const std::filesystem::path& path, const Catalogue& catalogue, const Overrides& overrides = {},
                        const ReadOptions& options = {});

/// Parses and reads a text that is not a file.
ReadResult read_netlist_text(const std::string& text, const Catalogue& catalogue, const Overrides& overrides = {},
                             const std::string& shown_path = "netlist", const ReadOptions& options = {});

} // namespace placedpar
