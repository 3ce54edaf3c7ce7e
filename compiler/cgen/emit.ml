type t = {
  header : string;
  source : string;
  host_table : string option;
  robot : string option;
  node : Node_table.t option;
  robot_header : (string * string) option;
  cameras : string list;
  simulated : string list;
  foreign : foreign;
}

and foreign = { calls : string list; headers : Flow.Ir.header list }

let program ?own ?units ?named ?batch ?banner ?node (program : Step.Ir.program) =
  let files = Of_step.program ?own ?units ?named ?batch ?banner program in
  {
    header = Print.file files.header;
    source = Print.file files.source;
    host_table =
      (if List.for_all (Flow.Shape.for_hosts program.sums) [ program.input; program.output ] then
         Some (Host_table.text ?own ?node program files)
       else None);
    robot = Option.map (fun (robot : Robot.t) -> robot.name) (Host_table.robot ?own program);
    node;
    robot_header = None;
    cameras = List.sort_uniq String.compare (List.filter_map Core.Console.camera program.console);
    simulated = List.filter_map Core.Console.simulated program.console;
    foreign =
      {
        calls =
          List.filter_map
            (fun (node : Step.Ir.node) ->
              Option.map (fun (f : Flow.Ir.foreign) -> f.import.symbol) node.foreign)
            (Array.to_list program.nodes);
        headers = List.sort_uniq compare program.headers;
      };
  }

let print ppf files =
  Format.pp_print_string ppf files.header;
  Format.pp_print_string ppf files.source
