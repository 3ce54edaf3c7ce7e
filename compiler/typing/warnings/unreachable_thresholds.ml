open Basis
open Ir

type walk = {
  facts : Fact.t Facts.t;
  robot : Global.t option;
  constants : Constant.t;
  program : program;
  readings : (string * ty) Int_table.t;
      (* variables whose value is a sonar reading, with the method's name and the type of the
         robot's input *)
}

let sonar = "HasSonar"

(* The range of the sonar of the robot with this input type. *)
let rec reach w (input : ty) =
  match input with
  | Data { tycon; arguments; _ } -> of_instance w tycon arguments
  | Variable _ -> Option.bind w.robot (fun tycon -> of_instance w tycon [])
  | _ -> None

and of_instance w tycon arguments =
  let is_it (i : instance) =
    String.equal i.class_.name sonar && match i.head with Data d -> d.tycon = tycon | _ -> false
  in
  let body (i : instance) =
    match List.find_opt (fun ((m : Global.t), _) -> String.equal m.name "sonarReach") i.methods with
    | Some (_, Given g) -> (
        match List.find_opt (fun (d : definition) -> d.name = g) w.program.definitions with
        | Some { value = { desc = Lambda (_, body); _ }; _ } -> Some (i, body)
        | _ -> None)
    | _ -> None
  in
  match Option.bind (List.find_opt is_it w.program.instances) body with
  | None -> None
  | Some (i, body) -> (
      match (Constant.float w.constants body, body.desc) with
      | Some metres, _ -> Some (tycon.module_, metres)
      | None, Apply ({ desc = Method { instantiation = { types = [ Variable v ]; _ }; _ }; _ }, _)
        ->
          (* the range of the robot that this one wraps *)
          List.find_map
            (fun ((p : variable), argument) -> if p.id = v.id then reach w argument else None)
            (List.combine i.parameters arguments)
      | None, _ -> None)

let reading w (e : expr) =
  match e.desc with
  | Run ({ desc = Method { class_; method_; instantiation = { types = input :: _; _ } }; _ }, _)
    when String.equal class_.name sonar ->
      Some (method_.name, input)
  | Local (local, _) -> Int_table.find_opt w.readings local.id
  | _ -> None

(* The constant result, if any, of comparing a reading of at most [reach] with the threshold. *)
let answer operator ~reach threshold =
  match operator with
  | "<" when threshold > reach -> Some true
  | "<=" when threshold >= reach -> Some true
  | ">" when threshold >= reach -> Some false
  | ">=" when threshold > reach -> Some false
  | _ -> None

let mirrored = function "<" -> ">" | "<=" -> ">=" | ">" -> "<" | ">=" -> "<=" | other -> other

let compared w (e : expr) operator reading_of threshold =
  match (reading w reading_of, Constant.float w.constants threshold) with
  | Some (sensor, input), Some c -> (
      match reach w input with
      | None -> ()
      | Some (robot, reach) ->
          let report result =
            Facts.report w.facts
              (Warning (Unreachable_threshold { comparison = e; result; robot; sensor; reach }))
          in
          Option.iter report (answer operator ~reach c))
  | _ -> ()

let rec expr w (e : expr) =
  (match e.desc with
  | Let (bindings, _) | Proc { equations = bindings; _ } -> List.iter (note w) bindings
  | _ -> ());
  (match Constant.operation e with
  | Some ((("<" | "<=" | ">" | ">=") as operator), [ a; b ]) ->
      compared w e operator a b;
      compared w e (mirrored operator) b a
  | _ -> ());
  Walk.parts (expr w) e

and note w (b : binding) =
  match (b.pattern.desc, reading w b.value) with
  | Bound local, Some reading -> Int_table.replace w.readings local.id reading
  | _ -> ()

let warn facts resolved ~robot (program : program) =
  let constants = Constant.of_program program in
  let look = expr { facts; robot; constants; program; readings = Int_table.create 8 } in
  Walk.own resolved look program
