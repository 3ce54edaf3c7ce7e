(** Draws the machines of a program as a state diagram in SVG, arranged as on the page of a run.

    The states of a machine are in a column, from the initial state on. An arrow to the next state
    is a short line, an arrow further down is a curve on the right, and an arrow up is a curve on
    the left, so no arrow crosses a state or a text. The text next to a state shows its line in the
    program, the signal functions whose events end it, and the machines that run inside it. An arrow
    is dashed if the transition may take no time, and hollow if the output in this instant still
    comes from the old state. A dot marks the initial state. An arrow that does not begin at a state
    is an event from outside. A machine is above those that run inside it.

    The drawing follows the light or dark theme of the reader, and depends on the program alone. *)

val print : Format.formatter -> name:string -> Machines.t list -> unit
