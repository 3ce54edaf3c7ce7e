Each command has help, without errors in its text, which cmdliner would print next to it.

  $ frobc --help=plain > whole
  $ commands=$(frobc help nothing 2>&1 | sed -n 's/.*the commands are //p' | tr -d ,)
  $ echo $commands
  help new demo check fix format compile trace run test sweep falsify view convert serve build export report selftest header explain extras ros2 doctor lsp
  $ for command in $commands; do
  >   frobc $command --help=plain > help && grep -q '^SYNOPSIS' help || echo "$command"
  >   TERM=dumb frobc help $command 2>&1 | diff help - || echo "$command"
  >   grep -q "^       $command" whole || echo "$command"
  > done
  $ TERM=dumb frobc help | diff whole -

There is a manual page for each command, and for frobc (compiler/frobc/dune
lists them).

  $ man=$(dirname $(which frobc))/../man/man1
  $ test $(ls $man/frobc*.1 | wc -l) = $(echo frobc $commands | wc -w) || ls $man
  $ for page in frobc $(for command in $commands; do echo frobc-$command; done); do
  >   name=$(echo $page | tr a-z A-Z)
  >   grep -q "^.TH \"$name\" 1" $man/$page.1 || echo "$page"
  > done
  $ grep -l "N'\(39\|45\|46\)'" $man/*.1
  [1]
