// What a Pioneer's motors are told from moment to moment: by a speed, a distance
// to go, or a heading to turn to; forward and turning each for itself. Metres,
// radians, seconds.
#pragma once

#include <optional>

namespace frob::serve
{

// Where the robot is by its odometry, and how fast.
struct PioneerState {
    double heading;     // within half a turn either way
    double speed, turn; // measured, m/s and rad/s
};

class PioneerMotion
{
  public:
    // The limits that hold until a client sets its own.
    PioneerMotion(double top_speed, double top_turn);

    void set_speed(double speed);            // VEL
    void set_turn(double turn);              // RVEL, ROTATE
    void move(double distance);              // MOVE: so far on, then rest
    void face(double heading);               // HEAD, with odometry's zero as its own
    void face_by(double angle, double from); // DHEAD from the heading, DCHEAD from the setpoint
    void stop();                             // STOP: as fast as decelerations let it
    void halt();                             // E_STOP, motors off: at once

    // SETV, SETRV, SETA, SETRA. A positive acceleration is for speeding up, a
    // negative one for braking; without them the body's limits hold alone.
    void limit_speed(double most);
    void limit_turn(double most);
    void accelerate(double acceleration);
    void accelerate_turn(double acceleration);

    // Goes on by `elapsed_s` with what the robot has done meanwhile.
    void advance(const PioneerState &state, double elapsed_s);

    double forward() const { return forward_.told; }
    double turn() const { return turn_.told; }

    // The heading to turn to, if that is what it does.
    std::optional<double> heading_setpoint() const { return heading_; }

  private:
    struct Axis {
        double top;              // the robot's
        double most;             // the client's
        double up = 0, down = 0; // accelerations; 0: none
        double wanted = 0, told = 0;
        void want(double value);
        void approach(double elapsed_s);
    };

    Axis forward_, turn_;
    std::optional<double> left_; // of a distance to go
    std::optional<double> heading_;
};

} // namespace frob::serve
