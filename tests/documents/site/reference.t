The reference that `make site` generates from the library, the messages and frobc's help.

  $ top=../../..
  $ python3 -B $top/docs/site/reference.py $top $(command -v frobc) .

Each name that the language reference describes has an entry, with its type and the library's
comment:

  $ sed -n '/^## Appendix A/,$p' $top/docs/language.md | grep '^| `' | cut -d'|' -f2 |
  >   sed 's/\\$/.|./' | grep -o '`[^`]*`' | tr -d '`' | sort -u > described
  $ grep '^####* `' library.md | grep -o '`[^`]*`' | tr -d '`' | sort -u > entries
  $ comm -23 described entries
  $ test $(wc -l < entries) -gt 200
  $ grep -A 6 '^### `sin`' library.md
  ### `sin`, `cos`, `tan` { #Prelude-sin }
  
  ```haskell
  sin, cos, tan :: Angle -> Float
  ```
  
  The sine, cosine and tangent of an angle in radians.

There is an entry for each message and each command:

  $ ls $top/compiler/explain/*/*.md | wc -l > pages
  $ grep -c '^## [EW]0[0-9]*: .* { #[EW]' messages.md | diff - pages
  $ frobc --help=plain | sed -n '/^COMMANDS/,/^COMMON/p' | grep '^       [a-z]' | awk '{ print "## frobc " $1 }' > commands
  $ grep '^## frobc ' commands.md | diff - commands
