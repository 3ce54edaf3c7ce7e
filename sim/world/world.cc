#include "world.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "triangulate.h"

// In each step, Box2D reads the clock dozens of times for a profile that the simulator does not
// use. On systems where reading the clock is slow, this takes a third of the run time.
// The following definitions, which do not read the clock, replace the library's, because they are
// linked first. Box2D's results do not depend on the clock.
b2Timer::b2Timer() {}
void b2Timer::Reset() {}
float b2Timer::GetMilliseconds() const { return 0.0f; }

namespace frob::sim {
namespace {

// Box2D's defaults, which are sufficient for a few bodies that touch each other.
constexpr int velocity_iterations = 8;
constexpr int position_iterations = 3;

constexpr float body_friction = 0.3f; // friction coefficient between the sides of solids
constexpr float gravity = 9.81f;

b2Vec2 to_b2(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

// The fixture's user data is the index of its name, for World::name_of.
void add_fixture(b2Body &body, const b2Shape &shape, float density, std::size_t name) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = body_friction;
    fixture.density = density;
    fixture.userData.pointer = name;
    body.CreateFixture(&fixture);
}

void add_polygon(b2Body &body, const b2Vec2 *points, int count, bool skin, std::size_t name) {
    b2PolygonShape shape;
    shape.Set(points, count);
    // Box2D keeps polygons apart with a skin around each of them. Solids do not get a skin, so that
    // the sonar and the bumper detect them at the same place.
    if (!skin) shape.m_radius = 0.0f;
    add_fixture(body, shape, 0.0f, name);
}

void add_circle(b2Body &body, Vec center, double radius, std::size_t name) {
    b2CircleShape shape;
    shape.m_p = to_b2(center);
    shape.m_radius = static_cast<float>(radius);
    add_fixture(body, shape, 0.0f, name);
}

// Adds a rectangle for each segment and a disc at each point.
void add_wall(b2Body &body, const Wall &wall, std::size_t name) {
    const std::size_t n = wall.points.size();
    for (std::size_t i = 0; i < n; ++i) add_circle(body, wall.points[i], wall.thickness / 2, name);
    for (std::size_t i = 0; i + (wall.closed ? 0 : 1) < n; ++i) {
        const Vec a = wall.points[i], b = wall.points[(i + 1) % n];
        const double scale = wall.thickness / 2 / length(b - a);
        const Vec side = {scale * (a.y - b.y), scale * (b.x - a.x)};
        const b2Vec2 corners[] = {to_b2(a - side), to_b2(b - side), to_b2(b + side),
                                  to_b2(a + side)};
        add_polygon(body, corners, 4, false, name);
    }
}

// If Box2D considers a triangle degenerate, it uses a square of 1 m^2 instead, so triangles that
// are too narrow for Box2D are omitted.
bool is_solid(const Triangle &t) {
    const double longest =
        std::max({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
    const double height = std::abs(cross(t[1] - t[0], t[2] - t[0])) / longest;
    return height > static_cast<double>(b2_linearSlop);
}

void add_solid(b2Body &body, const Polygon &polygon, std::size_t name) {
    for (const Triangle &t : triangulate(polygon.points)) {
        if (!is_solid(t)) continue;
        const b2Vec2 corners[] = {to_b2(t[0]), to_b2(t[1]), to_b2(t[2])};
        add_polygon(body, corners, 3, false, name);
    }
}

// Shrinks the outline by Box2D's skin, so that the skin ends at the true outline.
void add_outline(b2Body &robot, const Chassis &chassis, std::size_t name) {
    b2Vec2 corners[b2_maxPolygonVertices];
    int count = 0;
    for (const Vec &corner : chassis.outline) {
        const Vec arm = corner - chassis.center;
        const double inner = length(arm) - static_cast<double>(b2_polygonRadius);
        corners[count++] = to_b2(chassis.center + (inner / length(arm)) * arm);
    }
    add_polygon(robot, corners, count, true, name);
}

b2Body *add_robot(b2World &physics, const Pose &start, const Chassis &chassis, std::size_t name) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = to_b2(start.position);
    definition.angle = static_cast<float>(start.heading);
    definition.allowSleep = false;
    b2Body *robot = physics.CreateBody(&definition);
    if (chassis.outline.empty())
        add_circle(*robot, chassis.center, chassis.radius, name);
    else
        add_outline(*robot, chassis, name);
    b2MassData mass;
    mass.mass = static_cast<float>(chassis.mass);
    mass.center.SetZero();
    mass.I = static_cast<float>(chassis.inertia);
    robot->SetMassData(&mass);
    return robot;
}

// Formats `FOLDER/FILE:LINE:COLUMN` for display.
std::string in_words(const std::string &place) {
    const std::size_t column = place.rfind(':'), line = place.rfind(':', column - 1);
    if (column == std::string::npos || line == std::string::npos) return place;
    const std::size_t slash = place.rfind('/', line);
    const std::size_t file = slash == std::string::npos ? 0 : slash + 1;
    return place.substr(file, line - file) + ", line " + place.substr(line + 1, column - line - 1);
}

} // namespace

World::World(const Scene &scene, const Chassis &chassis) : physics_(b2Vec2(0.0f, 0.0f)) {
    const b2BodyDef at_rest;
    fixed_ = physics_.CreateBody(&at_rest);
    for (const Wall &wall : scene.walls) add_wall(*fixed_, wall, name("wall", wall.place));
    for (const Polygon &polygon : scene.polygons)
        add_solid(*fixed_, polygon, name("polygon", polygon.place));
    for (const Circle &circle : scene.circles)
        add_circle(*fixed_, circle.center, circle.radius, name("circle", circle.place));
    for (const Cone &cone : scene.cones)
        add_circle(*fixed_, cone.center, cone.radius, name("cone", cone.place));
    for (const Box &box : scene.boxes) boxes_.push_back(&add_box(box));
    for (const Ball &ball : scene.balls) {
        balls_.push_back(&add_ball(ball));
        rolling_.emplace_back(ball);
    }
    for (const Start &start : scene.starts) {
        names_.push_back("robot " + std::to_string(robots_.size() + 1));
        robots_.emplace_back(*add_robot(physics_, start.pose, chassis, names_.size() - 1));
    }
}

std::size_t World::name(const char *kind, const std::string &place) {
    names_.push_back(std::string("the ") + kind + " (" + in_words(place) + ")");
    return names_.size() - 1;
}

const std::string &World::name_of(const b2Fixture &fixture) const {
    return names_[const_cast<b2Fixture &>(fixture).GetUserData().pointer];
}

// Friction of a box on the floor: the maximum force is mu m g, and the maximum torque is that of a
// disc of the same area: 2/3 r mu m g with r = sqrt(a b / pi), where a and b are the box's sides.
b2Body &World::add_box(const Box &box) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = to_b2(box.pose.position);
    definition.angle = static_cast<float>(box.pose.heading);
    b2Body *body = physics_.CreateBody(&definition);
    b2PolygonShape shape;
    const b2Vec2 half = to_b2(0.5 * box.size);
    shape.SetAsBox(half.x, half.y);
    shape.m_radius = 0.0f;
    add_fixture(*body, shape, static_cast<float>(box.mass) / (4.0f * half.x * half.y),
                name("box", box.place));

    b2FrictionJointDef rub;
    rub.Initialize(fixed_, body, body->GetPosition());
    rub.maxForce = static_cast<float>(box.friction * box.mass) * gravity;
    rub.maxTorque =
        rub.maxForce * 2.0f / 3.0f * static_cast<float>(std::sqrt(box.size.x * box.size.y / pi));
    rub.collideConnected = true; // so that the box collides with the walls, which belong to the
                                 // same body as the floor
    physics_.CreateJoint(&rub);
    return *body;
}

// A pushed ball keeps rolling for a while: it loses half of its speed each second.
b2Body &World::add_ball(const Ball &ball) {
    b2BodyDef definition;
    definition.type = ball.speed > 0.0 ? b2_kinematicBody : b2_dynamicBody;
    definition.position = to_b2(ball.way.front());
    definition.linearDamping = 0.7f;
    b2Body *body = physics_.CreateBody(&definition);
    add_circle(*body, {0.0, 0.0}, ball.radius, name("ball", ball.place));
    b2Fixture &fixture = *body->GetFixtureList();
    fixture.SetDensity(static_cast<float>(ball.mass / (pi * ball.radius * ball.radius)));
    body->ResetMassData();
    return *body;
}

// Moves each rolling ball to the place that it reaches on its path at the end of this step.
void World::roll_balls() {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        if (balls_[i]->GetType() != b2_kinematicBody) continue;
        rolling_[i].advance(step_s);
        const b2Vec2 to = to_b2(rolling_[i].place());
        balls_[i]->SetLinearVelocity(static_cast<float>(1.0 / step_s) *
                                     (to - balls_[i]->GetPosition()));
    }
}

void World::step() {
    roll_balls();
    physics_.Step(static_cast<float>(step_s), velocity_iterations, position_iterations);
}

Pose World::object(std::size_t number) const {
    const b2Body &body = number < boxes_.size() ? *boxes_[number] : *balls_[number - boxes_.size()];
    const b2Vec2 at = body.GetPosition();
    return {{static_cast<double>(at.x), static_cast<double>(at.y)},
            static_cast<double>(body.GetAngle())};
}

std::vector<Pose> World::box_poses() const {
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < boxes_.size(); ++i) poses.push_back(object(i));
    return poses;
}

std::vector<Vec> World::ball_places() const {
    std::vector<Vec> places;
    for (std::size_t i = boxes_.size(); i < objects(); ++i) places.push_back(object(i).position);
    return places;
}

} // namespace frob::sim
