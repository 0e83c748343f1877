// What the program says: results on stdout, all else on stderr, where a terminal may show one line
// that changes.
#pragma once

#include <string>
#include <string_view>

namespace retiarius::program {

// Writes text to stdout as it is.
void print(std::string_view text);

// Hands what was printed to the operating system. Throws RunError when it could not be written: a
// full disk behind a redirection must not look like success.
void flush_output();

// "retiarius: error: ..." and "retiarius: warning: ..." on stderr.
void tell_error(const std::string& text);
void tell_warning(const std::string& text);

// Whether stderr is a terminal on which a line can be rewritten.
bool status_possible();

// Shows the text as the status line, in place of the one before, cut to the terminal's width; an
// empty text removes it. The functions above remove it before they write. Only where
// status_possible().
void show_status(const std::string& text);

}  // namespace retiarius::program
