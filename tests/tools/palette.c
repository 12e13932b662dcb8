/* palette.c: prints the methods' labels, colours and markers for gnuplot (palette.h), for the
 * figures of the bench, which no study draws. */
#include "studies/engine/palette.h"

int main(void)
{
    palette_put(stdout);
    return 0;
}
