#include "report/manifest.hpp"

#include "text/utf8.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace placedpar {

const char* const version = PLACEDPAR_VERSION;

std::string version_text() {
    std::string_view known = commit;
    return known.empty() ? version : fmt::format("{} (commit {})", version, known);
}

std::string hex(std::uint64_t word) { return fmt::format("{:016x}", word); }

namespace {

boost::json::object object_of(const std::map<std::string, std::string>& values) {
    boost::json::object object;
    for (const auto& [name, value] : values)
        object[name] = value;
    return object;
}

boost::json::array set_json(const Network& network) {
    boost::json::array set;
    for (const SetByOption& each : network.set)
        set.push_back(
            boost::json::object{{"name", each.name},
                                {"value", each.value},
                                {"elements", boost::json::array(each.elements.begin(), each.elements.end())}});
    return set;
}

} // namespace

boost::json::object manifest_json(const Manifest& manifest, const Network& network) {
    boost::json::array folders;
    for (const auto& folder : manifest.read.include_folders)
        folders.emplace_back(folder.string());
    boost::json::object json{{"version", version},
                             {"commit", commit},
                             {"command", manifest.command},
                             {"netlist", network.source_path},
                             {"netlist_hash", hex(network.hash)},
                             {"overrides", object_of(manifest.overrides)},
                             {"set", set_json(network)},
                             {"programs", object_of(manifest.read.programs)},
                             {"include_folders", std::move(folders)},
                             {"seed", manifest.seed}};
    if (!manifest.read.faults.empty())
        json["faults"] = boost::json::array(manifest.read.faults.begin(), manifest.read.faults.end());
    if (manifest.until != Time::max())
        json["until_ps"] = manifest.until.count();
    if (manifest.shuffle)
        json["shuffle"] = *manifest.shuffle;
    return json;
}

namespace {

class PrettyPrinter {
public:
    std::string print(const boost::json::value& value) {
        add(value, 0);
        out_ += "\n";
        return std::move(out_);
    }

private:
    void add(const boost::json::value& value, std::size_t depth) {
        if (const auto* object = value.if_object(); object && !object->empty())
            add_all(*object, '{', '}', depth, [&](const auto& member) {
                out_ += boost::json::serialize(member.key()) + ": ";
                add(member.value(), depth + 1);
            });
        else if (const auto* array = value.if_array(); array && !array->empty())
            add_all(*array, '[', ']', depth, [&](const auto& element) { add(element, depth + 1); });
        else
            add_scalar(value);
    }

    template <class Container, class AddOne>
    void add_all(const Container& container, char open, char close, std::size_t depth, AddOne add_one) {
        out_ += open;
        const char* separator = "\n";
        for (const auto& each : container) {
            out_ += separator + std::string(2 * (depth + 1), ' ');
            add_one(each);
            separator = ",\n";
        }
        out_ += "\n" + std::string(2 * depth, ' ') + close;
    }

    /// Writes a number in the shortest form that reads back as the same number; Boost writes 86.4 as 8.64E1. A number
    /// that is not finite becomes null, since JSON has none.
    void add_scalar(const boost::json::value& value) {
        if (!value.is_double())
            out_ += boost::json::serialize(value);
        else
            out_ += std::isfinite(value.get_double()) ? fmt::format("{}", value.get_double()) : "null";
    }

    std::string out_;
};

} // namespace

std::string print_pretty(const boost::json::value& value) { return as_json(PrettyPrinter().print(value)); }

} // namespace placedpar
