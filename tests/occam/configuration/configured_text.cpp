#include "tests/occam/configuration/configured_text.hpp"

#include "occam/configuration/configuration.hpp"
#include "text/load_source.hpp"

namespace placedpar::test {

ReadOptions configuration_options() {
    ReadOptions options;
    options.make_netlist = occam::netlist_of_configuration;
    return options;
}

MadeText made_from(const std::filesystem::path& path) {
    Reporter reporter;
    const MadeNetlist made = occam::netlist_of_configuration(load_source(path).file, {}, {}, reporter);
    return {made.text ? made.text->text() : "", render(reporter.take())};
}

} // namespace placedpar::test
