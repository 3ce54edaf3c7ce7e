(** What an expression of Core can be, when a program runs. *)

type t =
  | Bool of bool
  | Int of int32
  | Float of float
  | Text of string
  | Tuple of thunk array
  | Array of thunk array
  | Drawing of thunk list  (** its marks, the last one first *)
  | Image of Kernels.image  (** what a camera saw *)
  | Data of { constructor : int; arguments : thunk array }
  | Function of (thunk -> t)
  | Signal_function of (unit -> instance)  (** starts it; a program is the signal function in it *)
  | Task of task
  | Ending of { signal_function : thunk; result : Core.Ir.ty }
      (** a program that ends: beside its output the signal function has the event of its end, with
          a value of this type *)

and thunk = t Thunk.t

(** An activity that ends. *)
and task =
  | Runs of { signal_function : thunk; ended : thunk -> (thunk, thunk) Either.t }
      (** [ended]: of what it puts out, the output, or what it has ended with *)
  | Returns of thunk
  | First of thunk * thunk  (** a task, and the function that gives the one after it *)

and instance = {
  output : Clock.instant -> thunk -> thunk;
      (** The output for this input. Evaluates nothing yet: what comes back may be part of the
          input. What it is made of no longer changes, so it can be evaluated at any time. *)
  commit : unit -> unit;  (** The state becomes that of the next instant. *)
  successor : unit -> instance option;
      (** What may from now on run in its place, if it only hands on to that. Not to be called
          before the first [commit]. *)
}
(** A signal function that has been started, with its state. In each instant first [output] is
    called, then [commit], each once. *)
