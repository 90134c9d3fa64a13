#pragma once

#include <string>
#include <string_view>

namespace placedpar {

/// Names the parts of the output that a terminal shows in colour. The parts up to `caret` go to standard error, the
/// others to standard output.
enum class Paint { error, warning, note, place, caret, heading, success, failure };

enum class PaintedStream { errors, output };

/// Turns the colours of a stream on or off; they are off until the first call. Only the main program calls this
/// function, once at its start.
void set_painted(PaintedStream, bool painted);

/// If the stream of this part is painted, returns the text between marks that stand for the colour. Otherwise returns
/// the text alone. Final newlines, and blanks at the start, stay outside the marks. Only escaped_but_paint() turns
/// marks into colours, so text from outside cannot set colours.
std::string painted(Paint, std::string_view text);

/// Returns the text as escaped() does, but keeps newlines and turns the marks of painted() into colours. The result is
/// safe for a terminal.
std::string escaped_but_paint(std::string_view text);

/// Returns the text without the marks of painted(). Use it for a text that is stored or sent elsewhere.
std::string unpainted(std::string_view text);

} // namespace placedpar
