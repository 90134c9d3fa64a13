#pragma once

#include <string>
#include <string_view>

namespace placedpar {

/// What is coloured where a terminal shows it. Those of the first line go to standard error, those of the second to
/// standard output.
enum class Paint { error, warning, note, place, caret, heading, success, failure };

enum class PaintedStream { errors, output };

/// From now on what goes to the stream is coloured, or is not; at first nothing is. Only the program decides it, once
/// at its start: a test, or a program around a room, reads plain text.
void set_painted(PaintedStream, bool painted);

/// The text with marks of the colour around it, for as long as its stream is painted; else the text. Lines' ends and
/// blanks at the start stay outside. Only escaped_but_paint() makes colours of the marks, so that no text from outside,
/// whatever it holds, is taken for one.
std::string painted(Paint, std::string_view text);

/// escaped(), but for ends of lines and the colours that painted() has put around texts: as terminals may have what is
/// printed.
std::string escaped_but_paint(std::string_view text);

/// Without the marks of painted(): for what is kept, or sent elsewhere, before it is printed.
std::string unpainted(std::string_view text);

} // namespace placedpar
