# Prints frobc's options for the OpenCV libraries that camshift.cc needs. If they are not installed,
# prints nothing and exits with status 1.
for library in core imgproc video; do
  path=$(gcc -print-file-name=libopencv_$library.so)
  [ -e "$path" ] || exit 1
  echo "--with $path"
done
