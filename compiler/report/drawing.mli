(** Draws the machines of a program as a state diagram in SVG, with the same layout as on the page
    of a run.

    The states of a machine form a column that starts with the initial state. An arrow to the next
    state is a short line. Arrows that lead further down are curves on the right, and arrows that
    lead up are curves on the left, so no arrow crosses a state or its text. The text next to a
    state shows its line in the program, the signal functions whose events end it, and the machines
    that run inside it. An arrow is dashed if the transition may take no time, and hollow if the
    output in this instant still comes from the old state. A dot marks the initial state. An arrow
    that does not begin at a state represents an event from outside. A machine is drawn above the
    machines that run inside it.

    The drawing adapts to the reader's light or dark theme. Otherwise, it depends only on the
    program. *)

val print : Format.formatter -> name:string -> Machines.t list -> unit
