#include "scenery.h"

#include <algorithm>

#include "triangulate.h"

namespace frob::sim {
namespace {

constexpr int round = 24;        // sides of the polygons that approximate circles
constexpr double lifted = 0.004; // m: gap between a poster and its wall

std::vector<Vec> ring(Vec middle, double radius) {
    std::vector<Vec> outline;
    for (int k = 0; k < round; ++k)
        outline.push_back(middle + radius * exact_direction(2.0 * pi * k / round));
    return outline;
}

Vec placed(const Pose &pose, Vec point) {
    const Vec u = exact_direction(pose.heading);
    return pose.position + Vec{u.x * point.x - u.y * point.y, u.y * point.x + u.x * point.y};
}

std::vector<Vec> rectangle(const Pose &pose, Vec size) {
    const Vec h = 0.5 * size;
    return {placed(pose, {-h.x, -h.y}), placed(pose, {h.x, -h.y}), placed(pose, {h.x, h.y}),
            placed(pose, {-h.x, h.y})};
}

std::vector<Point> raised(const std::vector<Vec> &outline, double z) {
    std::vector<Point> corners;
    for (const Vec &p : outline) corners.push_back(at_height(p, z));
    return corners;
}

} // namespace

Moment between(const Moment &a, const Moment &b, double share) {
    const auto mix = [&](Vec from, Vec to) { return from + share * (to - from); };
    const auto mix_poses = [&](const std::vector<Pose> &from, const std::vector<Pose> &to) {
        std::vector<Pose> poses;
        for (std::size_t i = 0; i < from.size(); ++i) {
            const double turn = to[i].heading - from[i].heading;
            const double shorter = turn - 2.0 * pi * std::floor(turn / (2.0 * pi) + 0.5);
            poses.push_back(
                {mix(from[i].position, to[i].position), from[i].heading + share * shorter});
        }
        return poses;
    };
    Moment moment{mix_poses(a.robots, b.robots), mix_poses(a.boxes, b.boxes), {}};
    for (std::size_t i = 0; i < a.balls.size(); ++i)
        moment.balls.push_back(mix(a.balls[i], b.balls[i]));
    return moment;
}

void Scenery::add_side(std::vector<Side> &sides, std::vector<Point> corners, const Look &look,
                       Thing thing) {
    const Point normal = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const Point along = unit(corners[1] - corners[0]), across = cross(normal, along);
    sides.push_back({std::move(corners),
                     normal,
                     {{}, along, across},
                     {light_on(normal) * look.tint, look.texture},
                     thing});
}

void Scenery::add_prism(std::vector<Side> &sides, const std::vector<Vec> &outline, const Look &look,
                        Thing thing) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec a = outline[i], b = outline[(i + 1) % outline.size()];
        add_side(sides,
                 {at_height(a, 0.0), at_height(b, 0.0), at_height(b, look.height),
                  at_height(a, look.height)},
                 look, thing);
    }
    add_side(sides, raised(outline, look.height), look, thing);
}

void Scenery::add_cone(std::vector<Side> &sides, const Cone &cone, Thing thing) {
    const std::vector<Vec> foot = ring(cone.center, cone.radius);
    const Point tip = at_height(cone.center, cone.look.height);
    for (std::size_t i = 0; i < foot.size(); ++i)
        add_side(sides, {at_height(foot[i], 0.0), at_height(foot[(i + 1) % foot.size()], 0.0), tip},
                 cone.look, thing);
    // Makes the stripes run around the cone.
    for (std::size_t i = sides.size() - foot.size(); i < sides.size(); ++i)
        sides[i].chart.across = {0.0, 0.0, 1.0};
}

void Scenery::add_wall(const Wall &wall, Thing thing) {
    const std::size_t n = wall.points.size();
    for (const Vec &point : wall.points)
        add_prism(fixed_, ring(point, wall.thickness / 2), wall.look, thing);
    for (std::size_t i = 0; i + (wall.closed ? 0 : 1) < n; ++i) {
        const Vec a = wall.points[i], b = wall.points[(i + 1) % n];
        const double scale = wall.thickness / 2 / length(b - a);
        const Vec side = {scale * (a.y - b.y), scale * (b.x - a.x)};
        add_prism(fixed_, {a - side, b - side, b + side, a + side}, wall.look, thing);
    }
}

void Scenery::add_polygon(const Polygon &polygon, Thing thing) {
    const double height = polygon.look.height;
    for (const Triangle &t : triangulate(polygon.points))
        add_side(fixed_, raised({t[0], t[1], t[2]}, height), polygon.look, thing);
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
        const Vec a = polygon.points[i], b = polygon.points[(i + 1) % polygon.points.size()];
        add_side(fixed_,
                 {at_height(a, 0.0), at_height(b, 0.0), at_height(b, height), at_height(a, height)},
                 polygon.look, thing);
    }
}

Look Scenery::floor_look(double reflectance, const std::optional<Tint> &tint) const {
    return {tint ? *tint : reflectance * scene_.floor.tint, scene_.floor.texture, 0.0};
}

void Scenery::add_tape(const Tape &tape, Thing thing) {
    const Look look = floor_look(tape.reflectance, tape.tint);
    const std::size_t n = tape.points.size();
    for (std::size_t i = 0; i + (tape.closed ? 0 : 1) < n; ++i) {
        const Vec a = tape.points[i], b = tape.points[(i + 1) % n];
        const double scale = tape.width / 2 / length(b - a);
        const Vec side = {scale * (a.y - b.y), scale * (b.x - a.x)};
        add_side(lying_, raised({a - side, b - side, b + side, a + side}, 0.0), look, thing);
    }
    for (const Vec &point : tape.points)
        add_side(lying_, raised(ring(point, tape.width / 2), 0.0), look, thing);
}

Scenery::Scenery(const Scene &scene, const Chassis &chassis)
    : scene_(scene), chassis_(chassis), robot_{{0.72, 0.16, 0.12}, Texture::plain, chassis.height} {
    using Kind = Thing::Kind;
    if (scene.ambient.white)
        for (const Lamp &lamp : scene.lamps)
            lamps_.push_back(
                {at_height(lamp.position, lamp.height), lamp.intensity / *scene.ambient.white});
    for (std::size_t i = 0; i < scene.walls.size(); ++i) add_wall(scene.walls[i], {Kind::wall, i});
    for (std::size_t i = 0; i < scene.polygons.size(); ++i)
        add_polygon(scene.polygons[i], {Kind::polygon, i});
    for (std::size_t i = 0; i < scene.circles.size(); ++i) {
        const Circle &circle = scene.circles[i];
        add_prism(fixed_, ring(circle.center, circle.radius), circle.look, {Kind::circle, i});
    }
    for (std::size_t i = 0; i < scene.cones.size(); ++i)
        add_cone(fixed_, scene.cones[i], {Kind::cone, i});
    const auto lay = [&](std::vector<Vec> outline, const Look &look, Thing thing) {
        if (signed_area(outline) < 0.0) std::reverse(outline.begin(), outline.end());
        for (const Triangle &t : triangulate(outline))
            add_side(lying_, raised({t[0], t[1], t[2]}, 0.0), look, thing);
    };
    for (std::size_t i = 0; i < scene.holes.size(); ++i)
        lay(scene.holes[i].points, floor_look(0.0, Tint{0.02, 0.02, 0.03}), {Kind::hole, i});
    for (std::size_t i = scene.tapes.size(); i-- > 0;) add_tape(scene.tapes[i], {Kind::tape, i});
    for (std::size_t i = scene.patches.size(); i-- > 0;) {
        const Patch &patch = scene.patches[i];
        lay(patch.points, floor_look(patch.reflectance, patch.tint), {Kind::patch, i});
    }
}

void Scenery::draw(Raster &raster, const Side &side, bool lies_below) {
    // Only sides that face the camera are visible.
    if (dot(side.normal, raster.eye().origin - side.corners[0]) <= 0.0) return;
    raster.of(side.thing);
    raster.polygon(side.corners, side.chart, side.finish, lies_below);
}

void Scenery::draw_moving(Raster &raster, const Moment &moment, std::size_t robot) const {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < moment.boxes.size(); ++i)
        add_prism(sides, rectangle(moment.boxes[i], scene_.boxes[i].size), scene_.boxes[i].look,
                  {Thing::Kind::box, i});
    for (std::size_t k = 0; k < moment.robots.size(); ++k) {
        if (k == robot) continue;
        std::vector<Vec> outline;
        for (const Vec &corner : outline_of(chassis_))
            outline.push_back(placed(moment.robots[k], corner));
        add_prism(sides, outline, robot_, {Thing::Kind::robot, k});
    }
    for (const Side &side : sides) draw(raster, side, false);
    for (std::size_t i = 0; i < moment.balls.size(); ++i) {
        const Ball &ball = scene_.balls[i];
        raster.of({Thing::Kind::ball, i});
        raster.ball(at_height(moment.balls[i], ball.radius), ball.radius, ball.tint);
    }
}

void Scenery::draw_poster(Raster &raster, const Poster &poster) const {
    // A viewer faces the picture, so the viewer's right is to the left of the direction that the
    // picture faces.
    const Point &eye = raster.eye().origin;
    const Vec facing = exact_direction(poster.pose.heading), side = {-facing.y, facing.x};
    const Vec at = poster.pose.position + lifted * facing;
    if (dot(facing, Vec{eye.x, eye.y} - at) <= 0.0) return;
    const Point right = at_height(side, 0.0);
    const Point corner = at_height(at, poster.middle + poster.size.y / 2) -
                         0.5 * poster.size.x * right; // the upper left corner, as seen
    const Point across = poster.size.x * right, down = {0.0, 0.0, -poster.size.y};
    Finish finish;
    finish.print = &poster.print;
    finish.light = light_on(at_height(facing, 0.0));
    finish.width = poster.size.x;
    raster.polygon({corner, corner + down, corner + down + across, corner + across},
                   {corner, (1.0 / poster.size.x) * right, {0.0, 0.0, -1.0 / poster.size.y}},
                   finish);
}

void Scenery::draw(Raster &raster, const Moment &moment, std::size_t robot) const {
    raster.sky(scene_.sky.tint);
    if (scene_.ambient.white) raster.light(scene_.ambient.light / *scene_.ambient.white, lamps_);
    draw_moving(raster, moment, robot);
    for (std::size_t i = 0; i < scene_.posters.size(); ++i) {
        raster.of({Thing::Kind::poster, i});
        draw_poster(raster, scene_.posters[i]);
    }
    for (const Side &side : fixed_) draw(raster, side, false);
    for (const Side &side : lying_) draw(raster, side, true);
    raster.of({Thing::Kind::floor, 0});
    raster.floor({light_on({0.0, 0.0, 1.0}) * (scene_.floor.reflectance * scene_.floor.tint),
                  scene_.floor.texture});
}

} // namespace frob::sim
