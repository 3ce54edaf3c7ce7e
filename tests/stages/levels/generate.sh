# Prints dune rules that run the levels and patterns stages on each program in this folder, and
# compare the typed program with its levels, or the messages, with the expected file next to it.
for program in *.frob; do
    name=${program%.frob}
    cat <<END
(rule
 (deps
  (glob_files %{project_root}/stdlib/*.frob))
 (action
  (with-stdout-to
   $name.typed.now
   (run ../core/elaborate_file.exe typed %{project_root}/stdlib %{dep:$program}))))

(rule
 (alias runtest)
 (action
  (diff $name.typed $name.typed.now)))

END
done
