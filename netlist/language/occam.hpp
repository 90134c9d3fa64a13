#pragma once

#include "text/source.hpp"

#include <memory>
#include <optional>

namespace placedpar {

/// The first line of a text that is occam, where one is: PLACED PAR, PROCESSOR 0 T8, #USE, the sections of the occam
/// toolset's configurations. REQUIRES for a sure answer: the text is no netlist that can be read.
std::optional<Location> occam_in(const std::shared_ptr<const SourceFile>& file);

} // namespace placedpar
