(** The run-time values of Core expressions. *)

type t =
  | Bool of bool
  | Int of int32
  | Float of float
  | Text of string
  | Tuple of thunk array
  | Array of thunk array
  | Drawing of thunk list  (** the marks of the drawing, in reverse order *)
  | Image of Kernels.image  (** an image from a camera *)
  | Data of { constructor : int; arguments : thunk array }
  | Function of (thunk -> t)
  | Signal_function of (unit -> instance)
      (** a function that starts an instance; also represents a program *)
  | Task of task
  | Ending of { signal_function : thunk; result : Core.Ir.ty }
      (** a program that can end: besides its output, the signal function returns an event that
          signals the end and carries a value of type [result] *)

and thunk = t Thunk.t

(** An activity that ends. *)
and task =
  | Runs of { signal_function : thunk; ended : thunk -> (thunk, thunk) Either.t }
      (** [ended] examines an output of the signal function: it returns either the output to show,
          or the result with which the task ends *)
  | Returns of thunk
  | First of thunk * thunk  (** a task, and the function that maps its result to the next task *)

and instance = {
  output : Clock.instant -> thunk -> thunk;
      (** Returns the output for this input as a thunk, which may even be part of the input. The
          thunk can be evaluated at any time, because it does not depend on later state. *)
  commit : unit -> unit;  (** Advances the state to the next instant. *)
  successor : unit -> instance option;
      (** The instance that can replace this instance from now on, if this instance only forwards to
          it. Call this only after the first [commit]. *)
}
(** A started signal function with its state. In each instant, call [output] once and then [commit]
    once. *)
