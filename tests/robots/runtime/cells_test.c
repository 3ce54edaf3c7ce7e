/* Tests cells of traces: a written cell reads back unchanged, and an invalid one is rejected
 * with a message that says what was expected. */
#include <frob/cell.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures;

static void check(const char *name, bool ok)
{
    printf("%s %s\n", ok ? "ok" : "FAIL", name);
    failures += !ok;
}

/* data Side = LeftSide | At Float | Both (Float, Int) | Box Pose; and an event of it */
struct values {
    double f;
    int32_t i;
    uint8_t tag;
    double f0;
    int32_t i0;
    bool b0;
    float s;
};

#define AT(member) offsetof(struct values, member)
static const struct frob_value f = { FROB_FLOAT, AT(f), 0, 0, NULL };
static const struct frob_value s = { FROB_SINGLE, AT(s), 0, 0, NULL };
static const struct frob_value rounded = { FROB_ROUNDED, AT(f), 0, 0, NULL };
static const struct frob_value i = { FROB_INT, AT(i), 0, 0, NULL };
static const struct frob_value f0 = { FROB_FLOAT, AT(f0), 0, 0, NULL };
static const struct frob_value i0 = { FROB_INT, AT(i0), 0, 0, NULL };
static const struct frob_value b0 = { FROB_BOOL, AT(b0), 0, 0, NULL };
static const struct frob_field pair_fields[] = { { NULL, &f0 }, { NULL, &i0 } };
static const struct frob_constructor pair_constructor = { NULL, 0, 2, pair_fields };
static const struct frob_value pair = { FROB_PRODUCT, 0, 0, 1, &pair_constructor };
static const struct frob_field pose_fields[] = { { "x", &f0 }, { "ok", &b0 } };
static const struct frob_constructor pose_constructor = { "Pose", 1, 2, pose_fields };
static const struct frob_value pose = { FROB_PRODUCT, 0, 0, 1, &pose_constructor };
static const struct frob_field at_fields[] = { { NULL, &f0 } };
static const struct frob_field both_fields[] = { { NULL, &pair }, { NULL, &b0 } };
static const struct frob_field box_fields[] = { { NULL, &pose } };
static const struct frob_constructor side_constructors[] = {
    { "LeftSide", 0, 0, NULL },
    { "At", 0, 1, at_fields },
    { "Both", 0, 2, both_fields },
    { "Box", 0, 1, box_fields },
};
static const struct frob_value side = { FROB_SUM, AT(tag), 0, 4, side_constructors };
static const struct frob_constructor event_constructors[] = {
    { "NoEvent", 0, 0, NULL },
    { "Event", 0, 1, at_fields },
};
static const struct frob_value event = { FROB_SUM, AT(tag), 1, 2, event_constructors };

/* Checks that the cell is valid and is written back as `again`. */
static void round_trip(const struct frob_value *value, const char *cell, const char *again)
{
    struct values v;
    char buffer[200];
    struct frob_cell_error error;
    struct frob_text text = frob_text_in(buffer, sizeof buffer);
    memset(&v, 0, sizeof v);
    if (frob_cell_read(cell, value, &v, NULL, &error))
        frob_cell_write(&text, value, &v);
    else
        frob_text_add(&text, error.expected);
    if (strcmp(buffer, again) != 0)
        printf("  %s -> %s, not %s\n", cell, buffer, again);
    check(cell, strcmp(buffer, again) == 0);
}

static void refused(const struct frob_value *value, const char *cell, size_t position,
                    const char *expected)
{
    struct values v;
    struct frob_cell_error error = { 0, "", NULL };
    bool read = frob_cell_read(cell, value, &v, NULL, &error);
    if (read || error.position != position || strcmp(error.expected, expected) != 0)
        printf("  %s: %d, at %lu, expected %s\n", cell, read, (unsigned long)error.position,
               error.expected);
    check(cell, !read && error.position == position && strcmp(error.expected, expected) == 0);
    /* for a constructor, a host can list the names */
    check(cell, (error.choice != NULL) == (strstr(expected, "a constructor") != NULL));
}

int main(void)
{
    struct values v;
    struct frob_cell_error error;
    round_trip(&f, "0.1", "0.10000000000000001");
    round_trip(&f, " -2.5e3 ", "-2500");
    round_trip(&f, "-inf", "-inf");
    round_trip(&f, "-nan", "nan");
    round_trip(&f, "(3)", "3");
    round_trip(&f, "-0.0", "-0");
    round_trip(&s, "0.1", "0.1");
    round_trip(&s, "0.10000000149011612", "0.1");
    round_trip(&s, "0.10000001", "0.10000001");
    round_trip(&s, "16777217", "16777216");
    round_trip(&s, "16777219", "1.677722e+07");
    round_trip(&s, "123456789", "1.2345679e+08");
    round_trip(&s, "1e-45", "1e-45");
    round_trip(&s, "3.4028235e38", "3.4028235e+38");
    round_trip(&s, "-3.4028235e38", "-3.4028235e+38");
    round_trip(&s, "1e-400", "0");
    refused(&s, "1e39", 0, "a number up to 3.4e38, or `inf`");
    refused(&rounded, "-1e39", 0, "a number up to 3.4e38, or `inf`");
    refused(&f, " 1e400", 1, "a number up to 1.79e308, or `inf`");
    refused(&f, "-1e400", 0, "a number up to 1.79e308, or `inf`");
    round_trip(&f, "1e308", "1e+308");
    round_trip(&f, "1e-400", "0");
    round_trip(&f, "INF", "inf");
    round_trip(&f, "-Infinity", "-inf");
    round_trip(&s, "-0.0", "-0");
    round_trip(&s, "nan", "nan");
    round_trip(&rounded, "0.1", "0.1");
    round_trip(&rounded, "16777217", "16777216");
    round_trip(&i, "-2147483648", "-2147483648");
    round_trip(&side, "LeftSide", "LeftSide");
    round_trip(&side, "At (-0.5)", "At (-0.5)");
    round_trip(&side, "At -0.5", "At (-0.5)");
    round_trip(&side, "((At 2))", "At 2");
    round_trip(&side, "Both (1.5,-2) True", "Both (1.5, -2) true");
    round_trip(&side, "Box Pose {ok = true, x = -1}", "Box Pose {x = -1, ok = true}");
    round_trip(&side, "Box (Pose {x=1,ok=false})", "Box Pose {x = 1, ok = false}");
    round_trip(&event, "", "");
    round_trip(&event, "-1.5", "-1.5");
    refused(&f, "fast", 0, "a number");
    refused(&f, "1.5 m", 4, "nothing after the number");
    refused(&f, "0x10", 0, "a number");
    refused(&f, "infinite", 0, "a number");
    refused(&f, "", 0, "a number");
    refused(&i, "2.0", 0, "an integer from -2147483648 to 2147483647");
    refused(&i, "2147483648", 0, "an integer from -2147483648 to 2147483647");
    refused(&side, "Atlantis", 0, "a constructor of the column's type");
    refused(&side, "At", 2, "a number");
    refused(&side, "Both (1", 7, "`,` and the tuple's next component");
    refused(&side, "Box Pose {x = 1, x = 2}", 17, "a field of the record that has no value yet");
    refused(&side, "(At 2", 5, "`)`");
    memset(&v, 0x55, sizeof v);
    check("slots that a constructor does not use are zero",
          frob_cell_read("LeftSide", &side, &v, NULL, &error) && v.f0 == 0 && v.i0 == 0 && !v.b0);
    return failures != 0;
}
