#pragma once

#include <string>
#include <string_view>

namespace placedpar {

/// What is coloured where a terminal shows it. Those of the first line go to standard error, those of the second to
/// standard output.
enum class Paint { error, warning, note, place, caret, heading, success, failure };

enum class PaintedStream { errors, output };

/// Turns colours on the stream on or off; at first they are off. Only the program calls this, once at its start: a
/// test, or a program that uses a room, gets plain text.
void set_painted(PaintedStream, bool painted);

/// Returns the text between marks of the colour if its stream is painted, otherwise the text alone. Newlines, and
/// blanks at the start, stay outside. Only escaped_but_paint() turns marks into colours, so that text from outside
/// cannot contain any.
std::string painted(Paint, std::string_view text);

/// escaped(), but for ends of lines and the colours that painted() has put around texts: as terminals may have what is
/// printed.
std::string escaped_but_paint(std::string_view text);

/// Without the marks of painted(): for what is kept, or sent elsewhere, before it is printed.
std::string unpainted(std::string_view text);

} // namespace placedpar
