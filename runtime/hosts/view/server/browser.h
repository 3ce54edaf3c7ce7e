/* browser.h -- opens an address in the user's browser. */
#ifndef FROB_VIEW_BROWSER_H
#define FROB_VIEW_BROWSER_H

/* Opens an address if there is a desktop; otherwise does nothing. The address is passed in a file
 * that only the user can read, because every user of the computer can see command lines. */
void browser_open(const char *address);

/* Removes the file with the address. */
void browser_forget(void);

#endif
