let all =
  [
    (("geometry_msgs", "Point"), ("Geometry", "Point3", "Point3"));
    (("geometry_msgs", "Point32"), ("Geometry", "Point3", "Point3"));
    (("geometry_msgs", "Quaternion"), ("Ros", "Quaternion", "Quaternion"));
    (("geometry_msgs", "Pose"), ("Ros", "Pose3", "Pose3"));
    (("geometry_msgs", "PoseWithCovariance"), ("Ros", "PoseWithCovariance", "PoseWithCovariance"));
    (("geometry_msgs", "PoseStamped"), ("Ros", "PoseStamped", "PoseStamped"));
    (("geometry_msgs", "PointStamped"), ("Ros", "PointStamped", "PointStamped"));
    (("geometry_msgs", "Twist"), ("Ros", "Twist", "Twist"));
    (("geometry_msgs", "TwistWithCovariance"), ("Ros", "TwistWithCovariance", "TwistWithCovariance"));
    (("geometry_msgs", "Accel"), ("Ros", "Accel", "Accel"));
    (("geometry_msgs", "Wrench"), ("Ros", "Wrench", "Wrench"));
    (("std_msgs", "ColorRGBA"), ("Ros", "ColorRGBA", "ColorRGBA"));
    (("builtin_interfaces", "Time"), ("Ros", "Stamp", "Stamp"));
    (("builtin_interfaces", "Duration"), ("Ros", "Duration", "Duration"));
  ]
