#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "text/diagnostic.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// So many are declared; of a netlist that is refused too, as far as its statements could be executed.
struct Declared {
    std::size_t processors = 0, processes = 0;
};

struct ReadResult {
    std::optional<Network> network;      ///< there exactly if no diagnostic is an error
    std::vector<Diagnostic> diagnostics; ///< in the order of the text; at most 20 errors
    std::string not_shown = "";          ///< a line on how many more there were; "" if none
    Declared declared = {};
};

/// The diagnostics as people read them, and how many more there were.
std::string render(const ReadResult& result);

/// What a netlist finds around it.
struct ReadOptions {
    std::vector<std::filesystem::path> include_folders = {}; ///< where included files are, if not beside the including
    std::vector<std::string> faults = {};                    ///< stated by options: `t[0].link[1] silent (from = 20ms)`
    ProgramKinds programs = {};                              ///< a program that the netlist does not use is an error
};

/// What a netlist and the files that it includes say, before anything is set: read and parsed once, however many
/// networks are wanted. Nothing in it changes: it is copied without cost, and serves several threads at once.
class ParsedNetlist {
public:
    /// "-" is standard input, and its `#include` relative to the working directory. Throws nothing that the text can
    /// cause: what is wrong with it is said of each network.
    explicit ParsedNetlist(const std::filesystem::path& path, const ReadOptions& options = {});
    /// The same for a text that is not a file; `#include` is then relative to the working directory.
    static ParsedNetlist of_text(const std::string& text, const std::string& shown_path = "netlist",
                                 const ReadOptions& options = {});

    /// Elaborates and checks it with these settings. Throws nothing that the text or they can cause.
    ReadResult read(const Catalogue& catalogue, const Overrides& overrides = {}) const;

private:
    struct Syntax;
    explicit ParsedNetlist(std::shared_ptr<const Syntax> syntax) : syntax_(std::move(syntax)) {}

    std::shared_ptr<const Syntax> syntax_;
};

/// A netlist of which one network is wanted.
ReadResult read_netlist(const std::filesystem::path& path, const Catalogue& catalogue, const Overrides& overrides = {},
                        const ReadOptions& options = {});

/// The same for a text that is not a file.
ReadResult read_netlist_text(const std::string& text, const Catalogue& catalogue, const Overrides& overrides = {},
                             const std::string& shown_path = "netlist", const ReadOptions& options = {});

} // namespace placedpar
