// What to say of a text that is no TOML, to someone who writes a world.
#pragma once

#include <string>
#include <string_view>

namespace frob::sim
{

// A sentence for the mistake at a line and column (from 1, as TOML's parser counts
// them): what stands there and what to write instead, where it is one that people
// make; else what the parser says of it (`description`).
std::string syntax_mistake(std::string_view text, std::size_t line, std::size_t column,
                           std::string_view description);

} // namespace frob::sim
