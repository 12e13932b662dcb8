/* page.h: OUT/index.html: the verdicts and every figure on one page. */
#ifndef MPMLAB_PAGE_H
#define MPMLAB_PAGE_H

#include "studies/engine/claims.h"

int page_write(const Check *claims, const char *dir, Fault *fault);

#endif
