#include "scenery.h"

#include <algorithm>

#include "triangulate.h"

namespace frob::sim {
namespace {

constexpr int round = 24;        // sides of what is round
constexpr double lifted = 0.004; // m: a poster from its wall

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

void Scenery::add_side(std::vector<Side> &sides, std::vector<Point> corners, const Look &look) {
    const Point normal = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const Point along = unit(corners[1] - corners[0]), across = cross(normal, along);
    sides.push_back({std::move(corners), normal, {{}, along, across},
                     {light_on(normal) * look.tint, look.texture}});
}

void Scenery::add_prism(std::vector<Side> &sides, const std::vector<Vec> &outline,
                        const Look &look) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec a = outline[i], b = outline[(i + 1) % outline.size()];
        add_side(sides,
                 {at_height(a, 0.0), at_height(b, 0.0), at_height(b, look.height),
                  at_height(a, look.height)},
                 look);
    }
    add_side(sides, raised(outline, look.height), look);
}

void Scenery::add_cone(std::vector<Side> &sides, const Cone &cone) {
    const std::vector<Vec> foot = ring(cone.center, cone.radius);
    const Point tip = at_height(cone.center, cone.look.height);
    for (std::size_t i = 0; i < foot.size(); ++i)
        add_side(sides, {at_height(foot[i], 0.0), at_height(foot[(i + 1) % foot.size()], 0.0), tip},
                 cone.look);
    // Its stripes go round it.
    for (std::size_t i = sides.size() - foot.size(); i < sides.size(); ++i)
        sides[i].chart.across = {0.0, 0.0, 1.0};
}

void Scenery::add_wall(const Wall &wall) {
    const std::size_t n = wall.points.size();
    for (const Vec &point : wall.points)
        add_prism(fixed_, ring(point, wall.thickness / 2), wall.look);
    for (std::size_t i = 0; i + (wall.closed ? 0 : 1) < n; ++i) {
        const Vec a = wall.points[i], b = wall.points[(i + 1) % n];
        const double scale = wall.thickness / 2 / length(b - a);
        const Vec side = {scale * (a.y - b.y), scale * (b.x - a.x)};
        add_prism(fixed_, {a - side, b - side, b + side, a + side}, wall.look);
    }
}

Look Scenery::floor_look(double reflectance, const std::optional<Tint> &tint) const {
    return {tint ? *tint : reflectance * scene_.floor.tint, scene_.floor.texture, 0.0};
}

void Scenery::add_tape(const Tape &tape) {
    const Look look = floor_look(tape.reflectance, tape.tint);
    const std::size_t n = tape.points.size();
    for (std::size_t i = 0; i + (tape.closed ? 0 : 1) < n; ++i) {
        const Vec a = tape.points[i], b = tape.points[(i + 1) % n];
        const double scale = tape.width / 2 / length(b - a);
        const Vec side = {scale * (a.y - b.y), scale * (b.x - a.x)};
        add_side(lying_, raised({a - side, b - side, b + side, a + side}, 0.0), look);
    }
    for (const Vec &point : tape.points)
        add_side(lying_, raised(ring(point, tape.width / 2), 0.0), look);
}

Scenery::Scenery(const Scene &scene, const Chassis &chassis)
    : scene_(scene), chassis_(chassis),
      robot_{{0.72, 0.16, 0.12}, Texture::plain, chassis.height} {
    for (const Wall &wall : scene.walls) add_wall(wall);
    for (const Polygon &polygon : scene.polygons) {
        for (const Triangle &t : triangulate(polygon.points))
            add_side(fixed_, raised({t[0], t[1], t[2]}, polygon.look.height), polygon.look);
        for (std::size_t i = 0; i < polygon.points.size(); ++i) {
            const Vec a = polygon.points[i], b = polygon.points[(i + 1) % polygon.points.size()];
            add_side(fixed_,
                     {at_height(a, 0.0), at_height(b, 0.0), at_height(b, polygon.look.height),
                      at_height(a, polygon.look.height)},
                     polygon.look);
        }
    }
    for (const Circle &circle : scene.circles)
        add_prism(fixed_, ring(circle.center, circle.radius), circle.look);
    for (const Cone &cone : scene.cones) add_cone(fixed_, cone);
    const auto lay = [&](const std::vector<Vec> &outline, const Look &look) {
        for (const Triangle &t : triangulate(outline))
            add_side(lying_, raised({t[0], t[1], t[2]}, 0.0), look);
    };
    const auto counter_clockwise = [](std::vector<Vec> outline) {
        if (signed_area(outline) < 0.0) std::reverse(outline.begin(), outline.end());
        return outline;
    };
    for (const Hole &hole : scene.holes)
        lay(counter_clockwise(hole.points), floor_look(0.0, Tint{0.02, 0.02, 0.03}));
    for (auto tape = scene.tapes.rbegin(); tape != scene.tapes.rend(); ++tape) add_tape(*tape);
    for (auto patch = scene.patches.rbegin(); patch != scene.patches.rend(); ++patch)
        lay(counter_clockwise(patch->points), floor_look(patch->reflectance, patch->tint));
}

void Scenery::draw(Raster &raster, const Side &side, bool lies_below) {
    // Only what faces the camera is seen.
    if (dot(side.normal, raster.eye().origin - side.corners[0]) > 0.0)
        raster.polygon(side.corners, side.chart, side.finish, lies_below);
}

void Scenery::draw_moving(Raster &raster, const Moment &moment, std::size_t robot) const {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < moment.boxes.size(); ++i)
        add_prism(sides, rectangle(moment.boxes[i], scene_.boxes[i].size), scene_.boxes[i].look);
    for (std::size_t k = 0; k < moment.robots.size(); ++k) {
        if (k == robot) continue;
        std::vector<Vec> outline;
        for (const Vec &corner : outline_of(chassis_))
            outline.push_back(placed(moment.robots[k], corner));
        add_prism(sides, outline, robot_);
    }
    for (const Side &side : sides) draw(raster, side, false);
    for (std::size_t i = 0; i < moment.balls.size(); ++i) {
        const Ball &ball = scene_.balls[i];
        raster.ball(at_height(moment.balls[i], ball.radius), ball.radius, ball.tint);
    }
}

void Scenery::draw(Raster &raster, const Moment &moment, std::size_t robot) const {
    const Pinhole &eye = raster.eye();
    raster.sky(scene_.sky.tint);
    draw_moving(raster, moment, robot);
    for (const Poster &poster : scene_.posters) {
        // Who looks at it has its right side where it has its left hand.
        const Vec facing = exact_direction(poster.pose.heading), side = {-facing.y, facing.x};
        const Vec at = poster.pose.position + lifted * facing;
        if (dot(facing, Vec{eye.origin.x, eye.origin.y} - at) <= 0.0) continue;
        const Point right = at_height(side, 0.0);
        const Point corner = at_height(at, poster.middle + poster.size.y / 2) -
                             0.5 * poster.size.x * right; // the upper left one, as it is seen
        const Point across = poster.size.x * right, down = {0.0, 0.0, -poster.size.y};
        Finish finish;
        finish.print = &poster.print;
        finish.light = light_on(at_height(facing, 0.0));
        finish.width = poster.size.x;
        raster.polygon({corner, corner + down, corner + down + across, corner + across},
                       {corner, (1.0 / poster.size.x) * right, {0.0, 0.0, -1.0 / poster.size.y}},
                       finish);
    }
    for (const Side &side : fixed_) draw(raster, side, false);
    for (const Side &side : lying_) draw(raster, side, true);
    raster.floor({light_on({0.0, 0.0, 1.0}) * (scene_.floor.reflectance * scene_.floor.tint),
                  scene_.floor.texture});
}

} // namespace frob::sim
