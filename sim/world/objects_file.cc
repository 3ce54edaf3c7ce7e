#include "objects_file.h"

#include <cstdio>
#include <stdexcept>

#include "bends.h"
#include "triangulate.h"

namespace frob::sim {
namespace {

std::optional<Tint> read_optional_tint(TomlReader &reader) {
    const Tint none = {-1.0, 0.0, 0.0};
    const Tint tint = read_tint(reader, "colour", none);
    return tint.red < 0.0 ? std::nullopt : std::optional(tint);
}

// Reads how an object looks to cameras.
Look read_look(TomlReader &reader, Look look) {
    look.tint = read_tint(reader, "colour", look.tint);
    look.texture = read_texture(reader, look.texture);
    look.height = reader.number("height", look.height, Range::size);
    return look;
}

void read_place(TomlReader &reader, Poster &poster) {
    poster.pose.position = reader.needed_point("center", Range::any);
    poster.pose.heading = radians(reader.needed_number("facing_deg", Range::any));
    poster.middle = reader.number("middle", poster.middle, Range::any);
}

} // namespace

std::string shown(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

Tint read_tint(TomlReader &reader, const char *key, Tint otherwise) {
    const std::string text = reader.string(key);
    if (text.empty()) return otherwise;
    if (const std::optional<Tint> tint = tint_of(text)) return *tint;
    reader.mistake_at(key, "there is no colour `" + text + "`; the colours are " + tint_names() +
                               ", and `#rrggbb`");
    return otherwise;
}

Texture read_texture(TomlReader &reader, Texture otherwise) {
    const std::string name = reader.string("texture");
    if (name.empty()) return otherwise;
    if (const std::optional<Texture> texture = texture_of(name)) return *texture;
    reader.mistake_at("texture",
                      "there is no texture `" + name + "`; the textures are " + texture_names());
    return otherwise;
}

Wall read_wall(TomlReader reader) {
    Wall wall;
    wall.closed = reader.boolean("closed", wall.closed);
    wall.points = reader.needed_points("points", wall.closed ? 3 : 2, wall.closed);
    wall.thickness = reader.number("thickness", wall.thickness, Range::size);
    wall.look = read_look(reader, wall.look);
    wall.place = reader.place();
    reader.finish();
    return wall;
}

Polygon read_polygon(TomlReader reader) {
    Polygon polygon;
    polygon.points = reader.needed_points("points", 3, true);
    if (!polygon.points.empty()) {
        if (!is_simple(polygon.points))
            reader.mistake_at("points", "the edges of this polygon cross or touch");
        else if (signed_area(polygon.points) < 0.0)
            polygon.points = {polygon.points.rbegin(), polygon.points.rend()};
    }
    polygon.look = read_look(reader, polygon.look);
    polygon.place = reader.place();
    reader.finish();
    return polygon;
}

Circle read_circle(TomlReader reader) {
    Circle circle;
    circle.center = reader.needed_point("center", Range::any);
    circle.radius = reader.needed_number("radius", Range::size);
    circle.look = read_look(reader, circle.look);
    circle.place = reader.place();
    reader.finish();
    return circle;
}

Box read_box(TomlReader reader) {
    Box box;
    box.pose.position = reader.needed_point("center", Range::any);
    box.pose.heading = radians(reader.number("angle_deg", 0.0, Range::any));
    box.size = reader.needed_point("size", Range::size);
    box.mass = reader.number("mass", box.mass, Range::positive);
    box.friction = reader.number("friction", box.friction, Range::not_negative);
    box.look = read_look(reader, box.look);
    box.place = reader.place();
    reader.finish();
    return box;
}

Ball read_ball(TomlReader reader, bool has_way) {
    Ball ball;
    if (has_way) {
        ball.closed = reader.boolean("closed", ball.closed);
        ball.way = reader.needed_points("way", ball.closed ? 3 : 2, ball.closed);
        ball.speed = reader.needed_number("speed", Range::positive);
    } else {
        ball.way = {reader.needed_point("center", Range::any)};
    }
    ball.radius = reader.number("radius", ball.radius, Range::size);
    ball.mass = reader.number("mass", ball.mass, Range::positive);
    ball.tint = read_tint(reader, "colour", ball.tint);
    ball.place = reader.place();
    reader.finish();
    return ball;
}

Cone read_cone(TomlReader reader) {
    Cone cone;
    cone.center = reader.needed_point("center", Range::any);
    cone.radius = reader.number("radius", cone.radius, Range::size);
    cone.look = read_look(reader, cone.look);
    cone.place = reader.place();
    reader.finish();
    return cone;
}

Poster read_poster(TomlReader reader, const std::string &folder) {
    Poster poster;
    read_place(reader, poster);
    poster.size = reader.needed_point("size", Range::size);
    const std::string picture = reader.needed_string("picture");
    try {
        if (!picture.empty())
            poster.print = Print::of_file(picture[0] == '/' ? picture : folder + picture);
    } catch (const std::runtime_error &error) {
        reader.mistake_at("picture", picture + ": " + error.what());
    }
    reader.finish();
    return poster;
}

// `size` is the width of the black frame, which is eight cells wide; the whole tag is ten cells
// wide.
Poster read_tag(TomlReader reader) {
    Poster tag;
    read_place(reader, tag);
    const double size = 10.0 / 8.0 * reader.needed_number("size", Range::size);
    tag.size = {size, size};
    tag.print = Print::tag(reader.integer("id", 0, 0, Print::tags - 1));
    reader.finish();
    return tag;
}

Hole read_hole(TomlReader reader) {
    Hole hole;
    hole.points = reader.needed_points("points", 3, true);
    if (!hole.points.empty() && !is_simple(hole.points))
        reader.mistake_at("points", "the edges of this hole cross or touch");
    reader.finish();
    return hole;
}

Tape read_tape(TomlReader reader) {
    Tape tape;
    tape.closed = reader.boolean("closed", tape.closed);
    tape.points = reader.needed_points("points", tape.closed ? 3 : 2, tape.closed);
    tape.width = reader.number("width", tape.width, Range::size);
    tape.reflectance = reader.number("reflectance", tape.reflectance, Range::part);
    tape.tint = read_optional_tint(reader);
    const double radius = reader.number("radius", 0.0, Range::not_negative);
    if (!tape.points.empty() && radius > 0.0) {
        if (const std::optional<Vec> corner = corner_without_room(tape.points, tape.closed, radius))
            reader.mistake_at("radius",
                              "there is no room for a bend of this radius at the corner [" +
                                  shown(corner->x) + ", " + shown(corner->y) + "]");
        else
            tape.points = with_bends(tape.points, tape.closed, radius);
    }
    reader.finish();
    return tape;
}

Patch read_patch(TomlReader reader) {
    Patch patch;
    patch.points = reader.needed_points("points", 3, true);
    if (!patch.points.empty() && !is_simple(patch.points))
        reader.mistake_at("points", "the edges of this patch cross or touch");
    patch.reflectance = reader.number("reflectance", patch.reflectance, Range::part);
    patch.tint = read_optional_tint(reader);
    reader.finish();
    return patch;
}

Lamp read_lamp(TomlReader reader) {
    Lamp lamp;
    lamp.position = reader.needed_point("position", Range::any);
    lamp.height = reader.number("height", lamp.height, Range::size);
    lamp.intensity = reader.number("intensity", lamp.intensity, Range::positive);
    reader.finish();
    return lamp;
}

Magnet read_magnet(TomlReader reader) {
    Magnet magnet;
    magnet.position = reader.needed_point("position", Range::any);
    magnet.strength = reader.needed_number("strength", Range::any);
    reader.finish();
    return magnet;
}

} // namespace frob::sim
