/* answer.h -- parses HTTP addresses, and the head of a server's response (RFC 9112). No I/O. */
#ifndef FROB_HOST_CAMERA_ANSWER_H
#define FROB_HOST_CAMERA_ANSWER_H

#include <stdbool.h>
#include <stddef.h>

struct address {
    char host[256], port[8];
    const char *path; /* points into the parsed text; "" for "/" */
};

/* Parses http://HOST[:PORT][/PATH]; HOST may be an IPv6 address in brackets. */
bool address_read(struct address *address, const char *text);

enum { ANSWER_ROOM = 16384 }; /* a response with a longer head is rejected */

struct answer {
    int status;
    bool is_chunked;
    char type[64]; /* lower-case media type without parameters; "" if not given */
};

enum answer_result { ANSWER_MORE, ANSWER_GOOD, ANSWER_WRONG };

/* Parses the head and computes its length. */
enum answer_result answer_read(struct answer *answer, const char *bytes, size_t size,
                               size_t *length);

#endif
