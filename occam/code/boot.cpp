#include "occam/code/compile.hpp"
#include "runtime/transputer/assembler.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::occam {

namespace {

/// The source text of the loader, the first code in a bootable file. It reads the program's code, which follows it in
/// the file, and jumps to this code. loader_source() adds the numbers `code`, `workspace` and `start`, in words from
/// the lowest address. The workspace of the program may cover the loader, which is not needed when the program runs.
constexpr const char* loader = R"(
        ajw 4                           -- instructions use words below the workspace
        stl 0; stl 0; stl 1             -- A and B are not needed; C is the address of the link
        mint; sthf; mint; stlf          -- no process is ready
        ldc 0; stl 2; ldc 11; stl 3     -- words 0 to 10 of the memory: links, event and timers
clear:  mint; ldl 2; mint; wsub; stnl 0
        ldlp 2; ldc cleared - clear; lend
cleared:
        ldc 0; sttimer
        HALT
        testerr
        INPUT
        mint; ldnlp workspace; gajw
        mint; ldnlp start; adc offset; gcall
)";

/// Returns the source text of the loader. If `is_there`, the code is already in memory, and the loader only jumps to
/// it.
std::string loader_source(const Code& code, const CodeOptions& options, transputer::Word code_at,
                          transputer::Word workspace, bool is_there) {
    std::string source = fmt::format("code = {}\nlength = {}\nworkspace = {}\nstart = {}\noffset = {}\n", code_at / 4,
                                     code.bytes.size(), workspace / 4, (code_at + code.entry) / 4, code.entry % 4);
    std::string text = loader;
    text.replace(text.find("INPUT"), 5, is_there ? "" : "mint; ldnlp code; ldl 1; ldc length; in");
    const bool halts = options.mode != ErrorMode::stop && options.run_time_checks;
    text.replace(text.find("HALT"), 4, halts ? "sethalterr" : "clrhalterr");
    if (code.entry % 4 == 0)
        text.replace(text.find("adc offset; "), 12, "");
    return source + text;
}

/// Lays out the memory: first the workspace, which may cover the loader, then the code.
transputer::Image laid_out(const Code& code, const CodeOptions& options, bool is_there) {
    constexpr transputer::Word bytes_beside = 44; // for words that the loader's instructions and variables use
    const transputer::Word start = transputer::traits_of(options.model).memory_start;
    const auto needed = static_cast<transputer::Word>(4 * code.workspace_words);
    const auto above = static_cast<transputer::Word>(4 * code.first_workspace_words);
    transputer::Image image;
    image.code = code.bytes;
    // The loader contains the address of the code, which depends on the length of the loader. The loader is therefore
    // assembled again until its length no longer changes.
    for (std::size_t length = 1; image.start.size() != length;) {
        length = image.start.size();
        image.offset = start + std::max(needed, static_cast<transputer::Word>(length) + bytes_beside);
        image.offset = (image.offset + 3) / 4 * 4;
        image.start =
            transputer::assemble(loader_source(code, options, image.offset, image.offset - above, is_there)).bytes;
    }
    image.end = image.offset + code.end;
    image.workspace = image.offset - above;
    image.bytes = image.offset + (code.bytes.size() + 3) / 4 * 4 + code.vector_space_bytes;
    return image;
}

} // namespace

std::uint32_t where_code_is(const Code& code, const CodeOptions& options) {
    return laid_out(code, options, false).offset;
}

transputer::Image image_of(const Code& code, const CodeOptions& options) { return laid_out(code, options, true); }

std::vector<std::uint8_t> bootable(const Code& code, const CodeOptions& options) {
    const transputer::Image image = laid_out(code, options, false);
    std::vector<std::uint8_t> packet = image.start;
    packet.insert(packet.begin(), static_cast<std::uint8_t>(packet.size()));
    packet.insert(packet.end(), image.code.begin(), image.code.end());
    return packet;
}

} // namespace placedpar::occam
