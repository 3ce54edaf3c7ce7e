#include "bumpers.h"

#include "p3dx.h"

namespace frob::sim {

// A contact before the middle of the body presses the front bumper, one behind
// it the rear bumper.
void Bumpers::advance(const World &world) {
    front_ = rear_ = false;
    bool against_fixed = false;
    const b2Body &robot = world.robot();
    for (const b2ContactEdge *edge = robot.GetContactList(); edge != nullptr; edge = edge->next) {
        const b2Contact &contact = *edge->contact;
        if (!contact.IsTouching()) continue;
        if (is_fixed(*edge->other)) against_fixed = true;
        b2WorldManifold manifold;
        contact.GetWorldManifold(&manifold);
        for (int i = 0; i < contact.GetManifold()->pointCount; ++i) {
            const b2Vec2 at = robot.GetLocalPoint(manifold.points[i]);
            (static_cast<double>(at.x) > p3dx::body_center ? front_ : rear_) = true;
        }
    }
    if (against_fixed && free_ns_ >= apart_ns) ++collisions_;
    free_ns_ = against_fixed ? 0 : free_ns_ + step_ns;
}

} // namespace frob::sim
