// Reads world files: TOML, converted to a Scene. README.md describes the format.
#pragma once

#include <stdexcept>
#include <string>

#include "scene.h"

namespace frob::sim {

// An unusable world file. `what()` has one line for each mistake, `FILE:LINE:COLUMN: message`, in
// the order of the file.
class WorldFileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Reads the file. Throws WorldFileError with all mistakes found.
Scene read_world_file(const std::string &path);

// Does the same for a text. `path` is the name for messages.
Scene parse_world(const std::string &text, const std::string &path);

} // namespace frob::sim
