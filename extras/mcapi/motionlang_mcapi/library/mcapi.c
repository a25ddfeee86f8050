/* The C library MCAPI of motionlang: it transports calls, and gives them no meaning.
 *
 * A stub of stubs.h puts the arguments of a function into an array. leave() writes them as a line, sends it to the board
 * of MCAPI_HOST, and reads the answer into the pointers (docs/mcapi-protocol.md). FUNCTIONS describes the arguments:
 *   h s i W D u w d    number; w is a window          t  text            m  memory, never sent
 *   Sa                 structure a of STRUCTURES      v3 value whose type is argument 3
 *   [d3                array as long as argument 3    b3 text for a buffer as long as argument 3
 *   >                  before a result                ?  before a pointer that may be NULL
 * Each thread in a call has a connection of its own, which is kept for later calls. All of them name this process, because
 * its threads share handles. When a connection breaks, every call answers MCERR_SOCKET until MCOpen.
 *
 * With MCAPI_REAL=PATH a call goes to the library of that path instead. With MCAPI_LOG=FILE every call is written there,
 * with the seconds at its start and end. A library that finds itself in MCAPI_REAL is the real one.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <locale.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef _WIN32
#include <winsock2.h>
#include <ws2tcpip.h>
#include <windows.h>
#include <process.h>
#define getpid _getpid
#define close closesocket
#define MSG_NOSIGNAL 0
#define MCAPI_EXPORT __declspec(dllexport)
static SRWLOCK guard = SRWLOCK_INIT;
#define lock(l) AcquireSRWLockExclusive(l)
#define unlock(l) ReleaseSRWLockExclusive(l)
#define open_library(path) ((void *)LoadLibraryA(path))
#define find_symbol(library, name) ((void *)(intptr_t)GetProcAddress((HMODULE)(library), name))
static double seconds(void)
{
    LARGE_INTEGER now, rate;
    return QueryPerformanceCounter(&now) && QueryPerformanceFrequency(&rate) ? (double)now.QuadPart / (double)rate.QuadPart : 0.0;
}
#else
#include <dlfcn.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>
#define MCAPI_EXPORT __attribute__((visibility("default")))
static pthread_mutex_t guard = PTHREAD_MUTEX_INITIALIZER;
#define lock(l) pthread_mutex_lock(l)
#define unlock(l) pthread_mutex_unlock(l)
#define open_library(path) dlopen(path, RTLD_NOW | RTLD_LOCAL)
#define find_symbol(library, name) dlsym(library, name)
static double seconds(void)
{
    struct timespec now = {0, 0};
    return clock_gettime(CLOCK_MONOTONIC, &now) ? 0.0 : (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
#endif

#include "mcapi.h"

#define MAX_LINE 32768
#define DEFAULT_HOST "127.0.0.1:4410"

typedef union { long long i; double d; const void *p; } item;
typedef struct { const char *name, *result, *arguments; } function;
typedef struct { const char *fields; int older[4]; } structure;
typedef struct { char *text; size_t length, size; int failed; } buffer;
typedef struct connection { struct connection *next; int socket, generation; buffer in; } connection;

static connection *idle;
static int generation, broken, owner, ready, is_real, no_real, counter;
static char token[64];
static void *real_library;
static FILE *log_file;
static double log_start;

static void *enter(int number, double *begin);
static item leave(int number, const item *a, item result, double begin, int was_real);
#include "stubs.h"

static void add(buffer *b, const char *text, size_t length)
{
    if (b->length + length + 1 > b->size) {
        size_t size = 2 * (b->length + length) + 256;
        char *larger = realloc(b->text, size);
        if (!larger) { b->failed = 1; return; }
        b->text = larger;
        b->size = size;
    }
    memcpy(b->text + b->length, text, length);
    b->length += length;
    b->text[b->length] = 0;
}

static void print(buffer *b, const char *format, ...)
{
    char text[80];
    va_list rest;
    va_start(rest, format);
    int length = vsnprintf(text, sizeof text, format, rest);
    va_end(rest);
    add(b, text, (size_t)length);
}

/* A real number with a point, whatever the locale of the host says; it has one to be no integer. */
static void print_real(buffer *b, double number)
{
    char text[40];
    snprintf(text, sizeof text, " %.17g", number);
    char *comma = strstr(text, localeconv()->decimal_point);
    if (comma) *comma = '.';
    if (!strpbrk(text, ".einf")) strcat(text, ".0");
    add(b, text, strlen(text));
}

static void print_text(buffer *b, const char *text)
{
    add(b, " \"", 2);
    for (; *text; text++) {
        unsigned char code = (unsigned char)*text;
        if (code == '"' || code == '\\') print(b, "\\%c", code);
        else if (code >= ' ' && code <= '~' && code != '=') add(b, text, 1);
        else print(b, "\\x%02x", code);
    }
    add(b, "\"", 1);
}

/* The next word of an answer as a number; 0 if there is none. */
static int read_real(char **at, double *number)
{
    char text[64], *end;
    size_t length = strcspn(*at += strspn(*at, " "), " \n");
    if (!length || length >= sizeof text) return 0;
    memcpy(text, *at, length);
    text[length] = 0;
    char *point = strchr(text, '.');
    if (point) *point = *localeconv()->decimal_point;
    *number = strtod(text, &end);
    *at += length;
    return end != text;
}

static int read_whole(char **at, long long *number)
{
    char *start = *at;
    *number = strtoll(start, at, 10);
    return *at != start;
}

/* Copy the next text of an answer to a buffer of `size`, with a zero at its end. */
static void read_text(char **at, char *to, long long size)
{
    long long n = 0;
    *at += strspn(*at, " ");
    if (**at == '"') {
        for (++*at; **at && **at != '"'; ++*at) {
            char code = **at;
            unsigned int hex = 0;
            if (code == '\\') {
                code = *++*at;
                if (code == 'x' && sscanf(*at + 1, "%2x", &hex) == 1) { code = (char)hex; *at += 2; }
                else code = code == 'n' ? '\n' : code == 'r' ? '\r' : code == 't' ? '\t' : code;
            }
            if (n < size - 1) to[n++] = code;
        }
        if (**at) ++*at;
    }
    if (size > 0) to[n] = 0;
}

/* The bytes of a kind in memory; `wide` is false for a MCSTATUSEX whose DWORD has 4 bytes. */
static size_t width(char kind, int wide)
{
    return kind == 'd' ? 8 : kind == 's' || kind == 'W' || kind == 'h' ? 2 : kind == 'D' && wide ? sizeof(DWORD) : 4;
}

static void print_memory(buffer *b, char kind, const void *from, int wide)
{
    union { double d; float f; int16_t s; uint16_t w; int32_t i; uint32_t u; } x;
    memcpy(&x, from, width(kind, wide)); /* the machines that this runs on are little-endian */
    if (kind == 'd' || kind == 'f') print_real(b, kind == 'd' ? x.d : x.f);
    else if (kind == 'u' || kind == 'D' || kind == 'W') print(b, " %u", kind == 'W' ? x.w : x.u);
    else print(b, " %d", kind == 'i' ? x.i : x.s);
}

/* Write the next word of an answer to memory; 0 if there is none. */
static int read_memory(char **at, char kind, void *to, int wide)
{
    item x;
    int real = kind == 'd' || kind == 'f', found = real ? read_real(at, &x.d) : read_whole(at, &x.i);
    float single = found && kind == 'f' ? (float)x.d : 0;
    if (found) memcpy(to, kind == 'f' ? (void *)&single : (void *)&x, width(kind, wide));
    return found;
}

/* The kind in memory of a value by MC_TYPE; 0 for none. */
static char typed(long long type)
{
    return type == MC_TYPE_LONG || type == MC_TYPE_REG ? 'i' : type == MC_TYPE_FLOAT ? 'f' : type == MC_TYPE_DOUBLE ? 'd' : 0;
}

/* How many fields a structure has in its host, and whether its DWORD is wide. Only MCSTATUSEX trusts cbSize: PMC's Python
 * binding sets the size of a Python object, which is 136 up to Python 3.11 and 128 after that. An older, shorter structure
 * is known by its exact size. */
static int fields_of(const structure *s, const void *at, int *wide)
{
    int size = 0, count = (int)strlen(s->fields);
    *wide = 1;
    if (s->fields[0] != 'c') return count;
    memcpy(&size, at, 4);
    if (strchr(s->fields, 'D')) { *wide = !(size == 20 || (size > 100 && size < 200)); return count; }
    for (const int *older = s->older; *older; older++) {
        size_t bytes = 0;
        for (int n = 0; n < *older; n++) bytes += width(s->fields[n], 1);
        if (bytes == (size_t)size) return *older;
    }
    return count;
}

/* Go through the values of a structure: print them, or read them from `at` if it is not NULL. */
static void walk(const structure *s, void *memory, buffer *b, char **at)
{
    int wide, count = fields_of(s, memory, &wide), first = s->fields[0] == 'c';
    size_t offset = 0;
    if (!at) print(b, " %d", count - first);
    for (int n = 0; n < count; n++) {
        size_t size = width(s->fields[n], wide);
        if (size > 2 && offset % 4) offset += 4 - offset % 4;
        if (s->fields[n] != 'c') {
            if (!at) print_memory(b, s->fields[n], (char *)memory + offset, wide);
            else if (!read_memory(at, s->fields[n], (char *)memory + offset, wide)) return;
        }
        offset += size;
    }
}

/* Go through the arguments of a function. Without `answer`, print them as a line; with one, read its results. With
 * `results`, print the results as an answer has them. */
static void arguments(const function *f, const item *a, buffer *b, char *answer, int results)
{
    const char *kind = f->arguments;
    for (int n = 0; *kind; n++) {
        int out = 0;
        for (; *kind == '>' || *kind == '?'; kind++) out |= *kind == '>';
        char type = *kind++, letter = 0;
        if (strchr("S[", type)) letter = *kind++;
        long long size = 0;
        if (strchr("[vb", type)) size = a[*kind++ - '0'].i;
        void *memory = (void *)(intptr_t)a[n].p;
        int plain = strchr("hsiWDuwd", type) && !out;
        if (out != (answer || results)) {
            if (answer || results) continue;
            add(b, memory ? " +" : " -", 2);
        }
        else if (plain && type == 'd') print_real(b, a[n].d);
        else if (plain) print(b, " %lld", a[n].i);
        else if (type == 'm') add(b, memory ? " +" : " -", 2);
        else if (!memory) { if (!out) add(b, " -", 2); }
        else if (type == 't') print_text(b, memory);
        else if (type == 'b') { if (answer) read_text(&answer, memory, size); else if (size > 0) print_text(b, memory); }
        else if (type == 'S') walk(&STRUCTURES[letter - 'a'], memory, b, answer ? &answer : NULL);
        else {
            char of = type == '[' ? letter : type == 'v' ? typed(size) : type;
            long long count = type == '[' ? size : of != 0;
            if (!answer && !out && (type == '[' || !of)) print(b, " %lld", count < 0 ? 0 : count);
            for (long long k = 0; k < count && b->length < MAX_LINE; k++) {
                void *at = (char *)memory + (size_t)k * width(of, 1);
                if (!answer) print_memory(b, of, at, 1);
                else if (!read_memory(&answer, of, at, 1)) break;
            }
        }
    }
}

static int exchange(connection *c, const char *line, size_t length)
{
    char piece[4096];
    int n = 0;
    for (size_t sent = 0; sent < length; sent += (size_t)n) {
        do n = (int)send(c->socket, line + sent, (int)(length - sent), MSG_NOSIGNAL); while (n < 0 && errno == EINTR);
        if (n <= 0) return 0;
    }
    for (c->in.length = 0; !c->in.length || c->in.text[c->in.length - 1] != '\n'; add(&c->in, piece, (size_t)n)) {
        do n = (int)recv(c->socket, piece, sizeof piece, 0); while (n < 0 && errno == EINTR);
        if (n <= 0 || c->in.failed) return 0;
    }
    return c->in.text[0] != '!';
}

static void drop(connection *c)
{
    if (c->socket >= 0) close(c->socket);
    free(c->in.text);
    free(c);
}

/* Connect to MCAPI_HOST and name this process; NULL if that fails. */
static connection *dial(int of)
{
    const char *at = getenv("MCAPI_HOST");
    char host[256], hello[96];
    struct addrinfo wanted = {0}, *found = NULL;
    snprintf(host, sizeof host, "%s", at && *at ? at : DEFAULT_HOST);
    char *port = strrchr(host, ':'), *name = host;
    if (!port) return NULL;
    *port++ = 0;
    if (*name == '[' && port[-2] == ']') { port[-2] = 0; name++; }
    wanted.ai_socktype = SOCK_STREAM;
    if (getaddrinfo(*name ? name : "127.0.0.1", port, &wanted, &found)) return NULL;
    connection *c = calloc(1, sizeof *c);
    int one = 1;
    if (c) {
        c->generation = of;
        c->socket = (int)socket(found->ai_family, found->ai_socktype, found->ai_protocol);
        snprintf(hello, sizeof hello, "Session 1 \"%s\"\n", token);
        if (c->socket < 0 || connect(c->socket, found->ai_addr, (int)found->ai_addrlen)
            || setsockopt(c->socket, IPPROTO_TCP, TCP_NODELAY, (const char *)&one, sizeof one)
            || !exchange(c, hello, strlen(hello))) { drop(c); c = NULL; }
    }
    freeaddrinfo(found);
    return c;
}

/* A connection for this call: an idle one, or a new one. MCOpen begins again after a break; so does a forked process. */
static connection *take(int opens)
{
    lock(&guard);
    if (owner != (int)getpid() || (opens && broken)) {
        for (connection *c; (c = idle) != NULL;) { idle = c->next; drop(c); }
        owner = (int)getpid();
        generation++;
        broken = 0;
        snprintf(token, sizeof token, "%d-%p-%d", owner, (void *)&token, ++counter);
    }
    int of = generation, lost = broken;
    connection *c = idle;
    if (c) idle = c->next;
    unlock(&guard);
    return c || lost ? c : dial(of);
}

static void give(connection *c, int works)
{
    lock(&guard);
    if (works && c->generation == generation && !broken) { c->next = idle; idle = c; c = NULL; }
    else if (!works && (!c || c->generation == generation)) broken = 1;
    unlock(&guard);
    if (c) drop(c);
}

static void start(void)
{
    lock(&guard);
    if (!ready) {
        const char *path = getenv("MCAPI_REAL"), *log = getenv("MCAPI_LOG");
#ifdef _WIN32
        WSADATA data;
        WSAStartup(MAKEWORD(2, 2), &data);
#endif
        if (path && *path) {
            real_library = open_library(path);
            if ((no_real = !real_library)) fprintf(stderr, "mcapi: cannot load %s of MCAPI_REAL\n", path);
            is_real = real_library && find_symbol(real_library, "MCOpen") == (void *)(intptr_t)MCOpen;
            if (is_real) real_library = NULL;
        }
        if (log && *log && !is_real && (log_file = fopen(log, "w")) != NULL) fputs("mcapi-log 1\n", log_file);
        log_start = seconds();
        ready = 1;
    }
    unlock(&guard);
}

/* Begin a call; return the function of the real library, NULL if there is none. */
static void *enter(int number, double *begin)
{
    if (!ready) start();
    *begin = log_file ? seconds() : 0.0;
    return real_library ? find_symbol(real_library, FUNCTIONS[number].name) : NULL;
}

/* End a call: without a real library, carry it out at the board. */
static item leave(int number, const item *a, item result, double begin, int was_real)
{
    const function *f = &FUNCTIONS[number];
    buffer line = {0}, said = {0};
    char none[] = "";
    int opens = !strcmp(f->name, "MCOpen"), code = MCERR_SOCKET, mark = *f->result ? f->result[1] : 0;
    add(&line, f->name, strlen(f->name));
    arguments(f, a, &line, NULL, 0);
    if (!was_real) {
        connection *c = NULL;
        result.i = 0;
        if (no_real) code = MCERR_INIT_DRIVER;
        else if (line.failed || line.length >= MAX_LINE - 1) code = line.failed ? MCERR_OS_ERROR : MCERR_RANGE;
        else if ((c = take(opens)) != NULL) {
            add(&line, "\n", 1);
            int works = exchange(c, line.text, line.length);
            line.text[--line.length] = 0;
            char *answer = works ? c->in.text : none;
            if (read_whole(&answer, &result.i)) code = 0;
            arguments(f, a, &said, answer, 1);
            give(c, works);
        }
        if (code > 0 && opens) result.i = -code;
        else if (code > 0 && (!mark || mark == '!')) result.i = code;
    }
    if (log_file) {
        double end = seconds();
        said.length = 0;
        if (result.i == 0 || mark || !*f->result) arguments(f, a, &said, NULL, 1);
        lock(&guard);
        fprintf(log_file, "%.9f %.9f 1 %s = ", begin - log_start, end - log_start, line.text);
        if (*f->result) fprintf(log_file, "%lld", result.i); else fputc('-', log_file);
        fprintf(log_file, "%s\n", said.length ? said.text : "");
        fflush(log_file);
        unlock(&guard);
    }
    free(line.text);
    free(said.text);
    return result;
}
