/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

/* The fork server, see request.h: a library to preload into the program, which
 * serves the socket CONTACT_FORK_SERVER until it gets a signal, or no request
 * for long. */

#define _GNU_SOURCE

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>

#include "request.h"

extern char **environ;

typedef int (*main_function)(int, char **, char **);

static main_function program;

enum
{
  seconds_of_rest = 900
};

static char *next_string(char **place)
{
  char *text = *place;
  *place += strlen(text) + 1;
  return text;
}

/* In the child: what main() returns; it has the streams of the client. */
static int run(const int client)
{
  size_t       size;
  struct iovec head = {&size, sizeof size};
  union
  {
    struct cmsghdr alignment;
    char           bytes[CMSG_SPACE(n_streams * sizeof(int))];
  } control;
  struct msghdr message = {.msg_iov        = &head,
                           .msg_iovlen     = 1,
                           .msg_control    = control.bytes,
                           .msg_controllen = sizeof control.bytes};
  int           streams[n_streams];
  if (recvmsg(client, &message, 0) != (ssize_t)sizeof size ||
      CMSG_FIRSTHDR(&message) == NULL)
    return 1;
  memcpy(streams, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof streams);
  char *text = malloc(size), *place = text;
  if (text == NULL || !transfer(read_some, client, text, size))
    return 1;

  const char *directory   = next_string(&place);
  const int   n_arguments = atoi(next_string(&place));
  char      **arguments   = calloc((size_t)n_arguments + 1, sizeof *arguments);
  for (int i = 0; i < n_arguments; ++i)
    arguments[i] = next_string(&place);
  size_t n_variables = 0;
  for (char *rest = place; rest < text + size; ++n_variables)
    next_string(&rest);
  environ = calloc(n_variables + 1, sizeof *environ);
  for (size_t i = 0; i < n_variables; ++i)
    environ[i] = next_string(&place);

  for (int i = 0; i < n_streams; ++i)
    {
      dup2(streams[i], i);
      close(streams[i]);
    }
  if (chdir(directory) != 0)
    {
      perror(directory);
      return 1;
    }
  return program(n_arguments, arguments, environ);
}

/* In the keeper, one for each request: start the child and tell the client how
 * it ends; if the client ends before, so does the child. */
static void keep(const int client)
{
  int end[2]; // closed with the child
  if (pipe2(end, O_CLOEXEC) != 0)
    return;
  pid_t child = fork();
  if (child == 0)
    {
      close(end[0]);
      fcntl(client, F_SETFD, FD_CLOEXEC);
      exit(run(client));
    }
  close(end[1]);
  if (child < 0 || !transfer(write_some, client, &child, sizeof child))
    return;
  struct pollfd events[] = {{end[0], 0, 0}, {client, POLLRDHUP, 0}};
  while (poll(events, 2, -1) < 0)
    ;
  if (events[0].revents == 0)
    kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  transfer(write_some, client, &status, sizeof status);
}

static int serve(int argc, char **argv, char **variables)
{
  (void)argc;
  (void)argv;
  (void)variables;
  const char        *path     = getenv("CONTACT_FORK_SERVER");
  const int          listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  struct sockaddr_un address  = {.sun_family = AF_UNIX};
  strncpy(address.sun_path, path, sizeof address.sun_path - 1);
  unlink(path);
  if (bind(listener, (struct sockaddr *)&address, sizeof address) != 0 ||
      listen(listener, 64) != 0)
    {
      perror(path);
      return 1;
    }
  unsetenv("LD_PRELOAD");
  signal(SIGCHLD, SIG_IGN); // nobody waits for keepers
  struct pollfd request = {listener, POLLIN, 0};
  while (poll(&request, 1, 1000 * seconds_of_rest) != 0)
    {
      const int client = accept4(listener, NULL, NULL, SOCK_CLOEXEC);
      if (client < 0)
        continue;
      if (fork() == 0)
        {
          close(listener);
          signal(SIGCHLD, SIG_DFL);
          signal(SIGPIPE, SIG_IGN);
          keep(client);
          _exit(0);
        }
      close(client);
    }
  unlink(path);
  return 0;
}

/* glibc starts every program here. */
int __libc_start_main(main_function main_of_program,
                      int           argc,
                      char        **argv,
                      main_function init,
                      void (*fini)(void),
                      void (*fini_of_linker)(void),
                      void *stack_end)
{
  int (*start)(main_function,
               int,
               char **,
               main_function,
               void (*)(void),
               void (*)(void),
               void *);
  *(void **)&start = dlsym(RTLD_NEXT, "__libc_start_main");
  program          = main_of_program;
  return start(getenv("CONTACT_FORK_SERVER") != NULL ? serve : main_of_program,
               argc,
               argv,
               init,
               fini,
               fini_of_linker,
               stack_end);
}
