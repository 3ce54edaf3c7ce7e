/* blob.h -- finds a bright blob in small pictures, and keeps finding it.
 *
 * A picture is BLOB_HEIGHT rows of BLOB_WIDTH pixels, row after row, each from
 * 0 (black) to 255. Nothing allocates; each instance has its own state.
 *
 * Written for blob_tracker.frob, in whose generated header are the structs and
 * the prototypes; here is what that header needs to know. */
#ifndef BLOB_H
#define BLOB_H

enum { BLOB_WIDTH = 12, BLOB_HEIGHT = 8, BLOB_PIXELS = BLOB_WIDTH * BLOB_HEIGHT };

/* The rectangle to look in at the next step: columns from left to right and
 * rows from top to bottom, both ends included. */
struct blob_state {
    int left, top, right, bottom;
};

#endif
