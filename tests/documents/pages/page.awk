# Follows the instructions of a page of docs/, and prints the page with the actual output.
# The page is correct if nothing changes; otherwise `dune promote` updates it.
#
#   awk -v pages=FOLDER -f page.awk PAGE.md
#
# In the page's own folder, FOLDER/PAGE, the script handles these blocks from top to
# bottom:
#
#   ```frob title="drive.frob"     writes the file (also with toml, c, csv …)
#   ```console                     runs the command after each `$ `, and shows its output;
#                                  a line that begins with `> ` continues a command
#   <!-- sh … -->                  runs commands that are hidden from readers; no output
#
# Lines in which a run reports its own speed stay as they are in the page.
function quoted(text) { gsub(/'/, "'\\''", text); return "'" text "'" }

# Runs a command in the page's folder with a shell, and returns its output, split into lines.
function run(command, shown,    line, whole, python) {
    # The Python that readers have, with the package; Debian's Python, because it has the packages.
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

# Runs the commands of a session, which have been read with their expected output.
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
    # Each file on the page must be used: a command or a script mentions it, or a program imports
    # it.
    for (file in titles) {
        stem = file
        sub(/\.[a-z]+$/, "", stem)
        if (index(said, stem) == 0) fail("no command or program of the page uses " file)
    }
    # Readers copy the layout of the code that they read.
    if (programs != "") run("frobc format --check" programs, 0)
    exit failed
}
