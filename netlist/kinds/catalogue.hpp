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

/// Holds the kinds of processes and devices by name; netlists are read with a catalogue. Every catalogue has the
/// devices of this room; a program adds its process kinds and its own devices.
class Catalogue {
public:
    Catalogue();

    /// Throws std::logic_error if the catalogue has a process kind of this name already.
    void add(ProcessKind kind);
    /// Returns null if there is no kind of this name. Kinds that files() has read have the names of their files.
    const ProcessKind* find(std::string_view name) const;
    const std::map<std::string, ProcessKind, std::less<>>& kinds() const { return kinds_; }

    std::vector<std::string> kind_names() const;

    /// Throws std::logic_error if the name of the kind or of one of its models is already in the catalogue, or if an
    /// attribute has no default.
    void add_device(DeviceKind kind);
    const std::map<std::string, std::shared_ptr<const DeviceKind>, std::less<>>& devices() const { return devices_; }
    /// Returns the types with which nodes can be declared, by the names of the models.
    const std::map<std::string, NodeType, std::less<>>& node_types() const { return node_types_; }

    /// Lets netlists use kinds that are made from source files. REQUIRES: called once.
    void make_from_files(std::shared_ptr<FileKinds> files) { files_ = std::move(files); }
    /// Returns null if no kinds are made from source files.
    FileKinds* files() const { return files_.get(); }

private:
    std::map<std::string, ProcessKind, std::less<>> kinds_;
    std::shared_ptr<FileKinds> files_;
    std::map<std::string, std::shared_ptr<const DeviceKind>, std::less<>> devices_;
    std::map<std::string, NodeType, std::less<>> node_types_;
};

} // namespace placedpar
