#pragma once

#include "netlist/language/made_netlist.hpp"
#include "occam/configuration/configured.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

/// Writes an occam configuration as a netlist. Records for the parts of the netlist from which places of the
/// configuration they come, so that an error in the netlist is reported there.
class NetlistWriter {
public:
    NetlistWriter(const Program& program, const Configured& configured, Reporter& reporter)
        : program_(program), configured_(configured), reporter_(reporter) {}

    /// Returns the netlist. The caller sets MadeNetlist::paths. REQUIRES: the configuration has no errors.
    MadeNetlist write();

private:
    void put(std::string_view text, const Place&);
    void put(std::string_view text) { text_ += text; }
    std::string new_name(const std::string& wanted);
    void write_nodes();
    bool are_nodes_alike(std::size_t object, std::size_t count) const;
    void write_nodes_of(std::size_t object);
    std::string flat_name(const Element&) const;
    void write_wires();
    void write_end(const WireEnd&);
    void write_processes();
    void write_kind(const Declaration& procedure, const std::vector<std::size_t>& processes);
    void write_values(std::size_t process);
    void write_channels();
    void write_placements();
    void write_channel_placement(const ChannelState&);
    void put_port(const ChannelEnd&);
    std::string path_of(const Declaration& procedure, const Place& used_at);

    const Program& program_;
    const Configured& configured_;
    Reporter& reporter_;
    MadeNetlist made_;
    std::string text_;
    std::set<std::string, std::less<>> names_;
    std::map<Element, std::string> elements_; ///< names of nodes and edges
    std::vector<std::string> processes_;      ///< names of the processes
};

} // namespace placedpar::occam
