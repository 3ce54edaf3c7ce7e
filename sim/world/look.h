// The appearance of objects in camera images.
#pragma once

#include <optional>
#include <string>

namespace frob::sim {

// Red, green and blue, each from 0 to 1.
struct Tint {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

constexpr Tint operator*(double k, Tint t) { return {k * t.red, k * t.green, k * t.blue}; }

enum class Texture { plain, plaster, bricks, stripes, checks };

struct Look {
    Tint tint;
    Texture texture = Texture::plain;
    double height = 0.0; // m, from the floor to the top
};

// Parses a colour name or "#rrggbb"; returns no value if it is neither.
std::optional<Tint> tint_of(const std::string &text);

// The names of all colours and all textures, for messages.
std::string tint_names();
std::optional<Texture> texture_of(const std::string &name);
std::string texture_names();

} // namespace frob::sim
