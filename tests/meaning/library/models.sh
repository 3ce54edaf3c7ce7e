# models MODEL [steady]: runs MODEL.frob in both engines and both precisions of Float on an input of
# 400 instants, and compares the outputs with the model in control_models.py. The engines must agree
# bit for bit.
models() {
    python3 control_models.py "${2:-input}" 7 >input.csv
    for real in double float; do
        for engine in c interp; do
            frobc trace --real $real --engine $engine "$1.frob" --input input.csv --output $real.$engine.csv 2>&1 |
                grep -v '^NaN: '
        done
        cmp $real.c.csv $real.interp.csv
    done
    python3 control_models.py "$1" input.csv double.c.csv float.c.csv
}
