// Reads the tables of a world file for the things in the world: walls and other objects, posters,
// lamps, magnets, and marks on the floor. Each function reports the mistakes in its table.
#pragma once

#include <string>

#include "scene.h"
#include "toml_reader.h"

namespace frob::sim {

// The number as messages show it, with at most six digits.
std::string shown(double x);

// The colour or texture that the table names, or `otherwise` if it names none.
Tint read_tint(TomlReader &reader, const char *key, Tint otherwise);
Texture read_texture(TomlReader &reader, Texture otherwise);

Wall read_wall(TomlReader reader);
Polygon read_polygon(TomlReader reader);
Circle read_circle(TomlReader reader);
Box read_box(TomlReader reader);

// Reads a ball that lies still or, with `has_way`, rolls along a path.
Ball read_ball(TomlReader reader, bool has_way);

Cone read_cone(TomlReader reader);

// Pictures with a relative path are in `folder`.
Poster read_poster(TomlReader reader, const std::string &folder);
Poster read_tag(TomlReader reader);

Hole read_hole(TomlReader reader);
Tape read_tape(TomlReader reader);
Patch read_patch(TomlReader reader);
Lamp read_lamp(TomlReader reader);
Magnet read_magnet(TomlReader reader);

} // namespace frob::sim
