/* browser.h -- opening an address in the user's browser. */
#ifndef FROB_VIEW_BROWSER_H
#define FROB_VIEW_BROWSER_H

/* Opens an address if there is a desktop, and says nothing if there is none. The
 * address goes through a file that only the user can read, for a command line can be
 * seen by everybody on the computer. */
void browser_open(const char *address);

/* Takes the file away again. */
void browser_forget(void);

#endif
