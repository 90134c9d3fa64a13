#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>

namespace placedpar {

/// Where a text that is occam shows it, and what to say in a netlist instead.
struct Occam {
    Location at;
    const char* hint;
};

/// A text that is occam: a program (PROC, SEQ, #USE), a configuration of the development system (PLACED PAR, PROCESSOR
/// 0 T8) or of the occam toolset (NODE, NETWORK). Nothing but comments that begin with -- and folds are taken for
/// occam, too.
/// REQUIRES for a sure answer: the text is no netlist that can be read.
std::optional<Occam> occam_in(const std::shared_ptr<const SourceFile>& file);

} // namespace placedpar
