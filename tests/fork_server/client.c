/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

/* A client of the fork server, see request.h: it takes the place of the program
 * in the tests, and the program its place where there is no server, as a
 * process of mpirun, and with a limit of memory. PROGRAM and SOCKET are their
 * paths. */

#define _GNU_SOURCE

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>

#include "request.h"

extern char **environ;

static pid_t child;

static void forward(const int signal_number)
{
  kill(child, signal_number);
}

static int connect_to_server(void)
{
  struct rlimit memory;
  if (getenv("OMPI_COMM_WORLD_SIZE") != NULL ||
      getrlimit(RLIMIT_AS, &memory) != 0 || memory.rlim_cur != RLIM_INFINITY)
    return -1;
  const int          server  = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  struct sockaddr_un address = {.sun_family = AF_UNIX, .sun_path = SOCKET};
  return connect(server, (struct sockaddr *)&address, sizeof address) == 0
           ? server
           : -1;
}

static void put(FILE *text, const char *string)
{
  fwrite(string, strlen(string) + 1, 1, text);
}

static int ask(const int server, const int argc, char **argv)
{
  char  *text = NULL, *directory = getcwd(NULL, 0), number[16];
  size_t size   = 0;
  FILE  *stream = open_memstream(&text, &size);
  if (stream == NULL || directory == NULL)
    return 0;
  snprintf(number, sizeof number, "%d", argc);
  put(stream, directory);
  put(stream, number);
  for (int i = 0; i < argc; ++i)
    put(stream, argv[i]);
  for (char **variable = environ; *variable != NULL; ++variable)
    put(stream, *variable);
  fclose(stream);

  const int    streams[n_streams] = {0, 1, 2};
  struct iovec head               = {&size, sizeof size};
  union
  {
    struct cmsghdr alignment;
    char           bytes[CMSG_SPACE(sizeof streams)];
  } control;
  struct msghdr   message = {.msg_iov        = &head,
                             .msg_iovlen     = 1,
                             .msg_control    = control.bytes,
                             .msg_controllen = sizeof control.bytes};
  struct cmsghdr *with    = CMSG_FIRSTHDR(&message);
  with->cmsg_level        = SOL_SOCKET;
  with->cmsg_type         = SCM_RIGHTS;
  with->cmsg_len          = CMSG_LEN(sizeof streams);
  memcpy(CMSG_DATA(with), streams, sizeof streams);
  return sendmsg(server, &message, 0) == (ssize_t)sizeof size &&
         transfer(write_some, server, text, size);
}

int main(int argc, char **argv)
{
  const int server = connect_to_server();
  if (server < 0)
    {
      argv[0] = (char *)PROGRAM;
      execv(PROGRAM, argv);
      perror(PROGRAM);
      return 127;
    }
  int status = 0;
  if (!ask(server, argc, argv) ||
      !transfer(read_some, server, &child, sizeof child))
    {
      perror(SOCKET);
      return 127;
    }
  signal(SIGINT, forward);
  signal(SIGTERM, forward);
  signal(SIGHUP, forward);
  if (!transfer(read_some, server, &status, sizeof status))
    {
      perror(SOCKET);
      return 127;
    }
  if (WIFSIGNALED(status))
    {
      signal(WTERMSIG(status), SIG_DFL);
      raise(WTERMSIG(status));
    }
  return WEXITSTATUS(status);
}
