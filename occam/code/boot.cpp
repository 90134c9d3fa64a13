#include "occam/code/compile.hpp"
#include "runtime/transputer/assembler.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::occam {

namespace {

/// The loader reads the code behind it, and goes to it. The numbers in front of it are offsets from the start of
/// memory. The workspace of the program may cover the loader, which is no longer needed then.
constexpr const char* loader = R"(
        ajw 4                           -- instructions use words below the workspace
        stl 0; stl 0; stl 1             -- A and B are not needed; C is the link
        mint; sthf; mint; stlf          -- no process is ready
        ldc 0; stl 2; ldc 11; stl 3     -- channels and timers of the links, from the start of memory
clear:  mint; ldl 2; mint; wsub; stnl 0
        ldlp 2; ldc cleared - clear; lend
cleared:
        ldc 0; sttimer
        HALT
        testerr
        mint; ldnlp code; ldl 1; ldc length; in
        mint; ldnlp workspace; gajw
        mint; ldnlp start; adc offset; gcall
)";

std::string loader_source(const Code& code, const CodeOptions& options, transputer::Word code_at,
                          transputer::Word workspace) {
    std::string source = fmt::format("code = {}\nlength = {}\nworkspace = {}\nstart = {}\noffset = {}\n", code_at / 4,
                                     code.bytes.size(), workspace / 4, (code_at + code.entry) / 4, code.entry % 4);
    std::string text = loader;
    const bool halts = options.mode != ErrorMode::stop && options.run_time_checks;
    text.replace(text.find("HALT"), 4, halts ? "sethalterr" : "clrhalterr");
    if (code.entry % 4 == 0)
        text.replace(text.find("adc offset; "), 12, "");
    return source + text;
}

struct Loader {
    std::vector<std::uint8_t> bytes;
    transputer::Word code_at = 0;
};

Loader loader_for(const Code& code, const CodeOptions& options) {
    constexpr transputer::Word bytes_beside = 44; // what its instructions use, and its variables
    const transputer::Word start = transputer::traits_of(options.model).memory_start;
    const auto needed = static_cast<transputer::Word>(4 * code.workspace_words);
    const auto above = static_cast<transputer::Word>(4 * code.first_workspace_words);
    Loader made;
    // The length of the loader depends on the numbers in it.
    for (std::size_t length = 1; made.bytes.size() != length;) {
        length = made.bytes.size();
        made.code_at = start + std::max(needed, static_cast<transputer::Word>(length) + bytes_beside);
        made.code_at = (made.code_at + 3) / 4 * 4;
        made.bytes = transputer::assemble(loader_source(code, options, made.code_at, made.code_at - above)).bytes;
    }
    return made;
}

} // namespace

std::uint32_t where_code_is(const Code& code, const CodeOptions& options) { return loader_for(code, options).code_at; }

std::vector<std::uint8_t> bootable(const Code& code, const CodeOptions& options) {
    std::vector<std::uint8_t> file = loader_for(code, options).bytes;
    file.insert(file.begin(), static_cast<std::uint8_t>(file.size()));
    file.insert(file.end(), code.bytes.begin(), code.bytes.end());
    return file;
}

} // namespace placedpar::occam
