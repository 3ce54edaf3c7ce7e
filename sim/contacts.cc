#include "contacts.h"

namespace frob::sim {

void Contacts::advance(const World &world) {
    points_.clear();
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
            points_.push_back({static_cast<double>(at.x), static_cast<double>(at.y)});
        }
    }
    if (against_fixed && free_ns_ >= apart_ns) ++collisions_;
    free_ns_ = against_fixed ? 0 : free_ns_ + step_ns;
}

} // namespace frob::sim
