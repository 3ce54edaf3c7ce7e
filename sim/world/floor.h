// The reflectance and the holes of the floor, as seen by downward-facing sensors.
#pragma once

#include <vector>

#include "scene.h"

namespace frob::sim {

class Floor {
  public:
    explicit Floor(const Scene &scene);

    // Whether the floor has holes at all, and whether it has one at this place.
    bool has_holes() const { return !holes_.empty(); }
    bool ends(Vec place) const;

    // The fraction of light that a spot of width `spot` around a place reflects; 0 for a hole. If
    // the spot is on an edge, the result is between the reflectances of the two sides: the spot is
    // treated as a square that is aligned with the edge, and each side is weighted by its share of
    // the square.
    double reflectance(Vec place, double spot) const;

  private:
    // An area or a stripe on the floor, with its bounding box.
    struct Layer {
        std::vector<Vec> points;
        bool outlined; // whether `points` outline an area; if not, they are the centre line of a
                       // stripe
        bool closed;   // for stripes
        double width;  // for stripes
        double reflectance;
        Vec low, high;
    };

    static Layer area(const std::vector<Vec> &points, double reflectance);
    static Layer stripe(const Tape &tape);

    double reflectance_;
    std::vector<Layer> layers_; // from bottom to top
    std::vector<Hole> holes_;
};

} // namespace frob::sim
