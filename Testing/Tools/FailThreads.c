/* SPDX-License-Identifier: BSD-3-Clause
 * For LD_PRELOAD: pthread_create fails where the process has MOST_THREADS threads already, as it does
 * where the system gives no more. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>

typedef int (*Create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

static int CountThreads(void)
{
  int count = -2; /* . and .. */
  DIR* tasks = opendir("/proc/self/task");
  while (tasks && readdir(tasks))
  {
    ++count;
  }
  if (tasks)
  {
    closedir(tasks);
  }
  return count;
}

int pthread_create(
  pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* data)
{
  const char* most = getenv("MOST_THREADS");
  if (most && CountThreads() >= atoi(most))
  {
    return EAGAIN;
  }
  return ((Create)dlsym(RTLD_NEXT, "pthread_create"))(thread, attributes, work, data);
}
