/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

/* A start of the program takes a quarter of a second of CPU time, in which the
 * dynamic linker relocates two hundred libraries, and the tests start it many
 * times. The fork server is the program itself, stopped in front of
 * main() by a preloaded library (server.c). For each start that a client
 * (client.c) asks for it forks: the child has the libraries at their place, and
 * calls the main() of the program with the arguments, the environment, the
 * working directory and the streams of the client. What the tests see is the
 * program that is built; processes of mpirun and runs with a limit of memory,
 * which have to start by themselves, get it without server.
 *
 * A request is one message: the number of bytes that follow, with the file
 * descriptors 0, 1 and 2 of the client; then strings that end with a zero: the
 * working directory, the number of arguments, the arguments, the environment.
 * The answer is the process number of the child, for signals, and behind its
 * end its status as waitpid() has it. */

#ifndef contact_fork_server_request_h
#define contact_fork_server_request_h

#include <stddef.h>
#include <sys/types.h>
#include <unistd.h>

enum
{
  n_streams = 3
};

/* The whole of n bytes, or 0. */
static inline int transfer(ssize_t (*call)(int, void *, size_t),
                           const int fd,
                           void     *data,
                           size_t    n)
{
  for (char *place = data; n > 0;)
    {
      const ssize_t done = call(fd, place, n);
      if (done <= 0)
        return 0;
      place += done;
      n -= (size_t)done;
    }
  return 1;
}

static ssize_t write_some(const int fd, void *data, const size_t n)
{
  return write(fd, data, n);
}

static ssize_t read_some(const int fd, void *data, const size_t n)
{
  return read(fd, data, n);
}

#endif
