(** Exports a program as a package of ROS 2, which [colcon build] builds without frobc. *)

val export :
  Common_options.t -> entry:string -> sources:string list -> folder:string -> string -> int
(** Writes the package: [package.xml], [CMakeLists.txt] and a launch file, unless these files exist,
    because users edit them; and [src/] with the generated C, the user's own C files [sources] and
    the runtime. Returns the exit status. *)
