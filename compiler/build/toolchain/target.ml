type kind =
  | Prebuilt  (** this machine, with the host that comes with frobc *)
  | Linux of string list
  | Board of {
      port : string;
      script : string;
      options : string list;
      single : string list;
          (** options for single-precision programs, to use the floating-point unit *)
    }

type t = {
  name : string;
  meaning : string;
  compiler : string option;  (** [None]: this machine's compiler *)
  package : string;
  kind : kind;
}

let table =
  [
    { name = "host"; meaning = "this machine"; compiler = None; package = "gcc"; kind = Prebuilt };
    {
      name = "linux";
      meaning = "this machine, with the host compiled from source";
      compiler = None;
      package = "gcc";
      kind = Linux [];
    };
    {
      name = "aarch64-linux";
      meaning = "64-bit ARM";
      compiler = Some "aarch64-linux-gnu-gcc";
      package = "gcc-aarch64-linux-gnu libc6-dev-arm64-cross";
      kind = Linux [];
    };
    {
      name = "armhf-linux";
      meaning = "32-bit ARM with a floating-point unit";
      compiler = Some "arm-linux-gnueabihf-gcc";
      package = "gcc-arm-linux-gnueabihf libc6-dev-armhf-cross";
      kind = Linux [];
    };
    {
      name = "cortex-m";
      meaning = "a board without an operating system, emulated by qemu as mps2-an386";
      compiler = Some "arm-none-eabi-gcc";
      package = "gcc-arm-none-eabi libnewlib-arm-none-eabi";
      kind =
        Board
          {
            port = "cortex_m";
            script = "mps2_an386.ld";
            options = [ "-mthumb"; "-mcpu=cortex-m4" ];
            single = [ "-mfpu=fpv4-sp-d16"; "-mfloat-abi=hard" ];
          };
    };
  ]

let names = List.map (fun t -> t.name) table
let of_name name = List.find_opt (fun t -> String.equal t.name name) table
let meaning t = t.meaning
let ( / ) = Filename.concat

let machine t options =
  match t.compiler with
  | None -> { (Toolchain.this_machine ()) with options }
  | Some compiler ->
      {
        compiler;
        fix = Printf.sprintf "install it (on Debian: apt-get install %s)" t.package;
        options;
      }

let files folder =
  let names = Sys.readdir folder in
  Array.sort compare names;
  List.map (fun name -> folder / name) (Array.to_list names)

let with_suffix suffix = List.filter (fun file -> Filename.check_suffix file suffix)

(* The source files in these folders of the runtime, and the headers that they may include. *)
let from_sources (resources : Resources.t) folders =
  let runtime = resources.runtime_sources in
  let drivers = runtime / "drivers" in
  let folders =
    List.map (fun folder -> runtime / folder) folders @ List.filter Sys.is_directory (files drivers)
  in
  let all = List.concat_map files folders @ files resources.elementary in
  (with_suffix ".c" all, with_suffix ".h" (all @ files drivers @ files (runtime / "hal")))

let state_of name =
  ( name ^ "_memory.c",
    Printf.sprintf
      "#include \"%s.h\"\n\n\
       static struct %s_state state;\n\
       void *const frob_program_state = &state;\n"
      name name )

(* The file that defines [frob_own_driver] for [hosts/robot/drivers.c] and [hosts/board/loop.c]. *)
let own_driver ~name robot =
  ( name ^ "_driver.c",
    match robot with
    | Some (robot : Cgen.Robot.t) ->
        Printf.sprintf
          "/* The user's own driver, for the host. */\n\
           struct frob_driver;\n\
           extern const struct frob_driver frob_%s_driver;\n\
           extern const struct frob_driver *const frob_own_driver;\n\
           const struct frob_driver *const frob_own_driver = &frob_%s_driver;\n"
          robot.name robot.name
    | None ->
        "/* The robot's driver is one of the host's. */\n\
         struct frob_driver;\n\
         extern const struct frob_driver *const frob_own_driver;\n\
         const struct frob_driver *const frob_own_driver = 0;\n" )

let linked ?own t ~(real : Basis.Real.t) (resources : Resources.t) ~name =
  let include_ = [ "-I"; resources.runtime_sources ] in
  let driver = own_driver ~name own in
  match t.kind with
  | Prebuilt ->
      {
        (* a user-defined driver includes the runtime's headers *)
        Built.machine = (if own = None then None else Some (machine t include_));
        inputs = [ resources.robot_host; resources.runtime ];
        includes = [];
        generated = [ driver ];
        sees = true;
        ros2 = false;
      }
  | Linux options ->
      let inputs, includes =
        from_sources resources
          [ "core"; "hal/posix"; "hosts/common"; "hosts/camera"; "hosts/robot"; "vision" ]
      in
      {
        (* -O3 speeds up the vision kernels, which are loops over pixels *)
        machine = Some (machine t (options @ ("-O3" :: "-D_GNU_SOURCE" :: include_)));
        inputs;
        includes;
        generated = [ driver ];
        sees = true;
        ros2 = false;
      }
  | Board { port; script; options; single } ->
      let inputs, includes =
        from_sources resources [ "core"; "hal" / port; "hosts/board"; "hosts" / port ]
      in
      let script = resources.runtime_sources / "hal" / port / script in
      let options =
        options
        @ (match real with Double -> [] | Single -> single)
        @ [ "-ffunction-sections"; "-fdata-sections"; "-Wl,--gc-sections"; "-nostartfiles" ]
        @ [ "--specs=nano.specs"; "--specs=nosys.specs"; "-T"; script ]
      in
      {
        machine = Some (machine t (options @ include_));
        inputs;
        includes = script :: includes;
        generated = [ state_of name; driver ];
        sees = false;
        ros2 = false;
      }

let ros2 (ros2 : Ros2.t) (resources : Resources.t) ~name:_ =
  let runtime = resources.runtime_sources in
  let host = files (runtime / "hosts" / "ros") in
  {
    Built.machine =
      Some { (Toolchain.this_machine ()) with options = "-I" :: runtime :: ros2.options };
    (* The archive also contains a main function, which is not needed here. *)
    inputs = with_suffix ".c" host @ [ resources.robot_host; resources.runtime ] @ ros2.libraries;
    includes = with_suffix ".h" host;
    generated = [];
    sees = true;
    ros2 = true;
  }

let simulated_ros2 (ros2 : Ros2.t) (resources : Resources.t) =
  let runtime = resources.runtime_sources in
  let machine = { (Toolchain.this_machine ()) with options = "-I" :: runtime :: ros2.options } in
  let host = files (runtime / "hosts" / "ros_robot") in
  Toolchain.build ~machine Executable ~headers:resources.headers
    ~inputs:(with_suffix ".c" host @ ros2.libraries)
    ~includes:((runtime / "hosts" / "ros" / "messages.h") :: with_suffix ".h" host)
    ~foreign:None ~name:"robot" []

let size_tool t =
  match (t.kind, t.compiler) with
  | Board _, Some compiler when Filename.check_suffix compiler "gcc" ->
      Some (Filename.chop_suffix compiler "gcc" ^ "size")
  | (Board _ | Prebuilt | Linux _), _ -> None
