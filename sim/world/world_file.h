// World files: TOML to a Scene. The format is described in README.md.
#pragma once

#include <stdexcept>
#include <string>

#include "scene.h"

namespace frob::sim
{

// A world that cannot be used. `what()` is one line for each mistake, each
// `FILE:LINE:COLUMN: message`, in the file's order.
class WorldFileError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

// Reads the file. Throws WorldFileError with every mistake that was found.
Scene read_world_file(const std::string &path);

// The same for a text; `path` is for messages.
Scene parse_world(const std::string &text, const std::string &path);

} // namespace frob::sim
