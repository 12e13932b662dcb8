/* test_drawing.c: drawings on the page show what gnuplot drew: points and lines where they were, to
 * a tenth of a pixel; what nobody sees is left out, and all else is there. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "studies/scoreboard/drawing.h"
#include "tests/check.h"

static const char path[] = "scratch/drawing.svg";

/* The text of a drawing whose canvas holds this. */
static char *shown(const char *inside)
{
    mkdir("scratch", 0777);
    FILE *f = fopen(path, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    fprintf(f,
            "<svg viewBox=\"0 0 933 633\">\n<title>name</title>\n<desc>maker</desc>\n"
            "<g id=\"gnuplot_canvas\">\n<rect width=\"933\" fill=\"#ffffff\"/>\n%s\n</g>\n</svg>\n",
            inside);
    fclose(f);
    char *text = drawing_read(path);
    remove(path);
    CU_ASSERT_PTR_NOT_NULL_FATAL(text);
    return text;
}

static bool shows(const char *inside, const char *text)
{
    char *all = shown(inside);
    const bool found = strstr(all, text) != NULL;
    if (!found) printf("no %s in %s\n", text, all);
    free(all);
    return found;
}

enum { MANY = 200 };

static double place(int k)
{
    return 5 * fmod(61.80339887 * (k + 1), 100);
}

/* The vertices of the first path in relative coordinates; how many. */
static int read_path(const char *text, double x[MANY][2])
{
    const char *s = strstr(text, " d=\"m");
    double at[2] = {0, 0}, step;
    int n = 0, used;
    for (s = s ? s + 4 : ""; n < 2 * MANY; s += used, n++) {
        while (*s == 'm') s++;
        if (sscanf(s, "%lf%n", &step, &used) != 1) break;
        at[n % 2] += step;
        x[n / 2][n % 2] = at[n % 2];
    }
    return n / 2;
}

/* So many points, or vertices of lines, each at its place. */
static void check_places(bool points)
{
    double x[MANY][2];
    char *inside, *text;
    size_t size;
    FILE *f = open_memstream(&inside, &size);
    if (!points) fputs("<path d='", f);
    for (int k = 0; k < MANY; k++)
        if (points)
            fprintf(f,
                    "<use xlink:href='#gpPt6' transform='translate(%.2f,%.2f) scale(1.57)' "
                    "color='rgb(213,  94,   0)'/>\n",
                    place(k), place(k + MANY));
        else
            fprintf(f, " %c%.2f,%.2f", k % 7 ? 'L' : 'M', place(k), place(k + MANY));
    if (!points) fputs(" '/>", f);
    fclose(f);
    text = shown(inside);
    CU_ASSERT_EQUAL(read_path(text, x), MANY);
    for (int k = 0; k < MANY; k++) {
        CU_ASSERT_DOUBLE_EQUAL(x[k][0], place(k), 0.056);
        CU_ASSERT_DOUBLE_EQUAL(x[k][1], place(k + MANY), 0.056);
    }
    free(inside);
    free(text);
}

static void test_places(void)
{
    check_places(false);
    check_places(true);
}

/* Points of another colour are not among those alike; few of them stay as they are. */
static void test_points(void)
{
    static const char red[] =
        "<use xlink:href='#gpPt6' transform='translate(1.00,2.00) scale(2.00)' color='red'/>\n";
    static const char blue[] =
        "<use xlink:href='#gpPt4' transform='translate(9.00,8.00) scale(2.00)' color='blue'/>\n";
    char inside[2048] = "";
    for (int k = 0; k < 6; k++) strcat(inside, red);
    strcat(inside, blue);
    CU_ASSERT(shows(inside, "<use xlink:href=\"%23gpPt6\" transform=\"scale(2.0)\" "
                            "color=\"red\"/></marker>"));
    CU_ASSERT(shows(inside, "style=\"marker:url(%23m0)\" d=\"m1 2 0 0 0 0 0 0 0 0 0 0\"/>"));
    CU_ASSERT(shows(inside, "<use xlink:href=\"%23gpPt4\" transform=\"translate(9.0,8.0) "
                            "scale(2.0)\" color=\"blue\"/>"));
}

static void test_rest(void)
{
    CU_ASSERT(shows("", "fill=\"%23fff\" stroke=\"none\"/>"));
    CU_ASSERT(shows("<path d='M-1,0 h2 M0,-1 v2'/>", "d=\"m-1 0h2M0,-1v2\""));
    CU_ASSERT(shows("<g transform=\"translate(1.26,2.00)\"><text>a &lt; b, 10%</text></g>",
                    "translate(1.2,2.0)\"><text>a &amp;lt; b, 10%25</text></g>"));
    CU_ASSERT(shows("<g fill=\"none\" color=\"black\" stroke=\"red\" stroke-width=\"2.00\">x</g>",
                    "<g color=\"black\" stroke=\"red\" stroke-width=\"2.0\">x</g>"));
    char *text = shown("<g id=\"plot_1\"><title>plot_1</title>\n<g color=\"red\">\n</g></g>");
    CU_ASSERT_PTR_NULL(strstr(text, "title"));
    CU_ASSERT_PTR_NULL(strstr(text, "desc"));
    CU_ASSERT_PTR_NULL(strstr(text, "color"));
    free(text);
    CU_ASSERT_PTR_NULL(drawing_read("scratch/none.svg"));
}

static const TestCase tests[] = {
    {"vertices and points are where they were", test_places},
    {"points alike become markers", test_points},
    {"all else, and nothing unseen", test_rest},
    {NULL, NULL},
};
CHECK_SUITE(tests)
