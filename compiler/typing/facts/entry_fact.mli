(** Facts about the definition that a program is compiled from. *)

open Basis

(** Why a definition cannot be an entry. *)
type refusal =
  | Function_as_output of { output : Ir.ty; at : Span.t }
      (** its output is a function that sets the output of a robot *)
  | Not_a_robot_output of Span.t  (** the place of its output *)
  | Type_variables of {
      is_program : bool;  (** a [Program], not a signal function *)
      size : string option;
          (** a size variable with the same name as a definition in the same module *)
    }  (** the type of its input or output contains variables *)
  | Missing_argument  (** a function that returns a signal function or a [Program] *)
  | Task
  | Function of {
      arguments : int;
      sets_output : bool;  (** it sets the output of a robot *)
      is_closed : bool;  (** its type contains no variables *)
    }
  | Value

type t =
  | Refused of { definition : Ir.definition; refusal : refusal }
  | No_entry of { file : string; name : string; others : string list }
      (** no definition of the main module has this name; [others]: the names of its definitions *)
