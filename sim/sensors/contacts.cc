#include "contacts.h"

namespace frob::sim
{
namespace
{

// What should not be run into. Boxes may be pushed.
bool is_obstacle(b2Body &body)
{
    return body.GetType() == b2_staticBody || is_robot(body);
}

} // namespace

void Contacts::advance(const Body &body)
{
    points_.clear();
    bool against_something = false;
    const b2Body &robot = body.rigid();
    for (const b2ContactEdge *edge = robot.GetContactList(); edge != nullptr; edge = edge->next) {
        const b2Contact &contact = *edge->contact;
        if (!contact.IsTouching())
            continue;
        if (is_obstacle(*edge->other))
            against_something = true;
        b2WorldManifold manifold;
        contact.GetWorldManifold(&manifold);
        for (int i = 0; i < contact.GetManifold()->pointCount; ++i) {
            const b2Vec2 at = robot.GetLocalPoint(manifold.points[i]);
            points_.push_back({ static_cast<double>(at.x), static_cast<double>(at.y) });
        }
    }
    if (against_something && free_ns_ >= apart_ns)
        ++collisions_;
    free_ns_ = against_something ? 0 : free_ns_ + step_ns;
}

} // namespace frob::sim
