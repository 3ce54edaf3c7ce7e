#include "condition.h"

#include "unit.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum operator{
    NUMBER,
    SIGNAL,
    TIME,
    OR,
    AND,
    NOT,
    LESS,
    AT_MOST,
    GREATER,
    AT_LEAST,
    EQUAL,
    UNEQUAL,
    PLUS,
    MINUS,
    TIMES,
    OVER,
    NEGATE,
    ABSOLUTE
};

struct operation {
    enum operator operator;
    double number;
    const double *numbers; /* for a signal: its value at each instant */
    const struct signal *signal;
};

#define DEEPEST 64

struct reader {
    struct condition *condition;
    struct series *series;
    const char *at;
    struct buffer *why;
    unsigned depth, signals;
    bool wrong;
    /* The dimensions of the operands that have not been used yet. */
    struct dimension dimensions[CONDITION_SIZE];
    size_t dimension_count;
};

static void complain(struct reader *r, const char *what, const char *name)
{
    if (!r->wrong)
        buffer_format(r->why, "%s%s%s%s", what, *name != '\0' ? " `" : "", name,
                      *name != '\0' ? "`" : "");
    r->wrong = true;
}

/* Checks the dimensions of the two operands of an operation, by the rules of the language. */
static void match(struct reader *r, enum operator operator, const struct dimension * a,
                  const struct dimension *b)
{
    if (r->wrong || dimensions_match(a, b))
        return;
    buffer_text(r->why, operator== PLUS || operator== MINUS ? "cannot add or subtract "
                                                            : "cannot compare ");
    dimension_write(a, r->why);
    buffer_text(r->why, " and ");
    dimension_write(b, r->why);
    if (a->count > 0 && b->count > 0) {
        buffer_text(r->why, ": their units differ");
    } else {
        buffer_text(r->why, ": write the number with its unit, such as 0.3[");
        dimension_write(a->count > 0 ? a : b, r->why);
        buffer_text(r->why, "]");
    }
    r->wrong = true;
}

/* Replaces the operands' dimensions with the dimension of the operation's result. */
static void measure(struct reader *r, enum operator operator)
{
    static const struct dimension none;
    struct dimension *a, *b;
    if (operator== NEGATE || operator== ABSOLUTE)
        return;
    if (operator== NOT) {
        r->dimensions[r->dimension_count - 1] = none;
        return;
    }
    b = &r->dimensions[--r->dimension_count];
    a = b - 1;
    switch (operator) {
    case TIMES: *a = dimension_product(a, b, 1); return;
    case OVER: *a = dimension_product(a, b, -1); return;
    case PLUS:
    case MINUS:
        match(r, operator, a, b);
        if (a->is_open)
            *a = *b;
        return;
    case OR:
    case AND: *a = none; return;
    default: match(r, operator, a, b); *a = none;
    }
}

static struct operation *add(struct reader *r, enum operator operator, double number)
{
    struct operation *operation = &r->condition->operations[r->condition->count];
    if (r->condition->count + 1 >= CONDITION_SIZE) {
        complain(r, "the condition is too long", "");
        return operation;
    }
    memset(operation, 0, sizeof *operation);
    operation->operator= operator;
    operation->number = number;
    r->condition->count++;
    if (operator== NUMBER || operator== SIGNAL || operator== TIME)
        memset(&r->dimensions[r->dimension_count++], 0, sizeof *r->dimensions);
    else if (!r->wrong)
        measure(r, operator);
    return operation;
}

/* Adds an operand with its dimension. */
static struct operation *add_operand(struct reader *r, enum operator operator, double number,
                                     const struct dimension *dimension)
{
    struct operation *operation = add(r, operator, number);
    if (!r->wrong)
        r->dimensions[r->dimension_count - 1] = *dimension;
    return operation;
}

/* Returns the dimension of a signal. If no unit is listed for an inner signal, its dimension is
 * unknown. */
static struct dimension dimension_of(const struct signal *signal)
{
    struct dimension dimension = { 0 };
    const char *unit = signal->column == NULL ? "" : signal->column->unit;
    double scale;
    if (*unit == '\0')
        dimension.is_open = signal->side == PROBE;
    else if (!unit_read(unit, strlen(unit), true, &dimension, &scale))
        dimension.is_open = true;
    return dimension;
}

static void skip_blanks(struct reader *r)
{
    while (*r->at == ' ')
        r->at++;
}

/* Skips blanks, and reads `symbol` if it comes next. */
static bool take(struct reader *r, const char *symbol)
{
    size_t length = strlen(symbol);
    skip_blanks(r);
    if (strncmp(r->at, symbol, length) != 0)
        return false;
    r->at += length;
    return true;
}

static bool is_of_name(char c)
{
    return isalnum((unsigned char)c) || (c != '\0' && strchr("_'.[]", c) != NULL);
}

/* Reads a name or a keyword. Returns false if there is neither. */
static bool take_name(struct reader *r, char *name, size_t size)
{
    size_t length = 0;
    skip_blanks(r);
    if (!isalpha((unsigned char)*r->at) && *r->at != '_')
        return false;
    while (is_of_name(r->at[length]) && length + 1 < size) {
        name[length] = r->at[length];
        length++;
    }
    name[length] = '\0';
    r->at += length;
    return true;
}

static bool ends_in(const char *whole, const char *name)
{
    size_t length = strlen(whole), end = strlen(name);
    return length > end && whole[length - end - 1] == '.' &&
           strcmp(whole + length - end, name) == 0;
}

/* Returns the only signal whose name ends in `name`, either among the inner signals or among
 * the others. Returns NULL if there is none. Reports an error if there are several. */
static const struct signal *find_end(struct reader *r, const char *name, bool inside)
{
    const struct signals *signals = r->series->replay->signals;
    const struct signal *found = NULL;
    for (size_t i = 0; i < signals->count; i++) {
        const struct signal *signal = &signals->all[i];
        if ((signal->side == PROBE) != inside || !ends_in(signal->name, name))
            continue;
        if (found != NULL) {
            complain(r, "several signals have names that end in", name);
            return NULL;
        }
        found = signal;
    }
    return found;
}

static const struct signal *find(struct reader *r, const char *name)
{
    const struct signal *found = signals_find(r->series->replay->signals, name);
    if (found == NULL)
        found = find_end(r, name, false);
    return found == NULL && !r->wrong ? find_end(r, name, true) : found;
}

/* Returns whether `text` contains `part`, ignoring case. */
static bool contains(const char *text, const char *part)
{
    for (; *text != '\0'; text++) {
        size_t i = 0;
        while (part[i] != '\0' &&
               tolower((unsigned char)text[i]) == tolower((unsigned char)part[i]))
            i++;
        if (part[i] == '\0')
            return true;
    }
    return false;
}

/* Maximum number of similar names in a message. */
#define SIMILAR 3

/* Reports an unknown name, and suggests names that contain it. */
static void unknown(struct reader *r, const char *name)
{
    const struct signals *signals = r->series->replay->signals;
    size_t found = 0;
    if (r->wrong)
        return;
    complain(r, "there is no signal", name);
    for (size_t i = 0; i < signals->count && found < SIMILAR; i++)
        if (contains(signals->all[i].name, name))
            buffer_format(r->why, "%s `%s`", found++ == 0 ? "; similar names:" : ",",
                          signals->all[i].name);
}

static void add_signal(struct reader *r, const char *name)
{
    const struct signal *signal = find(r, name);
    struct operation *operation;
    if (signal == NULL) {
        unknown(r, name);
    } else if ((signal->side == MODE || signal->side == PROBE) && !r->series->replay->runs) {
        complain(r, "the program cannot be run on this recording, so there are no values of", name);
    } else if (++r->signals > SERIES_KEPT / 2) {
        complain(r, "the condition has too many signals", "");
    } else {
        const struct dimension dimension = dimension_of(signal);
        operation = add_operand(r, SIGNAL, 0, &dimension);
        operation->signal = signal;
        operation->numbers = series_of(r->series, signal);
        if (operation->numbers == NULL)
            complain(r, "not enough memory", "");
    }
}

static void read_or(struct reader *r);

static void read_number(struct reader *r)
{
    char *end;
    double number = strtod(r->at, &end);
    struct dimension dimension = { 0 };
    r->at = end;
    if (*r->at == '[') {
        const char *close = strchr(r->at, ']');
        double scale = 0;
        if (close == NULL ||
            !unit_read(r->at + 1, (size_t)(close - r->at - 1), false, &dimension, &scale)) {
            complain(r, "not a unit:", r->at);
            return;
        }
        number *= scale;
        r->at = close + 1;
    } else {
        dimension.is_open = number == 0;
    }
    add_operand(r, NUMBER, number, &dimension);
}

static void read_primary(struct reader *r)
{
    char name[256];
    if (++r->depth > DEEPEST)
        complain(r, "the condition is nested too deeply", "");
    else if (r->wrong)
        ;
    else if (take(r, "(")) {
        read_or(r);
        if (!take(r, ")"))
            complain(r, "a closing parenthesis is missing before", r->at);
    } else if (take(r, "-")) {
        read_primary(r);
        add(r, NEGATE, 0);
    } else if (isdigit((unsigned char)*r->at)) {
        read_number(r);
    } else if (!take_name(r, name, sizeof name)) {
        complain(r,
                 *r->at == '\0' ? "the condition is incomplete" : "the viewer does not understand",
                 r->at);
    } else if (strcmp(name, "True") == 0 || strcmp(name, "False") == 0) {
        add(r, NUMBER, name[0] == 'T');
    } else if (strcmp(name, "time") == 0 &&
               signals_find(r->series->replay->signals, name) == NULL) {
        struct dimension second = { 0 };
        double scale;
        unit_read("s", 1, false, &second, &scale);
        add_operand(r, TIME, 0, &second);
    } else if (strcmp(name, "abs") == 0 || strcmp(name, "not") == 0) {
        read_primary(r);
        add(r, name[0] == 'a' ? ABSOLUTE : NOT, 0);
    } else {
        add_signal(r, name);
    }
    r->depth--;
}

static void read_product(struct reader *r)
{
    read_primary(r);
    while (!r->wrong) {
        skip_blanks(r);
        if (strncmp(r->at, "/=", 2) == 0)
            return;
        if (take(r, "*")) {
            read_primary(r);
            add(r, TIMES, 0);
        } else if (take(r, "/")) {
            read_primary(r);
            add(r, OVER, 0);
        } else {
            return;
        }
    }
}

static void read_sum(struct reader *r)
{
    read_product(r);
    while (!r->wrong) {
        if (take(r, "+")) {
            read_product(r);
            add(r, PLUS, 0);
        } else if (take(r, "-")) {
            read_product(r);
            add(r, MINUS, 0);
        } else {
            return;
        }
    }
}

/* The names of a signal's modes or constructors. */
struct names {
    const struct frob_machine *machine;
    const struct frob_constructor *constructors;
    size_t count;
};

static struct names names_of(const struct reader *r, const struct signal *signal)
{
    const struct frob_program *program = r->series->replay->signals->program;
    struct names names = { NULL, NULL, 0 };
    if (signal->side == MODE) {
        names.machine = &program->machines[signal->machine];
        names.count = names.machine->count;
    } else if (signal->shown->kind == FROB_SUM && !signal->shown->is_event) {
        names.constructors = signal->shown->constructors;
        names.count = signal->shown->count;
    }
    return names;
}

static const char *name_at(const struct names *names, size_t i)
{
    return names->machine != NULL ? names->machine->modes[i] : names->constructors[i].name;
}

/* Reports a name that is neither in `names` nor the name of a signal. */
static void not_one_of(struct reader *r, const struct names *names, const char *name)
{
    complain(r, "there is no mode or value", name);
    for (size_t i = 0; i < names->count; i++)
        buffer_format(r->why, "%s `%s`", i == 0 ? "; it can be" : ",", name_at(names, i));
}

/* If the next token is the name of a mode or constructor of `signal`, reads it, adds its number as
 * an operand, and returns true. */
static bool read_name_of(struct reader *r, const struct signal *signal)
{
    const char *before = r->at;
    const struct names names = names_of(r, signal);
    char name[256];
    if (names.count > 0 && take_name(r, name, sizeof name)) {
        for (size_t i = 0; i < names.count; i++) {
            if (strcmp(name_at(&names, i), name) == 0) {
                add(r, NUMBER, (double)i);
                return true;
            }
        }
        if (find(r, name) == NULL && !r->wrong)
            not_one_of(r, &names, name);
    }
    r->at = before;
    return false;
}

static void read_comparison(struct reader *r)
{
    static const struct {
        const char *symbol;
        enum operator operator;
    } all[] = { { "<=", AT_MOST }, { "<", LESS },   { ">=", AT_LEAST },
                { ">", GREATER },  { "==", EQUAL }, { "/=", UNEQUAL } };
    size_t from = r->condition->count;
    read_sum(r);
    for (size_t i = 0; i < sizeof all / sizeof all[0] && !r->wrong; i++) {
        const struct operation *left = &r->condition->operations[from];
        if (!take(r, all[i].symbol))
            continue;
        if (all[i].operator<EQUAL || r->condition->count != from + 1 ||
            left->operator!= SIGNAL || !read_name_of(r, left->signal))
            read_sum(r);
        add(r, all[i].operator, 0);
        return;
    }
}

static void read_and(struct reader *r)
{
    read_comparison(r);
    while (!r->wrong && take(r, "&&")) {
        read_comparison(r);
        add(r, AND, 0);
    }
}

static void read_or(struct reader *r)
{
    read_and(r);
    while (!r->wrong && take(r, "||")) {
        read_and(r);
        add(r, OR, 0);
    }
}

bool condition_read(struct condition *condition, struct series *series, const char *text,
                    struct buffer *why)
{
    struct reader reader = { .condition = condition, .series = series, .at = text, .why = why };
    condition->count = 0;
    condition->operations =
        (struct operation *)calloc(CONDITION_SIZE, sizeof *condition->operations);
    if (condition->operations == NULL)
        complain(&reader, "not enough memory", "");
    else
        read_or(&reader);
    skip_blanks(&reader);
    if (!reader.wrong && *reader.at == '=')
        complain(&reader, "write `==` to compare, instead of", reader.at);
    else if (!reader.wrong && *reader.at != '\0')
        complain(&reader, "the viewer does not understand", reader.at);
    return !reader.wrong;
}

void condition_free(struct condition *condition)
{
    free(condition->operations);
}

static bool is_true(double x)
{
    return !isnan(x) && x != 0;
}

static double apply(enum operator operator, double x, double y)
{
    bool known = !isnan(x) && !isnan(y);
    switch (operator) {
    case OR: return is_true(x) || is_true(y);
    case AND: return is_true(x) && is_true(y);
    case LESS: return x < y;
    case AT_MOST: return x <= y;
    case GREATER: return x > y;
    case AT_LEAST: return x >= y;
    case EQUAL: return known && !(x < y) && !(x > y);
    case UNEQUAL: return known && (x < y || x > y);
    case PLUS: return x + y;
    case MINUS: return x - y;
    case TIMES: return x * y;
    case OVER: return x / y;
    case NUMBER:
    case SIGNAL:
    case TIME:
    case NOT:
    case NEGATE:
    case ABSOLUTE: break;
    }
    return NAN;
}

bool condition_holds(const struct condition *condition, size_t k, double seconds)
{
    double stack[CONDITION_SIZE];
    size_t top = 0; /* number of values on the stack */
    for (size_t i = 0; i < condition->count; i++) {
        const struct operation *operation = &condition->operations[i];
        switch (operation->operator) {
        case NUMBER: stack[top++] = operation->number; break;
        case SIGNAL: stack[top++] = operation->numbers[k]; break;
        case TIME: stack[top++] = seconds; break;
        case NOT: stack[top - 1] = !is_true(stack[top - 1]); break;
        case NEGATE: stack[top - 1] = -stack[top - 1]; break;
        case ABSOLUTE: stack[top - 1] = fabs(stack[top - 1]); break;
        default: top--; stack[top - 1] = apply(operation->operator, stack[top - 1], stack[top]);
        }
    }
    return is_true(stack[0]);
}
