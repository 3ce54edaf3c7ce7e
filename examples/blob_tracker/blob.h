/* blob.h -- finds a bright blob in small pictures and tracks it.
 *
 * A picture is stored row by row: BLOB_HEIGHT rows of BLOB_WIDTH pixels. A pixel is a number from 0
 * (black) to 255. The functions do not allocate memory; each instance has its own state.
 *
 * This code is for blob_tracker.frob, whose generated header declares the structs and the
 * functions; this header contains the definitions that the generated one needs. */
#ifndef BLOB_H
#define BLOB_H

enum { BLOB_WIDTH = 12, BLOB_HEIGHT = 8, BLOB_PIXELS = BLOB_WIDTH * BLOB_HEIGHT };

/* The rectangle to search in the next step: columns from left to right and rows from top to
 * bottom, both ends included. */
struct blob_state {
    int left, top, right, bottom;
};

#endif
