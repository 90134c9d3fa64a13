#pragma once
#include "runtime/transputer/model.hpp"
namespace placedpar::transputer {
struct SingleLength {
    Word a, b, c, workspace;
    unsigned unpacksn() { return 0; }
    unsigned roundsn() { return 0; }
    unsigned postnormsn() { return 0; }
};
} // namespace placedpar::transputer
