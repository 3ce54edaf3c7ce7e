// Explains TOML syntax errors to people who write worlds.
#pragma once

#include <string>
#include <string_view>

namespace frob::sim {

// Returns a message for the error at this line and column (from 1, as the TOML parser counts them).
// For common mistakes, the message says what was found and what to write instead. For others, it
// repeats the parser's `description`.
std::string syntax_mistake(std::string_view text, std::size_t line, std::size_t column,
                           std::string_view description);

} // namespace frob::sim
