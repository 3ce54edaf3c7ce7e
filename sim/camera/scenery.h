// The world as a camera sees it: walls, solids and boxes as high as they are, balls, cones,
// posters, other robots, the floor with what lies on it, and the sky.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "chassis.h"
#include "raster.h"
#include "scene.h"

namespace frob::sim
{

// Where things that move are, at the time of a frame.
struct Moment {
    std::vector<Pose> robots;
    std::vector<Pose> boxes;
    std::vector<Vec> balls;
};

// Between two of them, at a share of the way from a to b.
Moment between(const Moment &a, const Moment &b, double share);

class Scenery
{
  public:
    // Both must stay.
    Scenery(const Scene &scene, const Chassis &chassis);

    // What robot number `robot`, which does not see itself, sees.
    void draw(Raster &raster, const Moment &moment, std::size_t robot) const;

  private:
    // A flat side of something. Its pattern begins at the world's origin, so that it goes on from
    // side to side of a wall.
    struct Side {
        std::vector<Point> corners; // counter-clockwise, as it is seen
        Point normal;
        Chart chart;
        Finish finish;
        Thing thing; // whose side it is
    };

    static void draw(Raster &raster, const Side &side, bool lies_below);
    static void add_side(std::vector<Side> &sides, std::vector<Point> corners, const Look &look,
                         Thing thing);
    static void add_prism(std::vector<Side> &sides, const std::vector<Vec> &outline,
                          const Look &look, Thing thing);
    static void add_cone(std::vector<Side> &sides, const Cone &cone, Thing thing);
    void add_polygon(const Polygon &polygon, Thing thing);
    void add_wall(const Wall &wall, Thing thing);
    void add_tape(const Tape &tape, Thing thing);
    void draw_poster(Raster &raster, const Poster &poster) const;
    void draw_moving(Raster &raster, const Moment &moment, std::size_t robot) const;

    // Of a floor of its tint and pattern, where it gives back this share of the light.
    Look floor_look(double reflectance, const std::optional<Tint> &tint) const;

    const Scene &scene_;
    const Chassis &chassis_;
    Look robot_;
    std::vector<Shine> lamps_;
    std::vector<Side> fixed_;
    std::vector<Side> lying_; // on the floor, what lies on top first
};

} // namespace frob::sim
