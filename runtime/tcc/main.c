/* frob-tcc -- the C compiler that frobc uses if no other is installed.
 *
 * It is a driver for libtcc that accepts the options that frobc passes to gcc. It does not need
 * the files of a C development environment: it uses Frob's own headers (share/frobc/tcc/include)
 * and, instead of the development files of the C library, the libraries that its own process has
 * loaded.
 *
 *     frob-tcc [-c | -shared] [-I FOLDER] [-D NAME[=VALUE]] -o RESULT FILE... [-lm]
 *
 * libtcc neither contracts nor reorders floating-point operations, and computes with the SSE
 * registers, so frob-tcc ignores the options that control this. It also ignores optimization
 * options. */
#define _GNU_SOURCE
#include <libtcc.h>

#include <dlfcn.h>
#include <link.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LONGEST_PATH = 4096 };

/* The startup code, which a linker usually takes from crt1.o. glibc before 2.34 expects functions
 * for initialization and termination here, but accepts null pointers. */
static const char start[] =
    "int main(int, char **, char **);\n"
    "int __libc_start_main(int (*)(int, char **, char **), int, char **, void (*)(void),\n"
    "                      void (*)(void), void (*)(void), void *);\n"
    "void frob_tcc_start(long *stack)\n"
    "{\n"
    "    __libc_start_main(main, (int)stack[0], (char **)(stack + 1), 0, 0, 0, stack);\n"
    "}\n"
    "__asm__(\".globl _start\\n\"\n"
    "        \"_start:\\n\"\n"
    "        \"xorl %ebp, %ebp\\n\"\n"
    "        \"movq %rsp, %rdi\\n\"\n"
    "        \"andq $-16, %rsp\\n\"\n"
    "        \"call frob_tcc_start\\n\");\n";

/* tcc 0.9.27 generates wrong code for other processors: on 64-bit ARM, it passes structs
 * incorrectly, and shared objects contain addresses that are not relocated when they are loaded. */
#ifdef __x86_64__
static const bool is_supported = true;
#else
static const bool is_supported = false;
#endif

static void print_message(void *unused, const char *message)
{
    (void)unused;
    fprintf(stderr, "%s\n", message);
}

static void fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("frob-tcc: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

/* Sets `path` to the path of `below` in the installation folder, which is PREFIX if this program is
 * PREFIX/lib/frobc/frob-tcc. During a build, this program is BUILD/default/runtime/tcc/frob-tcc,
 * and the installation is in BUILD/install/default. */
static void installed(char path[static LONGEST_PATH], const char *below)
{
    static const char *const places[] = { "", "/../install/default" };
    char self[LONGEST_PATH];
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length < 0)
        fail("cannot find itself: is /proc mounted?");
    self[length] = '\0';
    for (int up = 0; up < 3; up++) {
        char *slash = strrchr(self, '/');
        if (slash == NULL)
            fail("is not installed in a folder lib/frobc: reinstall frobc");
        *slash = '\0';
    }
    for (size_t k = 0; k < sizeof places / sizeof places[0]; k++) {
        if (snprintf(path, LONGEST_PATH, "%s%s/%s", self, places[k], below) >= LONGEST_PATH)
            fail("the path of its installation folder is too long");
        if (access(path, R_OK) == 0)
            return;
    }
    fail("%s is missing: reinstall frobc", below);
}

static int add_loaded(struct dl_phdr_info *info, size_t size, void *compiler)
{
    const char *slash = strrchr(info->dlpi_name, '/');
    (void)size;
    if (slash != NULL && (strncmp(slash, "/libc.so", 8) == 0 || strncmp(slash, "/libm.so", 8) == 0))
        return tcc_add_file(compiler, info->dlpi_name) < 0;
    return 0;
}

/* Links with the C library and the math library that this process has loaded. */
static bool link_system(TCCState *compiler)
{
    char own[LONGEST_PATH];
    installed(own, "lib/frobc/libtcc1.a");
    return tcc_add_file(compiler, own) == 0 && dl_iterate_phdr(add_loaded, compiler) == 0;
}

/* Adds a program header that says that the shared object does not need an executable stack. libtcc
 * does not write this header, and glibc 2.41 and later do not load objects without it. Moves the
 * table of program headers to the end of the file, where there is room for one more. */
static bool mark_stack(const char *path)
{
    FILE *file = fopen(path, "r+b");
    Elf64_Ehdr header;
    Elf64_Phdr segments[16] = { 0 };
    const Elf64_Phdr stack = { .p_type = PT_GNU_STACK, .p_flags = PF_R | PF_W, .p_align = 16 };
    bool done = file != NULL && fread(&header, sizeof header, 1, file) == 1 &&
                header.e_phentsize == sizeof segments[0] &&
                header.e_phnum < sizeof segments / sizeof segments[0] &&
                fseek(file, (long)header.e_phoff, SEEK_SET) == 0 &&
                fread(segments, sizeof segments[0], header.e_phnum, file) == header.e_phnum &&
                fseek(file, 0, SEEK_END) == 0;
    if (done) {
        const long end = ftell(file);
        static const char zeros[8] = { 0 };
        const size_t gap = (size_t)(-end & 7);
        segments[header.e_phnum++] = stack;
        header.e_phoff = (Elf64_Off)end + gap;
        done = end > 0 && fwrite(zeros, 1, gap, file) == gap &&
               fwrite(segments, sizeof segments[0], header.e_phnum, file) == header.e_phnum &&
               fseek(file, 0, SEEK_SET) == 0 && fwrite(&header, sizeof header, 1, file) == 1;
    }
    if (file != NULL && fclose(file) != 0)
        done = false;
    if (!done)
        fprintf(stderr, "frob-tcc: cannot write %s\n", path);
    return done;
}

static bool starts_with(const char *text, const char *start_)
{
    return strncmp(text, start_, strlen(start_)) == 0;
}

/* Returns whether frob-tcc ignores an option. */
static bool is_ignored(const char *option)
{
    static const char *const beginnings[] = { "-O", "-std=", "-f", "-W", "-g" };
    if (strcmp(option, "-ffast-math") == 0)
        return false;
    for (size_t k = 0; k < sizeof beginnings / sizeof beginnings[0]; k++)
        if (starts_with(option, beginnings[k]))
            return true;
    return strcmp(option, "-lm") == 0;
}

static void define(TCCState *compiler, char *definition)
{
    char *equals = strchr(definition, '=');
    if (equals != NULL)
        *equals = '\0';
    tcc_define_symbol(compiler, definition, equals == NULL ? "1" : equals + 1);
}

/* Returns the part of an option after its first two characters or, if there is none, the next
 * argument. */
static char *value(int argc, char **argv, int *k)
{
    char *option = argv[*k];
    if (option[2] != '\0')
        return option + 2;
    if (*k + 1 >= argc)
        fail("the option %s needs a value", option);
    return argv[++*k];
}

int main(int argc, char **argv)
{
    TCCState *compiler = tcc_new();
    const char *result = NULL;
    int type = TCC_OUTPUT_EXE;
    int files = 0;
    char own[LONGEST_PATH];
    if (!is_supported)
        fail("does not work on this processor: install another C compiler, such as gcc");
    if (compiler == NULL)
        fail("out of memory");
    tcc_set_error_func(compiler, NULL, print_message);
    tcc_set_options(compiler, "-nostdinc -nostdlib -Werror");
    for (int k = 1; k < argc; k++) {
        if (strcmp(argv[k], "-shared") == 0)
            type = TCC_OUTPUT_DLL;
        else if (strcmp(argv[k], "-c") == 0)
            type = TCC_OUTPUT_OBJ;
    }
    tcc_set_output_type(compiler, type);
    for (int k = 1; k < argc; k++) {
        if (starts_with(argv[k], "-I"))
            tcc_add_include_path(compiler, value(argc, argv, &k));
        else if (starts_with(argv[k], "-D"))
            define(compiler, value(argc, argv, &k));
        else if (starts_with(argv[k], "-o"))
            result = value(argc, argv, &k);
        else if (strcmp(argv[k], "-shared") == 0 || strcmp(argv[k], "-c") == 0)
            continue;
        else if (argv[k][0] == '-' && !is_ignored(argv[k]))
            fail("the option %s is not supported", argv[k]);
        else
            files += argv[k][0] != '-';
    }
    if (result == NULL || files == 0)
        fail("usage: frob-tcc [-c | -shared] [-I FOLDER] [-D NAME[=VALUE]] -o RESULT FILE...");
    installed(own, "share/frobc/tcc/include");
    tcc_add_sysinclude_path(compiler, own);
    /* The startup code comes first, because it calls main, which may be in an archive. */
    if (type == TCC_OUTPUT_EXE && tcc_compile_string(compiler, start) < 0)
        return 1;
    for (int k = 1; k < argc; k++) {
        bool has_value =
            strcmp(argv[k], "-I") == 0 || strcmp(argv[k], "-D") == 0 || strcmp(argv[k], "-o") == 0;
        if (has_value)
            k++;
        else if (argv[k][0] != '-' && tcc_add_file(compiler, argv[k]) < 0)
            return 1;
    }
    if (type != TCC_OUTPUT_OBJ && !link_system(compiler))
        return 1;
    if (tcc_output_file(compiler, result) < 0)
        return 1;
    return type == TCC_OUTPUT_DLL && !mark_stack(result);
}
