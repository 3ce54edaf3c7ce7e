#include "body.h"

namespace frob::sim {
namespace {

b2Vec2 to_b2(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

class NearestHit : public b2RayCastCallback {
  public:
    explicit NearestHit(const b2Body *ignored) : ignored_(ignored) {}

    float ReportFixture(b2Fixture *fixture, const b2Vec2 &, const b2Vec2 &, float share) override {
        if (fixture->GetBody() == ignored_) return -1.0f;
        nearest = share;
        return share; // from now on, Box2D reports only nearer objects
    }

    std::optional<float> nearest;

  private:
    const b2Body *ignored_;
};

// Checks whether a nearby fixture overlaps this body, which itself has only one fixture.
class Overlap : public b2QueryCallback {
  public:
    explicit Overlap(const b2Body &body) : body_(body) {}

    bool ReportFixture(b2Fixture *fixture) override {
        found = fixture->GetBody() != &body_ &&
                b2TestOverlap(fixture->GetShape(), 0, body_.GetFixtureList()->GetShape(), 0,
                              fixture->GetBody()->GetTransform(), body_.GetTransform());
        return !found;
    }

    bool found = false;

  private:
    const b2Body &body_;
};

} // namespace

Pose Body::pose() const {
    const b2Vec2 at = rigid_->GetPosition();
    return {{static_cast<double>(at.x), static_cast<double>(at.y)},
            wrap_angle(static_cast<double>(rigid_->GetAngle()))};
}

std::optional<double> Body::ray(Vec origin, double angle, double reach) const {
    NearestHit hit(rigid_);
    rigid_->GetWorld()->RayCast(&hit, to_b2(origin), to_b2(origin + reach * direction(angle)));
    if (!hit.nearest) return std::nullopt;
    return reach * static_cast<double>(*hit.nearest);
}

bool Body::overlaps() const {
    Overlap overlap(*rigid_);
    rigid_->GetWorld()->QueryAABB(&overlap, rigid_->GetFixtureList()->GetAABB(0));
    return overlap.found;
}

} // namespace frob::sim
