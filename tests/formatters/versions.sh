# The pinned version of each formatter. A change of a version changes the sources: run `make fmt`
# and list that commit in .git-blame-ignore-revs.
OCAMLFORMAT=0.27.0
CLANG_FORMAT=19.1.7
RUFF=0.14.5
PRETTIER=3.6.2
