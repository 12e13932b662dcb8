/* manual.h: one text about the program, as help, as a manual page and as completion for bash. */
#ifndef MPMLAB_MANUAL_H
#define MPMLAB_MANUAL_H

#include "cli.h"

void manual_help(const Command *const commands[], int n);
void manual_command(const Command *c);
void manual_page(const Command *const commands[], int n);
void manual_completion(const Command *const commands[], int n);
void manual_version(void);

#endif
