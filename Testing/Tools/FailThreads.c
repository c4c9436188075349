/* SPDX-License-Identifier: BSD-3-Clause
 * For LD_PRELOAD: pthread_create fails from the thread FAIL_THREAD on, counted from 1, as it does
 * where the system gives no more. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

typedef int (*Create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

int pthread_create(
  pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* data)
{
  static atomic_int count;
  const char* first = getenv("FAIL_THREAD");
  if (first && atomic_fetch_add(&count, 1) + 1 >= atoi(first))
  {
    return EAGAIN;
  }
  return ((Create)dlsym(RTLD_NEXT, "pthread_create"))(thread, attributes, work, data);
}
