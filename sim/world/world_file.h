// Reads world files: TOML, converted to a Scene. README.md describes the format.
#pragma once

#include <stdexcept>
#include <string>

#include "scene.h"

namespace frob::sim {

// Thrown for an unusable world file. `what()` has one line for each mistake, `FILE:LINE:COLUMN:
// message`, in file order.
class WorldFileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Reads a world file. Throws a WorldFileError that lists all mistakes found.
Scene read_world_file(const std::string &path);

// Parses the text of a world file and throws like read_world_file. Messages refer to the file as
// `path`, and relative paths of pictures are relative to the folder of `path`.
Scene parse_world(const std::string &text, const std::string &path);

} // namespace frob::sim
