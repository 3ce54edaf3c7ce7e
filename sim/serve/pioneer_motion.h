// Computes the speeds that a Pioneer's motors should have at each moment. The client sets a speed,
// a distance to go, or a heading to turn to; driving forward and turning are independent. Units are
// metres, radians and seconds.
#pragma once

#include <optional>

namespace frob::serve {

// The robot's heading according to odometry, and its speeds.
struct PioneerState {
    double heading;     // in [-pi, pi]
    double speed, turn; // measured, m/s and rad/s
};

class PioneerMotion {
  public:
    // The arguments are the limits that apply until a client sets its own.
    PioneerMotion(double top_speed, double top_turn);

    void set_speed(double speed);            // VEL
    void set_turn(double turn);              // RVEL, ROTATE
    void move(double distance);              // MOVE: drive this distance, then stop
    void face(double heading);               // HEAD: turn to this heading according to odometry
    void face_by(double angle, double from); // DHEAD: turn by an angle from the heading; DCHEAD:
                                             // from the heading setpoint
    void stop();                             // STOP: brake with the client's decelerations
    void halt();                             // E_STOP, motors off: stop immediately

    // SETV, SETRV, SETA, SETRA. A positive acceleration is for speeding up, a negative one for
    // braking. Until a client sets them, only the body's limits apply.
    void limit_speed(double most);
    void limit_turn(double most);
    void accelerate(double acceleration);
    void accelerate_turn(double acceleration);

    // Advances by `elapsed_s`, given the robot's state at the end of this time.
    void advance(const PioneerState &state, double elapsed_s);

    double forward() const { return forward_.told; }
    double turn() const { return turn_.told; }

    // The heading to turn to, if the robot is turning to one.
    std::optional<double> heading_setpoint() const { return heading_; }

  private:
    struct Axis {
        double top;              // the robot's limit
        double most;             // the client's limit
        double up = 0, down = 0; // accelerations; 0 if they are not limited
        double wanted = 0, told = 0;
        void want(double value);
        void approach(double elapsed_s);
    };

    Axis forward_, turn_;
    std::optional<double> left_; // remaining distance of a MOVE
    std::optional<double> heading_;
};

} // namespace frob::serve
