Each command has help, and nothing in its text is amiss, which would be said beside it.

  $ frobc --help=plain > /dev/null
  $ for command in new check fix format compile trace run view serve build export report selftest header explain lsp; do
  >   frobc $command --help=plain > help && grep -q '^SYNOPSIS' help || echo "$command"
  > done
