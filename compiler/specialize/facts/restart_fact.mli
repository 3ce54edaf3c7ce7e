(** Signal functions and tasks that restart themselves in a way that frobc cannot compile. *)

open Basis

type hop = { ended : string; by : string; place : Span.t }
(** A step into a continuation: the task that ended, the definition that determines the next task,
    and the place of that definition. *)

type t =
  | In_one_instant of { at : Span.t; hops : hop list; own : Span.t list }
      (** a cycle of tasks that end immediately. [own]: the places in [hops] that are outside the
          prelude *)
  | Before_the_end of { at : Span.t; waiting : Span.t; task : string option }
      (** the task [task] restarts itself at [at], while the continuation [waiting] waits for it *)
  | Growing of {
      at : Span.t;
      name : string;
      is_task : bool;
      added : string;  (** the function that each restart adds again; [if] for a choice *)
      is_choice : bool;
      way : (string * Span.t) list;
          (** the definitions outside the library that run between two restarts, and the places
              where they start *)
    }
  | Inside_itself of {
      at : Span.t;  (** the place where it runs *)
      name : string;
      is_task : bool;
      goes_on : bool;  (** whether it is an [rSwitch], which never ends *)
      calls : Calls.t;  (** the calls through which it runs again, outermost first; at least one *)
    }
