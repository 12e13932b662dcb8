/* phrase.h: short texts made where they are used: names of files and claims, settings of runs. */
#ifndef MPMLAB_PHRASE_H
#define MPMLAB_PHRASE_H

/* The formatted text. It stays as it is for as long as the program runs; nobody frees it. */
const char *phrase(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
