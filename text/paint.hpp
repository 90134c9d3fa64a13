#pragma once

#include <string>
#include <string_view>

namespace placedpar {

/// Names the parts of the program's text that a terminal shows in colour. The parts up to `caret` are for standard
/// error, the later parts for standard output.
enum class Paint { error, warning, note, place, caret, heading, success, failure };

enum class PaintedStream { errors, output };

/// Turns the colours of a stream on or off. Before the first call they are off. REQUIRES: called only by the main
/// program, before it prints.
void set_painted(PaintedStream, bool painted);

/// Returns the text between two marks, which escaped_but_paint() later turns into the colour of the part. Returns the
/// text alone if the colours of the part's stream are off. Final newlines, and blanks at the start, stay outside the
/// marks. Text from users cannot contain marks, since they are random, and so cannot set colours.
std::string painted(Paint, std::string_view text);

/// Returns the text in a form that is safe for a terminal: control characters are written as escapes such as `\x1b`.
/// Newlines and tabs stay, and the marks of painted() become colours.
std::string escaped_but_paint(std::string_view text);

/// Returns the text without the marks of painted(), for a text that is stored or sent, and not printed.
std::string unpainted(std::string_view text);

} // namespace placedpar
