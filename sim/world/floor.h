// The floor as sensors that look down see it: how bright it is, and where it ends.
#pragma once

#include <vector>

#include "scene.h"

namespace frob::sim
{

class Floor
{
  public:
    explicit Floor(const Scene &scene);

    // Whether there is a hole somewhere, and at this place.
    bool has_holes() const { return !holes_.empty(); }
    bool ends(Vec place) const;

    // The share of light that comes back from a spot of this width round a
    // place: 0 from a hole. Where the spot lies on an edge it is between the
    // reflectances of the two sides: the spot is a square that lies along the
    // edge, and the share of it beyond the edge counts.
    double reflectance(Vec place, double spot) const;

  private:
    // What a point can be on or off: a distance from its middle line or its
    // edge, and the rectangle round it.
    struct Layer {
        std::vector<Vec> points;
        bool outlined; // an area with this outline; otherwise a stripe along the points
        bool closed;   // of a stripe
        double width;  // of a stripe
        double reflectance;
        Vec low, high;
    };

    static Layer area(const std::vector<Vec> &points, double reflectance);
    static Layer stripe(const Tape &tape);

    double reflectance_;
    std::vector<Layer> layers_; // from below
    std::vector<Hole> holes_;
};

} // namespace frob::sim
