/* fuzz_tools.c: bytes as texts and as files. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "fuzz.h"

char *fuzz_text(const unsigned char *data, size_t n)
{
    char *text = malloc(n + 1);
    if (!text) abort();
    if (n) memcpy(text, data, n);
    text[n] = '\0';
    return text;
}

const char *fuzz_file(const unsigned char *data, size_t n)
{
    static char path[64];
    snprintf(path, sizeof path, "fuzz.%d.scratch", (int)getpid());
    int fd = open(path, O_CREAT | O_TRUNC | O_WRONLY, 0666);
    if (fd < 0 || write(fd, data, n) != (ssize_t)n || close(fd) != 0) abort();
    return path;
}

char *fuzz_read(const char *path, size_t *n)
{
    FILE *f = fopen(path, "r");
    if (!f || fseek(f, 0, SEEK_END) != 0) abort();
    long size = ftell(f);
    char *text = malloc((size_t)size + 1);
    if (!text) abort();
    rewind(f);
    *n = fread(text, 1, (size_t)size, f);
    text[*n] = '\0';
    fclose(f);
    return text;
}

int fuzz_split(char *text, char separator, char *words[], int max)
{
    int n = 0;
    while (text && n < max) {
        words[n++] = text;
        text = strchr(text, separator);
        if (text) *text++ = '\0';
    }
    return n;
}
