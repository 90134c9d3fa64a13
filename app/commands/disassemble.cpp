#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "runtime/transputer/code_text.hpp"
#include "text/counted.hpp"
#include "text/number.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

struct DisassembleOptions {
    std::string file, processor = "T800", from, until;
};

/// Reads a position in a file: a hexadecimal number as in this command's output, "+0046F", or a decimal number, "1135".
/// Returns nullopt for any other text.
std::optional<std::size_t> position_of(std::string_view text) {
    const bool hexadecimal = text.starts_with('+');
    if (hexadecimal)
        text.remove_prefix(1);
    return parse_number<std::size_t>(text, hexadecimal ? 16 : 10);
}

std::string not_a_position(const std::string& text) {
    return position_of(text) ? ""
                             : fmt::format("\"{}\" is not a position: write 1135, or +0046F as in the output", text);
}

/// Throws UserError if the range has no bytes of the file.
transputer::FileRange typed_range(const DisassembleOptions& options, std::size_t bytes) {
    const transputer::FileRange range{.from = position_of(options.from).value_or(0),
                                      .until = position_of(options.until).value_or(bytes)};
    if (range.from >= std::min(range.until, bytes))
        throw UserError(fmt::format("{}: the range from position {} to {}, end excluded, has no byte: the file has {}",
                                    options.file, range.from, range.until, counted(bytes, "byte")));
    return range;
}

ExitCode disassemble_file(const DisassembleOptions& options) {
    const std::vector<std::uint8_t> file = read_bootable(options.file);
    const transputer::FileRange range = typed_range(options, file.size());
    print_out(fmt::format("{}: {}, disassembled for a {}\n"
                          "+: position in the file. ?: these bytes may be data, because no path from the start of the "
                          "code to them was found. The last "
                          "column has the cycles of a block, with code and data on the chip.\n",
                          options.file, counted(file.size(), "byte"), options.processor));
    std::string text;
    transputer::print_bootable(file, *transputer::model_named(options.processor), range, [&](std::string_view part) {
        text += part;
        if (text.size() > 65'536)
            print_out(std::exchange(text, {}));
    });
    print_out(text);
    return ExitCode::success;
}

std::vector<std::string> names_of_models() {
    std::vector<std::string> names;
    for (const transputer::Traits& traits : transputer::all_traits)
        names.emplace_back(traits.name);
    return names;
}

Action declare_disassemble(Options& command, const std::string&) {
    auto options = std::make_shared<DisassembleOptions>();
    command.add("FILE", options->file, "a bootable file: .btl, .b4h, .b8h").required().check(not_a_named_file);
    command.add("--processor", options->processor, "type of the transputer that the code is for")
        .one_of(names_of_models())
        .show_default();
    const char* const type = "POSITION";
    command.add("--from", options->from, "begins at this position in the file").type(type).check(not_a_position);
    command.add("--until", options->until, "ends before this position in the file").type(type).check(not_a_position);
    return [options] { return disassemble_file(*options); };
}

} // namespace

extern const Command disassemble_command{
    .name = "disassemble",
    .about = "Prints the code in a bootable file of a transputer",
    .place = 45,
    .declare = declare_disassemble,
};

} // namespace placedpar
