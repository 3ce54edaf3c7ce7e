(** Facts that {!Levels} reports. *)

open Basis

(** {1 Instances in the wrong places} *)

(** The position of some code, which determines whether it is evaluated at every instant. *)
type position =
  | Outside  (** outside all procs *)
  | In_task  (** outside all procs, in a [do] *)
  | Every_instant
  | In_branch of condition option  (** the condition, if this is the only enclosing choice *)
  | In_guard
  | In_function of string  (** the function's name; [""] for a lambda *)

and condition = { test : Ir.expr; chosen_if : bool }

(** The reason why the instance cannot simply run at every instant. *)
type obstacle =
  | Depends_on_start
      (** the instance could run at every instant, but the user may have meant it to restart *)
  | Bound_here of Ir.Local.t
      (** the instance mentions this variable, which does not have a value at every instant *)
  | Own_definition  (** the instance is part of its own definition *)
  | Lifted
      (** the enclosing function is polymorphic or recursive, so it does not belong to a single proc
      *)

(** {1 Values that are not static} *)

(** The parts of a program that must be static. *)
type region =
  | Head of { head : Ir.expr; input : Ir.expr; value : Ir.Local.t -> Ir.expr option }
      (** the signal function that runs here. [value]: the values of local variables *)
  | Binding_of of Ir.Local.t  (** a signal function *)
  | Binding_of_task of Ir.Local.t

type reason = { variable : Ir.Local.t; why : why }
(** Why the variable is a signal. *)

and why =
  | Input  (** it comes from the input of a proc *)
  | Runs_at of Span.t  (** a signal function runs at this place *)
  | Depends_on of Ir.Local.t * Span.t  (** its definition mentions this signal at this place *)

type cause =
  | Mentions of Ir.Local.t * reason list
      (** it mentions this signal; each reason explains the one before it *)
  | Runs of Ir.expr  (** it runs this signal function *)

(** {1 Indices} *)

(** Why an index is not constant, and where. *)
type problem =
  | Variable of Ir.Local.t * Span.t
      (** it is a function parameter, or a variable that depends on one *)
  | Param of Ir.Global.t * Span.t  (** it mentions a program parameter at this place *)
  | Computed of Span.t  (** it contains something other than arithmetic *)

(** {1 Facts} *)

type t =
  | Not_static of { at : Span.t; region : region; cause : cause }
  | Misplaced of {
      definition : Ir.Global.t;
      within : Ir.expr;  (** the value of the definition *)
      position : position;  (** not [Every_instant] *)
      obstacle : obstacle;
      instance : Ir.expr;  (** runs [head] on [input] *)
      head : Ir.expr;
      input : Ir.expr;
    }
  | Recursive of { variable : Ir.Local.t; use : Ir.expr }
      (** a [let] or [where] that defines the variable in terms of itself *)
  | Index_not_constant of { index : Ir.expr; array : Ir.expr option; problem : problem }
      (** [array] is absent if [!] has no argument *)
  | Index_outside of { array : Ir.expr; index : Ir.expr; value : int; size : int option }
      (** the index is out of range for an array of this size, or negative *)
