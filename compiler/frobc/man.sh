# man.sh FROBC PAGE…: writes the manual pages frobc.1 and frobc-COMMAND.1 from --help. Cmdliner
# writes the characters -, . and ' as numeric escapes, which whatis cannot read, so they are
# replaced.
set -eu
frobc=$1
shift
for page in "$@"; do
    command=${page#frobc}
    command=${command#-}
    "./$frobc" ${command%.1} --help=groff |
        sed "s/\\\\N'39'/\\\\(aq/g; s/\\\\N'45'/\\\\-/g; s/\\\\N'46'/\\\\\\&./g" > "$page"
done
