# The rules that compare what levels and patterns make of each program here,
# the typed program with its levels or messages, with the file beside it.
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
