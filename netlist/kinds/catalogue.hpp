#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/process_kind.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

class FileKinds; // netlist/kinds/file_kinds.hpp

/// Holds the kinds of processes and devices that a netlist can name. Every catalogue has the devices of devices.hpp. A
/// program adds the kinds of its processes, and further devices.
class Catalogue {
public:
    Catalogue();

    /// Adds a kind of process. Throws std::logic_error if the catalogue has a kind of this name already.
    void add(ProcessKind kind);
    /// Returns the kind of process of this name; null if there is none. The name of a kind that files() has made is the
    /// name of its file.
    const ProcessKind* find(std::string_view name) const;
    const std::map<std::string, ProcessKind, std::less<>>& kinds() const { return kinds_; }

    std::vector<std::string> kind_names() const;

    /// Adds a kind of device. Throws std::logic_error if its name, or the name of one of its models, is already in the
    /// catalogue, or if one of its attributes has no default.
    void add_device(DeviceKind kind);
    const std::map<std::string, std::shared_ptr<const DeviceKind>, std::less<>>& devices() const { return devices_; }
    /// Returns the types with which a netlist can declare nodes, such as T800. The names are those of the devices'
    /// models.
    const std::map<std::string, NodeType, std::less<>>& node_types() const { return node_types_; }

    /// Lets netlists name source files in occam as programs; `files` makes kinds from them. REQUIRES: called at most
    /// once.
    void make_from_files(std::shared_ptr<FileKinds> files) { files_ = std::move(files); }
    /// Returns the argument of make_from_files(); null if it was not called.
    FileKinds* files() const { return files_.get(); }

private:
    std::map<std::string, ProcessKind, std::less<>> kinds_;
    std::shared_ptr<FileKinds> files_;
    std::map<std::string, std::shared_ptr<const DeviceKind>, std::less<>> devices_;
    std::map<std::string, NodeType, std::less<>> node_types_;
};

} // namespace placedpar
