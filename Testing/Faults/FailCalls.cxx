// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a program (LD_PRELOAD), this library makes one chosen system call fail: see
// FaultPlan.h. Works only on Linux with the GNU C library.
#include "CallLog.h"
#include "FaultPlan.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>

#include <dirent.h>
#include <dlfcn.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/types.h>
#include <sys/uio.h>

using skyline::testing::Call;
using skyline::testing::Fault;
using skyline::testing::LogCall;
using skyline::testing::Next;
using skyline::testing::NextAllocation;

namespace
{

template <typename Function>
Function* Original(const char* name)
{
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

// Defines the function `name` of the C library. The compiler sees it under another name, because
// system headers declare it in different ways. Inside it, `next` is the function of the C library.
#define SKYLINE_INSTEAD_OF(result, name, parameters)                                               \
  extern "C" __attribute__((visibility("default")))                                                \
  result Skyline_##name parameters __asm__(#name);                                                 \
  result Skyline_##name parameters

#define SKYLINE_NEXT(result, name, parameters)                                                     \
  static auto* const next = Original<result parameters>(#name)

// The arguments of a call come in their parentheses: NOLINTBEGIN(bugprone-macro-parentheses)
#define SKYLINE_FAIL(kind, result, failure, name, parameters, arguments)                           \
  SKYLINE_INSTEAD_OF(result, name, parameters)                                                     \
  {                                                                                                \
    SKYLINE_NEXT(result, name, parameters);                                                        \
    return Next(Call::kind) == Fault::None ? next arguments : failure;                             \
  }

// Functions that open a file; the path is logged. On Linux a third parameter can stand for the
// variable arguments.
#define SKYLINE_FAIL_OPEN(result, failure, name, parameters, arguments)                            \
  SKYLINE_INSTEAD_OF(result, name, parameters)                                                     \
  {                                                                                                \
    SKYLINE_NEXT(result, name, parameters);                                                        \
    LogCall("open", path);                                                                         \
    return Next(Call::Open) == Fault::None ? next arguments : failure;                             \
  }

SKYLINE_FAIL_OPEN(int, -1, open, (const char* path, int flags, mode_t mode), (path, flags, mode))
SKYLINE_FAIL_OPEN(int, -1, open64, (const char* path, int flags, mode_t mode), (path, flags, mode))
SKYLINE_FAIL_OPEN(int, -1, openat, (int folder, const char* path, int flags, mode_t mode),
  (folder, path, flags, mode))
SKYLINE_FAIL_OPEN(int, -1, openat64, (int folder, const char* path, int flags, mode_t mode),
  (folder, path, flags, mode))
SKYLINE_FAIL_OPEN(int, -1, __open_2, (const char* path, int flags), (path, flags))
SKYLINE_FAIL_OPEN(int, -1, __open64_2, (const char* path, int flags), (path, flags))
SKYLINE_FAIL_OPEN(FILE*, nullptr, fopen, (const char* path, const char* mode), (path, mode))
SKYLINE_FAIL_OPEN(FILE*, nullptr, fopen64, (const char* path, const char* mode), (path, mode))
SKYLINE_FAIL(Open, FILE*, nullptr, fdopen, (int file, const char* mode), (file, mode))

// Reading and writing can also stop half way.
#define SKYLINE_FAIL_PART(kind, name, parameters, whole, half)                                     \
  SKYLINE_INSTEAD_OF(ssize_t, name, parameters)                                                    \
  {                                                                                                \
    SKYLINE_NEXT(ssize_t, name, parameters);                                                       \
    const Fault fault = Next(Call::kind);                                                          \
    const std::size_t part = count > 1 ? count / 2 : count;                                        \
    return fault == Fault::None ? next whole : fault == Fault::Short ? next half : -1;             \
  }

SKYLINE_FAIL_PART(
  Read, read, (int file, void* bytes, std::size_t count), (file, bytes, count), (file, bytes, part))
SKYLINE_FAIL_PART(Read, pread, (int file, void* bytes, std::size_t count, off_t place),
  (file, bytes, count, place), (file, bytes, part, place))
SKYLINE_FAIL_PART(Read, pread64, (int file, void* bytes, std::size_t count, off_t place),
  (file, bytes, count, place), (file, bytes, part, place))
SKYLINE_FAIL_PART(Write, write, (int file, const void* bytes, std::size_t count),
  (file, bytes, count), (file, bytes, part))
SKYLINE_FAIL_PART(Write, pwrite, (int file, const void* bytes, std::size_t count, off_t place),
  (file, bytes, count, place), (file, bytes, part, place))
SKYLINE_FAIL_PART(Write, pwrite64, (int file, const void* bytes, std::size_t count, off_t place),
  (file, bytes, count, place), (file, bytes, part, place))
SKYLINE_FAIL(
  Write, ssize_t, -1, writev, (int file, const iovec* parts, int count), (file, parts, count))
SKYLINE_FAIL(Write, ssize_t, -1, sendfile, (int to, int from, off_t* place, std::size_t count),
  (to, from, place, count))
SKYLINE_FAIL(Write, ssize_t, -1, copy_file_range,
  (int from, off_t* place, int to, off_t* target, std::size_t count, unsigned int flags),
  (from, place, to, target, count, flags))

// Functions that buffer. They report the error at once, whether or not the data have reached the
// file.
SKYLINE_FAIL(Read, std::size_t, 0, fread,
  (void* bytes, std::size_t size, std::size_t count, FILE* file), (bytes, size, count, file))
SKYLINE_FAIL(Write, std::size_t, 0, fwrite,
  (const void* bytes, std::size_t size, std::size_t count, FILE* file), (bytes, size, count, file))
SKYLINE_FAIL(Write, int, EOF, fflush, (FILE * file), (file))

// If closing a file fails, the file is closed nevertheless.
#define SKYLINE_FAIL_CLOSE(name, failure, parameters, arguments)                                   \
  SKYLINE_INSTEAD_OF(int, name, parameters)                                                        \
  {                                                                                                \
    SKYLINE_NEXT(int, name, parameters);                                                           \
    const Fault fault = Next(Call::Close);                                                         \
    const int error = errno;                                                                       \
    const int result = next arguments;                                                             \
    errno = fault == Fault::None ? errno : error;                                                  \
    return fault == Fault::None ? result : failure;                                                \
  }

// NOLINTEND(bugprone-macro-parentheses)
SKYLINE_FAIL_CLOSE(close, -1, (int file), (file))
SKYLINE_FAIL_CLOSE(fclose, EOF, (FILE * file), (file))

SKYLINE_FAIL(Sync, int, -1, fsync, (int file), (file))
SKYLINE_FAIL(Sync, int, -1, fdatasync, (int file), (file))

SKYLINE_FAIL(Rename, int, -1, rename, (const char* from, const char* to), (from, to))
SKYLINE_FAIL(
  Rename, int, -1, renameat, (int a, const char* from, int b, const char* to), (a, from, b, to))
SKYLINE_FAIL(Rename, int, -1, renameat2,
  (int a, const char* from, int b, const char* to, unsigned int flags), (a, from, b, to, flags))
SKYLINE_FAIL(Rename, int, -1, link, (const char* from, const char* to), (from, to))
SKYLINE_FAIL(Rename, int, -1, linkat, (int a, const char* from, int b, const char* to, int flags),
  (a, from, b, to, flags))

SKYLINE_FAIL(Remove, int, -1, unlink, (const char* path), (path))
SKYLINE_FAIL(
  Remove, int, -1, unlinkat, (int folder, const char* path, int flags), (folder, path, flags))
SKYLINE_FAIL(Remove, int, -1, remove, (const char* path), (path))

SKYLINE_FAIL(Truncate, int, -1, ftruncate, (int file, off_t size), (file, size))
SKYLINE_FAIL(Truncate, int, -1, ftruncate64, (int file, off_t size), (file, size))
SKYLINE_FAIL(Truncate, int, -1, truncate, (const char* path, off_t size), (path, size))
SKYLINE_FAIL(
  Truncate, int, ENOSPC, posix_fallocate, (int file, off_t place, off_t size), (file, place, size))

SKYLINE_FAIL(Status, int, -1, stat, (const char* path, struct stat* status), (path, status))
SKYLINE_FAIL(Status, int, -1, stat64, (const char* path, struct stat64* status), (path, status))
SKYLINE_FAIL(Status, int, -1, lstat, (const char* path, struct stat* status), (path, status))
SKYLINE_FAIL(Status, int, -1, lstat64, (const char* path, struct stat64* status), (path, status))
SKYLINE_FAIL(Status, int, -1, fstat, (int file, struct stat* status), (file, status))
SKYLINE_FAIL(Status, int, -1, fstat64, (int file, struct stat64* status), (file, status))
SKYLINE_FAIL(Status, int, -1, fstatat,
  (int folder, const char* path, struct stat* status, int flags), (folder, path, status, flags))
SKYLINE_FAIL(Status, int, -1, access, (const char* path, int mode), (path, mode))
SKYLINE_FAIL(Status, int, -1, statvfs, (const char* path, struct statvfs* space), (path, space))
SKYLINE_FAIL(Status, char*, nullptr, realpath, (const char* path, char* real), (path, real))
SKYLINE_FAIL(
  Status, ssize_t, -1, readlink, (const char* path, char* to, std::size_t size), (path, to, size))

SKYLINE_FAIL(Folder, DIR*, nullptr, opendir, (const char* path), (path))
SKYLINE_FAIL(Folder, dirent*, nullptr, readdir, (DIR * folder), (folder))
SKYLINE_FAIL(Folder, int, -1, mkdir, (const char* path, mode_t mode), (path, mode))

SKYLINE_FAIL(Mode, int, -1, chmod, (const char* path, mode_t mode), (path, mode))
SKYLINE_FAIL(Mode, int, -1, fchmod, (int file, mode_t mode), (file, mode))
SKYLINE_FAIL(Mode, int, -1, flock, (int file, int operation), (file, operation))

SKYLINE_FAIL(Map, void*, reinterpret_cast<void*>(-1), mmap,
  (void* place, std::size_t size, int protection, int flags, int file, off_t from),
  (place, size, protection, flags, file, from))
SKYLINE_FAIL(Map, void*, reinterpret_cast<void*>(-1), mmap64,
  (void* place, std::size_t size, int protection, int flags, int file, off_t from),
  (place, size, protection, flags, file, from))

SKYLINE_FAIL(Thread, int, EAGAIN, pthread_create,
  (pthread_t * thread, const pthread_attr_t* attributes, void* (*start)(void*), void* data),
  (thread, attributes, start, data))

// Allocations, including those of operator new, which calls malloc. The functions of the C library
// are called by their internal names, because looking up a function allocates memory.
extern "C"
{
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);
  void* __libc_memalign(std::size_t, std::size_t);
}

SKYLINE_INSTEAD_OF(void*, malloc, (std::size_t size))
{
  return NextAllocation(size) == Fault::None ? __libc_malloc(size) : nullptr;
}

SKYLINE_INSTEAD_OF(void*, calloc, (std::size_t count, std::size_t size))
{
  return NextAllocation(count * size) == Fault::None ? __libc_calloc(count, size) : nullptr;
}

SKYLINE_INSTEAD_OF(void*, realloc, (void* place, std::size_t size))
{
  // A realloc to 0 bytes frees the memory and does not fail.
  const bool frees = place && size == 0;
  return frees || NextAllocation(size) == Fault::None ? __libc_realloc(place, size) : nullptr;
}

SKYLINE_INSTEAD_OF(void*, memalign, (std::size_t alignment, std::size_t size))
{
  return NextAllocation(size) == Fault::None ? __libc_memalign(alignment, size) : nullptr;
}

SKYLINE_INSTEAD_OF(void*, aligned_alloc, (std::size_t alignment, std::size_t size))
{
  return NextAllocation(size) == Fault::None ? __libc_memalign(alignment, size) : nullptr;
}

SKYLINE_INSTEAD_OF(int, posix_memalign, (void** place, std::size_t alignment, std::size_t size))
{
  void* const found =
    NextAllocation(size) == Fault::None ? __libc_memalign(alignment, size) : nullptr;
  *place = found ? found : *place;
  return found ? 0 : ENOMEM;
}
