// Main program of the fuzz tests: libFuzzer calls the chosen reader with one input after another. PLACEDPAR_READER
// names the reader; without it the program prints the readers' names, for tests/fuzz/run.py.

#include "tests/fuzz/reader.hpp"
#include "text/user_error.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace {

const placedpar::fuzz::Reader* chosen = nullptr;

} // namespace

void placedpar::fuzz::require(bool holds, const char* claim) {
    if (!holds)
        throw std::logic_error(claim);
}

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    const char* name = std::getenv("PLACEDPAR_READER");
    for (const placedpar::fuzz::Reader& reader : placedpar::fuzz::readers())
        if (!name)
            std::puts(reader.name);
        else if (std::string_view(name) == reader.name)
            chosen = &reader;
    if (!chosen)
        std::exit(name ? 1 : 0);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        chosen->read(std::string(reinterpret_cast<const char*>(data), size));
    } catch (const placedpar::UserError&) { // the reader refused the input
    }
    return 0;
}
