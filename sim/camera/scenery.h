// Draws the world as a camera sees it: walls, solids and boxes with their heights, balls, cones,
// posters, other robots, the floor with everything on it, and the sky.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "chassis.h"
#include "raster.h"
#include "scene.h"

namespace frob::sim {

// Positions of all moving things at the time of a frame.
struct Moment {
    std::vector<Pose> robots;
    std::vector<Pose> boxes;
    std::vector<Vec> balls;
};

// Interpolates between two moments. Returns a if `share` is 0, and b if it is 1.
Moment between(const Moment &a, const Moment &b, double share);

class Scenery {
  public:
    // The scene and the chassis must outlive the scenery.
    Scenery(const Scene &scene, const Chassis &chassis);

    // Draws the view of robot number `robot`, which does not see itself.
    void draw(Raster &raster, const Moment &moment, std::size_t robot) const;

  private:
    // A flat side of an object. Its pattern starts at the world's origin, so that it continues from
    // one side of a wall to the next.
    struct Side {
        std::vector<Point> corners; // counter-clockwise as seen from outside
        Point normal;
        Chart chart;
        Finish finish;
        Thing thing; // the object it belongs to
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

    // The look of a floor area with this reflectance: the given tint or, if there is none, the
    // floor's tint scaled by the reflectance.
    Look floor_look(double reflectance, const std::optional<Tint> &tint) const;

    const Scene &scene_;
    const Chassis &chassis_;
    Look robot_;
    std::vector<Shine> lamps_;
    std::vector<Side> fixed_;
    std::vector<Side> lying_; // flat on the floor, topmost first
};

} // namespace frob::sim
