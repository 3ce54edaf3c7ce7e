#include "ray_fan.h"

#include <algorithm>
#include <cmath>

namespace frob::sim {
namespace {

// Box2D computes with floats, so objects are skipped only if they miss the ray by more than this
// margin.
constexpr double slack = 0.01; // m

b2Vec2 to_b2(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }
Vec from_b2(b2Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

} // namespace

class RayFan::Gather : public b2QueryCallback {
  public:
    Gather(RayFan &fan, const b2Body &self) : fan_(fan), self_(self) {}

    bool ReportFixture(b2Fixture *fixture) override {
        if (fixture->GetBody() == &self_) return true;
        const b2AABB &box = fixture->GetAABB(0);
        fan_.obstacles_.push_back({fixture, from_b2(box.GetCenter()) - fan_.origin_,
                                   length(from_b2(box.GetExtents())) + slack});
        return true;
    }

  private:
    RayFan &fan_;
    const b2Body &self_;
};

RayFan::RayFan(const Body &body, Vec origin, double heading, double half_angle, double reach)
    : origin_(origin) {
    // The sector is within the triangle whose far side touches the sector's arc.
    const double side = reach / std::cos(half_angle);
    const Vec left = origin + side * direction(heading + half_angle);
    const Vec right = origin + side * direction(heading - half_angle);
    const Vec margin = {slack, slack};
    b2AABB box;
    box.lowerBound = to_b2(
        Vec{std::min({origin.x, left.x, right.x}), std::min({origin.y, left.y, right.y})} - margin);
    box.upperBound = to_b2(
        Vec{std::max({origin.x, left.x, right.x}), std::max({origin.y, left.y, right.y})} + margin);
    Gather gather(*this, body.rigid());
    body.rigid().GetWorld()->QueryAABB(&gather, box);
}

std::optional<double> RayFan::ray(double angle, double reach) const {
    const Vec along = direction(angle);
    b2RayCastInput input;
    input.p1 = to_b2(origin_);
    input.p2 = to_b2(origin_ + reach * along);
    input.maxFraction = 1.0f;
    bool met = false;
    double within = reach;
    for (const Obstacle &o : obstacles_) {
        const double ahead = dot(o.center, along);
        if (ahead + o.radius < 0.0 || ahead - o.radius > within ||
            std::abs(cross(along, o.center)) > o.radius)
            continue;
        b2RayCastOutput hit;
        if (!o.fixture->RayCast(&hit, input, 0)) continue;
        met = true;
        input.maxFraction = hit.fraction;
        within = reach * static_cast<double>(hit.fraction);
    }
    if (!met) return std::nullopt;
    return within;
}

} // namespace frob::sim
