# man.sh FROBC PAGE…: the pages of man, frobc.1 and frobc-COMMAND.1: what --help says.
# Cmdliner writes -, . and ' by number, which whatis does not read.
set -eu
frobc=$1
shift
for page in "$@"; do
    command=${page#frobc}
    command=${command#-}
    "./$frobc" ${command%.1} --help=groff |
        sed "s/\\\\N'39'/\\\\(aq/g; s/\\\\N'45'/\\\\-/g; s/\\\\N'46'/\\\\\\&./g" > "$page"
done
