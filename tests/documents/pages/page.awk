# Does what a page of docs/ tells its reader to do, and prints the page with what really
# came out. So the page is right if it comes out as it was, and `dune promote` mends it.
#
#   awk -v pages=FOLDER -f page.awk PAGE.md
#
# In a folder of the page's own, FOLDER/PAGE, it does from top to bottom:
#
#   ```frob title="drive.frob"     writes the file (so with toml, c, csv …)
#   ```console                     runs what stands behind `$ `, and shows what it printed;
#                                  a line that begins with `> ` goes on with a command
#   <!-- sh … -->                  the same, hidden from readers, and prints nothing
#
# What a run says of its own speed is left as it is in the page.
function quoted(text) { gsub(/'/, "'\\''", text); return "'" text "'" }

# Runs a command in the page's folder, by a shell, and gives what it printed, by lines.
function run(command, shown,    line, whole, python) {
    # Python as a reader has it, with the package; Debian's, for what is installed there.
    python = "PYTHONPATH=$PWD/../../../runtime/python; export PYTHONPATH; " \
        "python3() { if test -x /usr/bin/python3; then /usr/bin/python3 -B \"$@\"; " \
        "else command python3 -B \"$@\"; fi; }; "
    whole = python "cd " quoted(folder) " && { " command "\n} 2>&1 </dev/null"
    while ((whole | getline line) > 0) {
        printed++
        if (line ~ /^simulated seconds per second: / && printed in before &&
            before[printed] ~ /^simulated seconds per second: /)
            line = before[printed]
        if (shown) print line
        else fail("this should print nothing: " line)
    }
    close(whole)
}

function fail(why) {
    print FILENAME ":" FNR ": " why > "/dev/stderr"
    failed = 1
}

# The commands of a session have been read, with what the page says that they print.
function perform(    k, i, from) {
    for (k = 1; k <= commands; k++) {
        split("", before)
        for (i = 1; i <= expected[k]; i++) before[i] = output[k, i]
        printed = 0
        print shown[k]
        said = said "\n" command[k]
        run(command[k], 1)
    }
}

FNR == 1 {
    name = FILENAME
    sub(/^.*\//, "", name); sub(/\.md$/, "", name)
    folder = pages "/" name
    system("rm -rf " quoted(folder) " && mkdir -p " quoted(folder))
}

state == "" && /^```[a-z]+ title="[^"]+"$/ {
    file = $0
    sub(/^[^"]*"/, "", file); sub(/"$/, "", file)
    titles[file] = FNR
    if (file ~ /\.frob$/) programs = programs " " quoted(file)
    target = folder "/" file
    printf "" > target
    state = "file"; print; next
}
state == "file" && /^```$/ { close(target); state = ""; print; next }
state == "file" {
    if (/^import / || file ~ /\.py$/) said = said "\n" $0
    print > target; print; next
}

state == "" && /^```console$/ { state = "session"; commands = 0; print; next }
state == "session" && /^```$/ { perform(); state = ""; print; next }
state == "session" && /^\$ / {
    commands++
    shown[commands] = $0
    command[commands] = substr($0, 3)
    expected[commands] = 0
    next
}
state == "session" && /^> / && expected[commands] == 0 {
    shown[commands] = shown[commands] "\n" $0
    command[commands] = command[commands] "\n" substr($0, 3)
    next
}
state == "session" {
    if (commands == 0) fail("a session begins with `$ `")
    output[commands, ++expected[commands]] = $0
    next
}

state == "" && /^<!-- sh$/ { state = "hidden"; hidden = ""; print; next }
state == "hidden" && /^-->$/ { run(hidden, 0); state = ""; print; next }
state == "hidden" { hidden = hidden $0 "\n"; print; next }

state == "" && /^```[a-z]/ { state = "other"; print; next }
state == "other" && /^```$/ { state = ""; print; next }
{ print }

END {
    if (state != "") fail("the page ends within a block")
    # What is shown is tried: a command or a script mentions it, or a program imports it.
    for (file in titles) {
        stem = file
        sub(/\.[a-z]+$/, "", stem)
        if (index(said, stem) == 0) fail("no command or program of the page uses " file)
    }
    # Readers copy the layout of what they read.
    if (programs != "") run("frobc format --check" programs, 0)
    exit failed
}
