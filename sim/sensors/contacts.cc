#include "contacts.h"

namespace frob::sim {

void Contacts::advance(const Body &body) {
    points_.clear();
    std::optional<Begun> touched;
    const b2Body &robot = body.rigid();
    for (const b2ContactEdge *edge = robot.GetContactList(); edge != nullptr; edge = edge->next) {
        b2Contact &contact = *edge->contact;
        if (!contact.IsTouching()) continue;
        b2WorldManifold manifold;
        contact.GetWorldManifold(&manifold);
        const b2Fixture *const a = contact.GetFixtureA(), *const b = contact.GetFixtureB();
        for (int i = 0; i < contact.GetManifold()->pointCount; ++i) {
            const b2Vec2 where = manifold.points[i], at = robot.GetLocalPoint(where);
            points_.push_back({static_cast<double>(at.x), static_cast<double>(at.y)});
            if (!touched)
                touched = {a->GetBody() == &robot ? b : a,
                           {static_cast<double>(where.x), static_cast<double>(where.y)}};
        }
    }
    begun_.reset();
    if (touched && free_ns_ >= apart_ns) {
        ++collisions_;
        begun_ = touched;
    }
    free_ns_ = touched ? 0 : free_ns_ + step_ns;
}

} // namespace frob::sim
