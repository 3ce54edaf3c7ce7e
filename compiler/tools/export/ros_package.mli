(** Exports a program as a ROS 2 package, which [colcon build] builds without frobc. *)

val export :
  Common_options.t -> entry:string -> sources:string list -> folder:string -> string -> int
(** Writes the package. The folder [src/] contains the generated C, the user's own C files [sources]
    and the runtime. The files [package.xml], [CMakeLists.txt] and a launch file are written only if
    they do not exist yet, because users edit them. Returns the exit status. *)
